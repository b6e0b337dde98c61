#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "render/reference/visibility.h"
#include "render/volume/by_value.h"
#include "render/volume/match_values.h"
#include "render/volume/suggested_peaks.h"

namespace crest {

/// What is measured of a volume, once.
struct VolumeValues {
  ByValue by_value;
  std::vector<SuggestedPeak> suggested;
  ValueDistribution distribution;
};
/// Nothing when it was stopped.
std::optional<VolumeValues> measure_values(const Volume& volume, const std::stop_token& stop);

/// A picture whose visibility by value is asked for.
struct VisibilitySubject {
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};  ///< a sparse one will do
};

/// The size in which the visibility of a view is measured: of its shape, with some thousand rays.
glm::ivec2 visibility_size(glm::ivec2 view_pixels);

/// What the studio finds out about a volume's values beside the window: the curves by value, once a volume,
/// and the visibility in the present picture, when it is wanted and nothing changes. No call waits.
class WhatMatters {
 public:
  using Clock = std::chrono::steady_clock;
  /// So long after the last change of the picture its visibility is measured.
  static constexpr std::chrono::milliseconds pause{500};

  using VolumeTask = BackgroundTask<std::shared_ptr<const Volume>, VolumeValues>;
  using VisibilityTask = BackgroundTask<VisibilitySubject, Visibility>;
  explicit WhatMatters(
      VolumeTask::Work measure_volume = [](const auto& volume,
                                           const auto& stop) { return measure_values(*volume, stop); },
      VisibilityTask::Work measure_picture =
          [](const auto& subject, const auto& stop) {
            return measure_visibility(subject.scene, subject.camera, subject.size, visibility_bins, stop);
          });

  /// Another volume: what was found of the last one is dropped.
  void set_volume(std::shared_ptr<const Volume> volume);
  /// The picture in the window, where its visibility is wanted. `at_rest`: a measurement may begin.
  void update(std::optional<VisibilitySubject> picture, bool at_rest, Clock::time_point now);
  /// Takes what has come.
  void take();

  bool is_active() const;                      ///< something may come soon
  bool has_news(Clock::time_point now) const;  ///< take() has something, or update() would begin
  const VolumeValues* values() const { return values_ ? &*values_ : nullptr; }  ///< null while not there
  const Visibility* visibility() const;                                         ///< null while there is none
  bool is_visibility_old() const;  ///< of another picture than the present one
  const std::string& why_no_values() const { return why_no_values_; }
  const std::string& why_no_visibility() const { return why_no_visibility_; }

 private:
  bool is_pending() const;

  VolumeTask volume_task_;
  VisibilityTask picture_task_;
  std::optional<VolumeValues> values_;

  std::optional<VisibilitySubject> wanted_;  ///< as update() told last
  std::optional<VisibilitySubject> begun_;   ///< of the measurement that began last
  std::optional<Visibility> visibility_;
  std::optional<VisibilitySubject> shown_;  ///< of visibility_
  Clock::time_point changed_at_;            ///< when `wanted_` came to differ from what it was
  std::string why_no_values_, why_no_visibility_;
};

}  // namespace crest
