#include "render/volume/voxel_store.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace crest {
namespace {

template <class T>
T value_at(std::span<const std::byte> bytes, std::size_t i) {
  T value;
  std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
  return value;
}

bool is_finite(LinearMap map) { return std::isfinite(map.slope) && std::isfinite(map.intercept); }

}  // namespace

bool is_kept_as_stored(ScalarType type) { return is_integer(type) && size_of(type) <= 2; }
std::size_t held_size_of(ScalarType type) { return is_kept_as_stored(type) ? size_of(type) : sizeof(float); }

Voxels::Stored make_stored(ScalarType type, std::size_t count) {
  switch (type) {
    case ScalarType::uint8:
      return std::vector<std::uint8_t>(count);
    case ScalarType::int8:
      return std::vector<std::int8_t>(count);
    case ScalarType::uint16:
      return std::vector<std::uint16_t>(count);
    case ScalarType::int16:
      return std::vector<std::int16_t>(count);
    default:
      return std::vector<float>(count);
  }
}

VoxelStore::VoxelStore(ScalarType type, std::size_t count, std::optional<LinearMap> map) {
  const bool keeps = is_kept_as_stored(type) && map && is_finite(*map);
  stored_ = make_stored(keeps ? type : ScalarType::float32, count);
  if (keeps) map_ = *map;
}

void VoxelStore::put(std::size_t first, std::size_t count, std::span<const std::byte> bytes, ScalarType type,
                     std::size_t stride, LinearMap map) {
  with_scalar_type(type, [&](auto zero) {
    using T = decltype(zero);
    if (auto* floats = std::get_if<std::vector<float>>(&stored_)) {
      float* out = floats->data() + first;
      for (std::size_t i = 0; i < count; ++i) out[i] = mapped_to_float(value_at<T>(bytes, i * stride), map);
    } else if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
      T* out = std::get<std::vector<T>>(stored_).data() + first;
      if (stride == 1)
        std::memcpy(out, bytes.data(), count * sizeof(T));
      else
        for (std::size_t i = 0; i < count; ++i) out[i] = value_at<T>(bytes, i * stride);
    }
  });
}

Rounding put_slice(VoxelStore& store, const GridPart& part, std::uint64_t k, std::span<const std::byte> bytes,
                   ScalarType type, SampleOf sample, LinearMap map) {
  const std::uint64_t whole = part.full.x * part.full.y * sample.count * size_of(type);
  if (sample.index >= sample.count || bytes.size() < whole)
    throw std::out_of_range("put_slice: a slice without the sample that is asked for");
  const glm::u64vec3 dims = part.dims();
  const bool rounds = may_round(type, map);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, dims.y), Rounding(),
      [&](const auto& rows, Rounding lost) {
        for (std::uint64_t j = rows.begin(); j != rows.end(); ++j) {
          const std::uint64_t point = part.first.x + part.full.x * (part.first.y + j * part.stride.y);
          const auto row = bytes.subspan((point * sample.count + sample.index) * size_of(type));
          const std::size_t stride = sample.count * part.stride.x;
          store.put(dims.x * (j + dims.y * k), dims.x, row, type, stride, map);
          if (rounds) lost = joined(lost, rounding_of(row, type, dims.x, stride, map));
        }
        return lost;
      },
      [](const Rounding& a, const Rounding& b) { return joined(a, b); });
}

}  // namespace crest
