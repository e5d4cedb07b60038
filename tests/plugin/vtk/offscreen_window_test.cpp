// SPDX-License-Identifier: MIT
#include "arete/vtk/offscreen_window.h"

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <iostream>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

TEST(offscreen_window, needs_no_display) {
  unsetenv("DISPLAY");
  const OffscreenWindow window(40, 30);
  EXPECT_EQ(window.platform(), "EGL");
  EXPECT_EQ(window.window().GetSize()[0], 40);
  EXPECT_EQ(window.window().GetSize()[1], 30);
}

TEST(offscreen_window, one_follows_the_other) {
  for (int k = 0; k < 3; ++k) {
    const OffscreenWindow window(40, 30);
    window.window().Render();
    EXPECT_EQ(window.platform(), "EGL");
  }
}

/// Ends the process with 0 when the window is refused with advice.
[[noreturn]] void open_without_egl(const char* display) {
  // GLVND reads its list of drivers once, so this has to be a process that has not used EGL yet.
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
  if (display == nullptr) {
    unsetenv("DISPLAY");
  } else {
    setenv("DISPLAY", display, 1);
  }
  try {
    const OffscreenWindow window(40, 30);
    std::cerr << "opened on " << window.platform();
  } catch (const RenderError& error) {
    const bool advises = std::string(error.what()).find("libegl1") != std::string::npos;
    std::cerr << (advises ? "advised" : error.what());
    std::exit(advises ? 0 : 1);
  }
  std::exit(2);
}

TEST(offscreen_window_death_test, without_egl_and_without_x_there_is_advice_and_no_crash) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(open_without_egl(nullptr), testing::ExitedWithCode(0), "^advised$");
  EXPECT_EXIT(open_without_egl(":7654"), testing::ExitedWithCode(0), "^advised$");
}

}  // namespace
}  // namespace arete::vtk
