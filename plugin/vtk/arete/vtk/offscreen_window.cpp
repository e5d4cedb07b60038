// SPDX-License-Identifier: MIT
#include "arete/vtk/offscreen_window.h"

#include <dlfcn.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/complaints.h"
#include "arete/vtk/internal/egl_context.h"

namespace arete::vtk {
namespace {

/// VTK's X window aborts without a server, so ask first. Xlib itself is there if VTK was built for
/// X at all, since VTK links it; naming it here would make it a dependency of this library.
bool x_server_answers() {
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(dlsym(RTLD_DEFAULT, "XCloseDisplay"));
  if (open == nullptr || close == nullptr) return false;
  void* display = open(nullptr);
  if (display == nullptr) return false;
  close(display);
  return true;
}

/// VTK's generic window asks its owner whether the context is current; here it always is.
void answer_current(vtkObject*, unsigned long, void*, void* answer) {
  *static_cast<bool*>(answer) = true;
}

vtkSmartPointer<vtkRenderWindow> window_on_current_context(Complaints& complaints) {
  auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  vtkNew<vtkCallbackCommand> current;
  current->SetCallback(answer_current);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, current);
  window->SetReadyForRendering(true);
  window->SetOffScreenRendering(1);
  // GLEW is built for GLX and complains, twice, before it goes on to work with EGL all the same.
  complaints.watch(*window);
  window->InitializeFromCurrentContext();
  return window;
}

}  // namespace

struct OffscreenWindow::State {
  // Both outlive the window that draws on the one and complains to the other.
  EglContext context;
  Complaints complaints;
  vtkSmartPointer<vtkRenderWindow> window;
  std::string platform;
};

OffscreenWindow::OffscreenWindow(int width, int height) : state_(std::make_unique<State>()) {
  if (state_->context.valid()) {
    state_->window = window_on_current_context(state_->complaints);
    state_->platform = "EGL";
  } else if (x_server_answers()) {
    state_->window = vtkSmartPointer<vtkRenderWindow>::New();
    state_->window->SetOffScreenRendering(1);
    state_->platform = "X";
  } else {
    throw RenderError(
        "no OpenGL without a display, and no X server either; install EGL and Mesa (on Debian: "
        "apt-get install libegl1 libgl1-mesa-dri), or run under xvfb-run");
  }
  state_->window->SetMultiSamples(0);  // on a software renderer dearer than drawing larger
  state_->window->SetDPI(72);          // one point of text is one pixel
  state_->window->SetSize(width, height);
}

OffscreenWindow::~OffscreenWindow() = default;

vtkRenderWindow& OffscreenWindow::window() const { return *state_->window; }

const std::string& OffscreenWindow::platform() const { return state_->platform; }

}  // namespace arete::vtk
