#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "render/volume/linear_map.h"

namespace crest {

/// The values of a grid's points, each a float32, in no more bytes than their file has: integers of 8 and 16
/// bits stay as they were stored, and are mapped when they are read. The mapped value is rounded once. Copies
/// share what is stored, until one of them is changed.
class Voxels {
 public:
  using Stored = std::variant<std::vector<float>, std::vector<std::uint8_t>, std::vector<std::int8_t>,
                              std::vector<std::uint16_t>, std::vector<std::int16_t>>;

  Voxels() : Voxels(std::vector<float>()) {}
  Voxels(std::vector<float> values) : stored_(std::make_shared<Stored>(std::move(values))) {}
  /// Of floats the map must be the identity.
  Voxels(Stored stored, LinearMap map);
  Voxels(const Voxels&) = default;  // as moving does, so that what was moved from is still one
  Voxels& operator=(const Voxels&) = default;
  ~Voxels() = default;

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  std::size_t byte_count() const;
  float operator[](std::size_t index) const {
    return std::visit([&](const auto& stored) { return mapped_to_float(stored[index], map_); }, *stored_);
  }
  /// The values from `first` on, to be read before the next call with this `room`.
  std::span<const float> part(std::size_t first, std::size_t count, std::vector<float>& room) const;

  const Stored& stored() const { return *stored_; }
  LinearMap map() const { return map_; }
  const void* data() const;  ///< of what is stored
  bool are_floats() const { return std::holds_alternative<std::vector<float>>(*stored_); }
  std::vector<float> to_floats() const;
  /// For those who change them: from now on they are stored so, apart from all copies.
  std::vector<float>& floats();

  bool operator==(const Voxels& other) const;  ///< by value; NaN equals nothing

 private:
  std::shared_ptr<Stored> stored_;  ///< never null; of several owners nobody changes it
  LinearMap map_;
};

}  // namespace crest
