#pragma once

#include <optional>

#include "presets/fields.h"
#include "ui/theme.h"

namespace crest {

/// What a person chooses once, for all documents.
struct StudioSettings {
  Theme theme = Theme::dark;
  std::optional<double> scale;    ///< of texts and controls, in scale_range; without it, the monitor's
  bool data_values = true;        ///< the editor shows values of the volume, for normalized TFs too
  bool large_peak_table = false;  ///< else it is small, beside the list of peaks
  bool operator==(const StudioSettings&) const = default;
};

/// Of StudioSettings::scale.
inline constexpr FieldRule scale_rule{.min = 0.75, .max = 3};

}  // namespace crest
