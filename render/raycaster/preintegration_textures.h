#pragma once

#include "render/classify/antiderivatives.h"
#include "render/classify/preintegration_table.h"
#include "render/gl/handle.h"

namespace crest {

/// Antiderivatives on the GPU: 2D, RGBA32F, an entry a row of its four members.
struct AntiderivativesTexture {
  gl::TextureHandle texture;
  ValueRange range;
  int stretches = 0;
};
AntiderivativesTexture upload_antiderivatives(const Antiderivatives& table);

/// The pre-integration table on the GPU: 2D, RGBA32F, front value across, back value up; the first and the
/// last texel's centres are the range's ends.
struct PreintegrationTexture {
  gl::TextureHandle texture;
  ValueRange range;
  double length = 0;
  int bins = 0;
};
PreintegrationTexture upload_preintegration_table(const PreintegrationTable& table);

}  // namespace crest
