#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/view_renderer.h"
#include "render/gl/pending_read.h"
#include "ui/comparison.h"

namespace crest {

/// The difference of the two pictures that are compared, when both are done: drawn once, and measured once,
/// both by the device. Nothing waits for it: the numbers come later than the picture. What fails is not tried
/// again until the pair changes.
class ViewDifference {
 public:
  /// `measures`: else no measurement is begun. Throws Error where the driver fails.
  void update(const ViewRenderer& views, const Comparison& comparison, bool measures = true);
  void clear();
  bool is_busy() const { return measuring_.has_value(); }  ///< numbers are on their way
  DifferencePicture picture() const;

 private:
  struct Subject {
    std::uint64_t version = 0, other_version = 0;
    int view = 0;
    double amplification = 0;
    bool with_sign = false;
    bool operator==(const Subject&) const = default;
    bool is_same_pair(const Subject& other) const {
      return version == other.version && other_version == other.other_version && view == other.view;
    }
  };

  /// The sums of the blocks of asked_, on their way.
  struct Measuring {
    double pixels;
    gl::PendingRead sums;
  };
  void take_numbers();
  void forget();

  std::optional<gl::Presenter> presenter_;
  std::unique_ptr<gl::DisplayTexture> display_;
  Subject shown_;
  std::optional<Subject> asked_;  ///< the pair whose numbers were asked for last
  bool has_numbers_ = false;      ///< of asked_
  std::optional<Measuring> measuring_;
  DifferencePicture picture_;
};

}  // namespace crest
