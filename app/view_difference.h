#pragma once

#include <cstdint>
#include <memory>

#include "app/view_renderer.h"
#include "render/gl/pending_read.h"
#include "ui/comparison.h"

namespace crest {

/// The difference of the two pictures that are compared, when both are done: drawn once, and measured once,
/// both by the device. Nothing waits for it: until the numbers are there, those of an earlier pair stay.
class ViewDifference {
 public:
  /// `measures`: else no measurement is begun.
  void update(const ViewRenderer& views, const Comparison& comparison, bool measures = true);
  void clear();
  bool is_busy() const { return measuring_.has_value(); }  ///< numbers are on their way
  DifferencePicture picture() const { return picture_; }

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

  /// The sums of a pair's blocks, on their way.
  struct Measuring {
    Subject subject;
    double pixels;
    gl::PendingRead sums;
  };
  void take_numbers();

  std::optional<gl::Presenter> presenter_;
  std::unique_ptr<gl::DisplayTexture> display_;
  Subject shown_, measured_;
  std::optional<Measuring> measuring_;
  DifferencePicture picture_;
};

}  // namespace crest
