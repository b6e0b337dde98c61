#pragma once

#include <memory>
#include <string>
#include <vector>

namespace crest {

/// A current GL 4.5 core context without a window or a display, until it dies.
class OffscreenContext {
 public:
  /// `device` is an index into list_devices(), or -1 for the first that works: hardware first. A `debug`
  /// context tells what it is used wrongly for (glDebugMessageCallback). Throws Error.
  explicit OffscreenContext(int device = -1, bool debug = false);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  std::string renderer() const;  ///< as the driver names itself

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// The EGL devices of this machine, hardware first.
std::vector<std::string> list_devices();

}  // namespace crest
