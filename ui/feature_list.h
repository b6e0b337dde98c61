#pragma once

#include <string>
#include <vector>

#include "ui/studio_state.h"

namespace crest {

/// A row of the list: "volume" - "64x64x64 points, 1 MiB".
struct FeatureRow {
  std::string name, text;
  bool is_in = true;  ///< else it was left out
};
/// What a picture is made of, what it cannot show, what the device holds for it, and what was left out: a row
/// for each reason.
std::vector<FeatureRow> feature_rows(const PictureNeed& need);

/// The list of one view's picture, under a header that opens and closes.
void feature_list(StudioState& state, const StudioInputs& inputs, Mode preset_mode);

}  // namespace crest
