#pragma once

#include <optional>
#include <string>

#include "app/what_matters.h"

namespace crest {

/// What a volume leaves when another one is opened: the TF that was made for it, to be carried over.
struct LastVolume {
  std::string name;
  TransferFunction tf;  ///< in data values
  ValueRange range;
  std::string source;  ///< to be read again
  glm::ivec3 dims{0};
  std::optional<ValueDistribution> distribution;  ///< where it was measured

  /// The TF for a volume of this range, in the domain that is asked for. By histogram only where the values
  /// of both volumes are measured.
  TransferFunction carried_to(ValueRange to, const VolumeValues* values, CarryBy by, Domain domain) const;
};

/// `values`: null where they are not measured.
LastVolume last_volume(const Volume& volume, const std::string& source, const TransferFunction& tf,
                       const VolumeValues* values);

}  // namespace crest
