#pragma once

#include <mutex>

namespace crest {

/// Sends stderr to /dev/null for as long as this lives: GDCM and OpenImageIO's libraries each
/// print on it in a way of their own. One thread at a time; the others wait.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::unique_lock<std::mutex> turn_;
  int kept_;  ///< where stderr went before
};

}  // namespace crest
