#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "presets/json_text.h"

namespace crest {

/// Colours as "#rrggbb": of error_scale() (render/scene/error_colors.h); then that of
/// pixels which show nothing in both pictures, and that of grazing pixels.
struct ErrorColors {
  std::vector<std::string> scale;
  std::string not_compared, grazing;
};
ErrorColors error_colors();
/// The scale as web/pictures.js draws it.
Json error_scale_json();

/// `image` against the exact picture, in those colours.
Image error_picture(const Reference& exact, const Image& image);

/// File names below the report's folder.
std::string picture_name(const Measurement& point);
std::string error_picture_name(const Measurement& point, const ExactAnswer& answer);
std::string exact_picture_name(const ExactAnswer& answer);
std::string difference_picture_name(const ExactAnswer& answer);

/// Writes all pictures of a report below `folder` and returns their names. Throws Error.
std::vector<std::string> write_pictures(const Report& report, const std::filesystem::path& folder);

}  // namespace crest
