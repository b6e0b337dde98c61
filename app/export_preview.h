#pragma once

#include <memory>

#include "presets/exchange/exporters.h"
#include "render/files/image.h"
#include "render/renderer.h"

namespace crest {

/// A preset as it is drawn here, and as the target of an export draws it.
struct ExportPreview {
  Image here, there;
  double rmse = 0;   ///< over the four channels of all pixels where either shows something
  double max = 0;    ///< the largest difference of a pixel
  double share = 0;  ///< of those pixels, those off by more than 1/255
};

/// A preset in a volume's units, at once.
Image draw_preset(Renderer& renderer, const Preset& preset, const std::shared_ptr<const Volume>& volume,
                  const Camera& camera, glm::ivec2 size);

ExportPreview compare_export(Image here, Image there);

/// Both and their difference side by side, labelled. The difference is brightened until it is plain to see,
/// by a power of two that stands on it.
Image picture_of(const ExportPreview& preview, std::string_view target, glm::vec3 background);

}  // namespace crest
