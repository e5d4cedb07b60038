// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

class vtkRenderWindow;

namespace arete::vtk {

/// A VTK render window that needs no display. First an EGL context without any surface, on Mesa's
/// surfaceless platform or on an EGL device (drivers of graphics cards); if there is none and the X
/// server that $DISPLAY names can be reached, VTK's own window, kept off the screen.
///
/// Neither Debian's VTK nor ParaView's is built with EGL or OSMesa windows, and VTK's X window
/// aborts the program when it meets no X server; hence this class.
/// Stays in its thread, where its context is current as long as it lives; an OpenGL context that
/// was current there before is not made so again.
class OffscreenWindow {
 public:
  /// \throws RenderError when neither way works; the message says what to install.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  [[nodiscard]] vtkRenderWindow& window() const;
  /// "EGL" or "X".
  [[nodiscard]] const std::string& platform() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace arete::vtk
