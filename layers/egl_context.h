// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mesecina {

/// An OpenGL context of at least version 3.3 without any window or display, by EGL. It is current in no thread but
/// between make_current() and release(), which belong into one thread.
class Egl_context {
 public:
  /// Throws std::runtime_error with what is missing. Takes some milliseconds.
  Egl_context();
  ~Egl_context();
  Egl_context(const Egl_context&) = delete;
  Egl_context& operator=(const Egl_context&) = delete;

  /// Throws std::runtime_error when that fails.
  void make_current();
  void release();

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace mesecina
