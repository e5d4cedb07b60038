// SPDX-License-Identifier: MIT
#pragma once

namespace arete::vtk {

/// An OpenGL 3.2 context without any surface, current in this thread as long as the object lives;
/// invalid when EGL has none to give. What was current before is not made so again. The display is
/// never terminated: EGL shares it with whoever else uses it in this process.
class EglContext {
 public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  [[nodiscard]] bool valid() const { return context_ != nullptr; }

 private:
  void* display_ = nullptr;  // EGLDisplay and EGLContext are pointers to anything
  void* context_ = nullptr;
};

}  // namespace arete::vtk
