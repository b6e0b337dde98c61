#include "render/files/raw_slice.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

#include "presets/error.h"
#include "render/volume/convert.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

constexpr std::uint64_t longest_row = std::uint64_t(16) << 20;  ///< in bytes

/// Which of `count` places the i-th of `kept` is.
std::int64_t spread(int i, int kept, int count) { return (2 * std::int64_t(i) + 1) * count / (2 * kept); }

struct Values {
  glm::ivec2 size;
  std::vector<float> values;
  std::vector<bool> is_there;
};

Values read_rows(std::ifstream& file, const RawLayout& layout, std::uint64_t first, std::uint64_t row_bytes,
                 glm::ivec2 size) {
  const std::size_t value_size = size_of(layout.type);
  const bool swaps = layout.big_endian != (std::endian::native == std::endian::big);
  Values slice{size, std::vector<float>(std::size_t(size.x) * std::size_t(size.y)), {}};
  slice.is_there.resize(slice.values.size());
  std::vector<std::byte> bytes(row_bytes);
  std::vector<float> row(std::size_t(layout.size.x));
  for (int y = 0; y < size.y; ++y) {
    file.clear();
    file.seekg(std::streamoff(first + std::uint64_t(spread(y, size.y, layout.size.y)) * row_bytes));
    file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    const std::size_t there = std::size_t(std::max<std::streamsize>(file.gcount(), 0)) / value_size;
    const auto part = std::span(bytes).first(there * value_size);
    if (swaps) swap_bytes(part, value_size);
    convert_to_float(part, layout.type, 1, std::span(row).first(there));
    for (int x = 0; x < size.x; ++x) {
      const auto from = std::size_t(spread(x, size.x, layout.size.x));
      const std::size_t to = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
      slice.is_there[to] = from < there;
      slice.values[to] = from < there ? row[from] : 0;
    }
  }
  return slice;
}

RawSlice as_grey(const Values& from) {
  RawSlice slice{from.size, std::vector<std::uint8_t>(from.values.size()), from.is_there, {0, 0}};
  bool any = false;
  const auto counts = [&](std::size_t i) { return from.is_there[i] && std::isfinite(from.values[i]); };
  for (std::size_t i = 0; i < from.values.size(); ++i) {
    if (!counts(i)) continue;
    const double value = from.values[i];
    slice.range = any ? ValueRange{std::min(slice.range.min, value), std::max(slice.range.max, value)}
                      : ValueRange{value, value};
    any = true;
  }
  const double width = slice.range.max - slice.range.min;
  for (std::size_t i = 0; i < from.values.size(); ++i)
    if (counts(i) && width > 0)
      slice.grey[i] = std::uint8_t(std::lround(255 * ((double(from.values[i]) - slice.range.min) / width)));
  return slice;
}

}  // namespace

RawSlice read_middle_slice(const std::filesystem::path& path, const RawLayout& layout, int most) {
  for (int i = 0; i < 3; ++i)
    if (layout.size[i] < 1) throw Error("The middle slice, once there is a size");
  const auto axis = [&](int i) { return std::uint64_t(layout.size[i]); };
  const auto row_bytes = checked_product(axis(0), size_of(layout.type));
  const auto slice_bytes = row_bytes ? checked_product(*row_bytes, axis(1)) : std::nullopt;
  const auto before = slice_bytes ? checked_product(*slice_bytes, axis(2) / 2) : std::nullopt;
  if (!before || *row_bytes > longest_row || *before > std::uint64_t(1) << 60 ||
      layout.offset > std::uint64_t(1) << 60)
    throw Error(fmt::format("{} points on a row are too many for a preview", axis(0)));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(fmt::format("{}: it cannot be read", path.string()));
  const glm::ivec2 size(std::min<int>(int(axis(0)), most), std::min<int>(int(axis(1)), most));
  return as_grey(read_rows(file, layout, layout.offset + *before, *row_bytes, size));
}

}  // namespace crest
