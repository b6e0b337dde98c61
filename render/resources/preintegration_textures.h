#pragma once

#include "render/classify/antiderivatives.h"
#include "render/classify/preintegration_table.h"
#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"

namespace crest {

// All values here are in the volume's stored units (stored_units.h), in which the GPU has them; TFs are
// resolved.

/// Antiderivatives on the GPU: 2D, RGBA32F, an entry a row of its four members.
struct AntiderivativesTexture {
  gl::TextureHandle texture;
  ValueRange range;
  int bins = 0;
};
const AntiderivativesTexture& antiderivatives_texture(KeyedCache& held, const TransferFunction& tf,
                                                      ValueRange field, double smallest_spacing, int bins);

/// The pre-integration table on the GPU: 2D, RGBA32F, front value across, back value up; the first and the
/// last texel's centres are the range's ends.
struct PreintegrationTexture {
  gl::TextureHandle texture;
  ValueRange range;
  double length = 0;
  int bins = 0;
};
/// `length` is that of all segments, in smallest spacings.
const PreintegrationTexture& preintegration_texture(KeyedCache& held, const TransferFunction& tf,
                                                    ValueRange field, double smallest_spacing, double length,
                                                    int bins);

}  // namespace crest
