#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ui/studio.h"

namespace crest {

/// How live the window is: the time of each frame while a mouse button is held, what the processors spend on
/// it (without a graphics card, that is all of its work, whatever else the machine does), and how long each
/// view takes from an edit until it shows it.
class FrameLog {
 public:
  using Clock = std::chrono::steady_clock;

  void add_frame(double ms, double processor_ms) {
    frame_ms_.push_back(ms);
    processor_ms_.push_back(processor_ms);
  }
  /// Tells what each view wants and shows, at the end of each frame; an edit counts from the beginning of the
  /// frame that first wants it.
  void add_versions(Clock::time_point frame_begin, const std::array<std::uint64_t, picture_count>& wanted,
                    const std::array<std::uint64_t, picture_count>& shown);

  /// Count, median, 95th percentile and maximum, as JSON.
  std::string summary() const;

 private:
  std::vector<double> frame_ms_, processor_ms_;
  std::array<std::map<std::uint64_t, Clock::time_point>, view_count> waiting_;
  std::array<std::uint64_t, view_count> last_wanted_{};
  std::array<std::vector<double>, view_count> latency_ms_;
};

}  // namespace crest
