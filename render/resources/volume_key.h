#pragma once

#include <memory>

#include "render/volume/volume.h"

namespace crest {

/// A volume as a part of a key: by identity, without keeping it alive.
class VolumeKey {
 public:
  explicit VolumeKey(const std::shared_ptr<const Volume>& volume) : volume_(volume) {}
  bool operator==(const VolumeKey& other) const {
    return !volume_.owner_before(other.volume_) && !other.volume_.owner_before(volume_);
  }
  bool is_stale() const { return volume_.expired(); }

 private:
  std::weak_ptr<const Volume> volume_;
};

}  // namespace crest
