#pragma once

#include <cstdint>
#include <memory>

#include "app/view_renderer.h"
#include "ui/comparison.h"

namespace crest {

/// The difference of the two pictures that are compared, when both are done: drawn once, and measured once.
class ViewDifference {
 public:
  /// `measures`: else the numbers are of an earlier pair, since pictures are read back for them.
  void update(const ViewRenderer& views, const Comparison& comparison, bool measures = true);
  void clear();
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

  std::optional<gl::Presenter> presenter_;
  std::unique_ptr<gl::DisplayTexture> display_;
  Subject shown_, measured_;
  DifferencePicture picture_;
};

}  // namespace crest
