#include "app/offscreen_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "app/room_to_draw.h"
#include "presets/error.h"

namespace crest {
namespace {

struct Device {
  EGLDeviceEXT device;
  std::string name;
  bool is_software;
};

/// Whether EGL itself has an extension. libepoxy ends the program where there is no libEGL, or where a
/// function is called that nobody provides: each call must be behind this question.
bool has_extension(const char* name) {
  static const bool has_egl = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL) != nullptr;
  return has_egl && epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

EGLDisplay platform_display(EGLenum platform, void* native) {
  if (!has_extension("EGL_EXT_platform_base")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(platform, native, nullptr);
}

std::vector<Device> find_devices() {
  std::vector<Device> devices;
  if (!has_extension("EGL_EXT_device_enumeration") && !has_extension("EGL_EXT_device_base")) return devices;
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return devices;
  std::vector<EGLDeviceEXT> found{std::size_t(count)};
  eglQueryDevicesEXT(count, found.data(), &count);
  for (EGLDeviceEXT device : found) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    const std::string_view text = extensions ? extensions : "";
    const bool software = text.find("EGL_MESA_device_software") != text.npos;
    const char* file = text.find("EGL_EXT_device_drm") != text.npos
                           ? eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT)
                           : nullptr;
    devices.push_back({device, file ? file : software ? "software (Mesa)" : "GPU", software});
  }
  std::ranges::stable_partition(devices, [](const Device& d) { return !d.is_software; });
  return devices;
}

/// The context on one display, made current; null when the display cannot give it. All contexts of a device
/// have one display, also in other threads, and eglTerminate() does not count them: it ends with the program.
EGLContext make_current_context(EGLDisplay display, bool debug) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
  eglBindAPI(EGL_OPENGL_API);
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_FLAGS_KHR,
                               debug ? EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : 0,
                               EGL_NONE};
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    return context;
  if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

}  // namespace

OffscreenContext::OffscreenContext(int device, bool debug) {
  require_room_to_draw();
  const auto devices = find_devices();
  if (device >= int(devices.size()))
    throw Error(fmt::format("--device {}: there are {} graphics devices (crest list devices)", device,
                            devices.size()));
  for (int i = 0; i < int(devices.size()) && !context_; ++i) {
    if (device >= 0 && i != device) continue;
    display_ = platform_display(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)].device);
    context_ = make_current_context(display_, debug);
  }
  if (!context_ && device < 0) {
    display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
    context_ = make_current_context(display_, debug);
  }
  if (!context_)
    throw Error(
        "no graphics driver here gives an OpenGL 4.5 core context (on Debian: apt-get install "
        "libgl1-mesa-dri)");
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

std::string OffscreenContext::renderer() const {
  return fmt::format("{}, OpenGL {}", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
                     reinterpret_cast<const char*>(glGetString(GL_VERSION)));
}

std::vector<std::string> list_devices() {
  std::vector<std::string> names;
  for (const Device& device : find_devices()) names.push_back(device.name);
  return names;
}

}  // namespace crest
