#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "render/classify/classification.h"
#include "render/classify/tf_table.h"
#include "render/scene/picture_need.h"
#include "render/shader_inputs/features.h"
#include "render/volume/volume.h"

namespace crest {

/// All that a picture is made from: the shader's variant, the tables, the textures and the passes.
struct Need {
  bool visible = false;  ///< else the picture is empty, and nothing is drawn
  Features features;     ///< of the shader
  Features needed;       ///< the same, but for those that were forced in
  FeatureList list;
  TfTableSize tf_table;                     ///< where features.dvr; antiderivatives have as many nodes
  TableBlur tf_blur;                        ///< of its table
  int preintegration_bins = 0;              ///< of the pre-integration table on each axis, where there is one
  double longest_step = 0;                  ///< between two samples next to each other, in smallest spacings
  std::size_t texel_bytes = sizeof(float);  ///< that the device holds of a point
  std::size_t brick_count = 0;              ///< of the volume, where features.bricks
  int peak_bins = 0;                        ///< of the peak table's arrays, where there is one
  /// Intervals of the longest ray, and how many of them a pass renders: some drivers end long loops in
  /// silence. Where features.analytic, one is a smallest spacing long.
  int intervals = 0, intervals_per_pass = 1;

  /// Whether nothing has to be drawn.
  bool is_empty() const;
  int passes() const;
};

/// What is put in although nobody needs it, to be measured and tested: the picture stays the same. A feature
/// that would change the picture is not forced in.
struct Forced {
  Features features;           ///< the placement is not looked at
  bool large_tables = false;   ///< tables as large as they may be
  int intervals_per_pass = 0;  ///< at most; 0 = as many as drivers allow
};

/// The share of the macrocells that may show something of these features; `blur` as in Shown (occupancy.h).
using OccupiedShare = std::function<double(const Features& features, const TableBlur& blur)>;

/// How far the weights of the texture unit's filter may be off (gl/filter_weights.h).
using WeightError = std::function<double()>;

/// The one function that decides, from the volume's grid and statistics, the TF's peaks, the settings, the
/// camera with its picture's size, and whether costs are to be counted. It takes O(points of the TF) and some
/// microseconds, and what `occupied_share` and `weight_error` take, where they are asked; without the former
/// nothing is skipped, without the latter the texture unit filters in float. `in_bricks`: the device holds of
/// the volume what shows. Throws Error for a camera that
/// has no picture, and for settings that do not go together.
Need find_need(const Volume& volume, const Classification& classification, const Rendering& rendering,
               const Camera& camera, glm::ivec2 size, bool statistics, const Forced& forced = {},
               const OccupiedShare& occupied_share = {}, const WeightError& weight_error = {},
               bool in_bricks = false);

/// What a device holds for it.
std::vector<GpuData> gpu_data(const Need& need, const Volume& volume, const Classification& classification);

}  // namespace crest
