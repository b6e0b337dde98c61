#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crest {

/// For people: what is in a picture, and what was left out of it, with the reason.
struct FeatureList {
  std::vector<std::string> in;
  std::vector<std::pair<std::string, std::string>> left_out;
  std::vector<std::string> notes;  ///< what the picture cannot show as it is
  bool operator==(const FeatureList&) const = default;
};

/// What the graphics device holds for a picture.
struct GpuData {
  std::string name, size;  ///< "transfer_function", "641 entries"
  std::size_t bytes = 0;
  bool operator==(const GpuData&) const = default;
};

/// What a picture is made from, what was left out, and what the graphics device holds for it, whichever
/// engine makes it.
struct PictureNeed {
  FeatureList features;
  std::vector<GpuData> gpu_data;
  std::optional<double> tf_error;  ///< of the TF's table, where there is one (TfTableSize::error)
  bool operator==(const PictureNeed&) const = default;
};

}  // namespace crest
