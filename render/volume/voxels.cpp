#include "render/volume/voxels.h"

#include <algorithm>
#include <utility>

namespace crest {

Voxels::Voxels(Stored stored, LinearMap map)
    : stored_(std::make_shared<Stored>(std::move(stored))), map_(map) {}

std::size_t Voxels::size() const {
  return std::visit([](const auto& stored) { return stored.size(); }, *stored_);
}

std::size_t Voxels::byte_count() const {
  return std::visit([](const auto& stored) { return std::as_bytes(std::span(stored)).size(); }, *stored_);
}

const void* Voxels::data() const {
  return std::visit([](const auto& stored) { return static_cast<const void*>(stored.data()); }, *stored_);
}

std::span<const float> Voxels::part(std::size_t first, std::size_t count, std::vector<float>& room) const {
  if (const auto* floats = std::get_if<std::vector<float>>(stored_.get()))
    return std::span(*floats).subspan(first, count);
  room.resize(count);
  std::visit(
      [&, map = map_](const auto& stored) {
        for (std::size_t i = 0; i < count; ++i) room[i] = mapped_to_float(stored[first + i], map);
      },
      *stored_);
  return room;
}

std::vector<float> Voxels::to_floats() const {
  std::vector<float> room;
  const std::span<const float> values = part(0, size(), room);
  return are_floats() ? std::vector<float>(values.begin(), values.end()) : room;
}

std::vector<float>& Voxels::floats() {
  if (!are_floats() || stored_.use_count() > 1) *this = to_floats();
  return std::get<std::vector<float>>(*stored_);
}

bool Voxels::operator==(const Voxels& other) const {
  if (map_ == other.map_ && stored_->index() == other.stored_->index()) return *stored_ == *other.stored_;
  if (size() != other.size()) return false;
  for (std::size_t i = 0; i < size(); ++i)
    if ((*this)[i] != other[i]) return false;
  return true;
}

}  // namespace crest
