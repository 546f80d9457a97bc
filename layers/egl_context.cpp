// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/egl_context.h"

#include <epoxy/egl.h>

#include <array>
#include <stdexcept>

namespace mesecina {

namespace {

/// An initialized display without a screen; null when there is none.
EGLDisplay open_display() {
  const auto initialized = [](EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
  };
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
      if (EGLDisplay display =
              initialized(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
        return display;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
      std::array<EGLDeviceEXT, 16> devices{};
      EGLint count = 0;
      eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
      for (int i = 0; i < count; ++i)
        if (EGLDisplay display = initialized(
                eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr)))
          return display;
    }
  }
  return initialized(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

}  // namespace

Egl_context::Egl_context() {
  if (!epoxy_has_egl()) throw std::runtime_error("there is no EGL (package libegl1)");
  display_ = open_display();
  if (!display_) throw std::runtime_error("EGL finds nothing to draw with (package libegl-mesa0 draws on any machine)");
  const auto fail = [this](const char* reason) {
    eglTerminate(display_);
    throw std::runtime_error(reason);
  };
  if (!epoxy_has_egl_extension(display_, "EGL_KHR_surfaceless_context")) fail("this EGL cannot draw without a window");
  if (!eglBindAPI(EGL_OPENGL_API)) fail("this EGL has no OpenGL");
  constexpr std::array config_wishes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display_, config_wishes.data(), &config, 1, &count);
  constexpr std::array context_wishes{
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  context_ = eglCreateContext(display_, count > 0 ? config : nullptr, EGL_NO_CONTEXT, context_wishes.data());
  if (!context_) fail("EGL makes no context of OpenGL 3.3");
}

Egl_context::~Egl_context() {
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

void Egl_context::make_current() {
  // The choice of OpenGL holds for one thread.
  if (!eglBindAPI(EGL_OPENGL_API) || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    throw std::runtime_error("the context that EGL made cannot be used");
}

void Egl_context::release() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

}  // namespace mesecina
