#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "render/scene/scene.h"
#include "render/studies/random/dice.h"

namespace crest {

/// Noise, waves, shells, labels, ...: 16 to 40 points an axis.
struct FieldKind {
  std::string_view name;
  std::shared_ptr<const Volume> (*make)(Dice& dice);
  bool labels = false;  ///< whole numbers from 0 to 4, each of which is there
};
std::span<const FieldKind> field_kinds();  // fields.cpp

/// Steps, spikes, plateaus, ...: resolved, with at least one surface. Of labels they lie at some of the
/// labels' values, or between them.
struct FeatureKind {
  std::string_view name;
  TransferFunction (*make)(Dice& dice, const Volume& volume, bool labels);
};
std::span<const FeatureKind> feature_kinds();  // features.cpp

/// From outside, inside, along a face, ...
struct ViewKind {
  std::string_view name;
  Camera (*make)(Dice& dice, const Grid& grid);
};
std::span<const ViewKind> view_kinds();  // views.cpp

}  // namespace crest
