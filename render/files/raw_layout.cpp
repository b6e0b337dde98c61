#include "render/files/raw_layout.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>

#include "presets/number_text.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

constexpr std::array types{ScalarType::uint8,   ScalarType::int8,   ScalarType::uint16, ScalarType::int16,
                           ScalarType::uint32,  ScalarType::int32,  ScalarType::uint64, ScalarType::int64,
                           ScalarType::float32, ScalarType::float64};

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
  std::string text = fmt::format("{}", number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string size_text(glm::ivec3 size) { return fmt::format("{} x {} x {}", size.x, size.y, size.z); }

/// Nothing where it is more than 64 bits hold.
std::optional<std::uint64_t> bytes_of(const RawLayout& layout) {
  std::optional<std::uint64_t> bytes = size_of(layout.type);
  for (int axis = 0; axis < 3 && bytes; ++axis)
    bytes = checked_product(*bytes, std::uint64_t(std::max(layout.size[axis], 0)));
  return bytes;
}

std::string count_text(std::uint64_t held, std::uint64_t promised) {
  if (held == promised) return "it fits";
  return fmt::format("{} too {}", grouped(held > promised ? held - promised : promised - held),
                     held > promised ? "many" : "few");
}

/// With the depth that takes what is there, and with what is too much taken for a header.
std::vector<RawLayout> mends_of(const RawLayout& layout, std::uint64_t bytes, std::uint64_t file_bytes) {
  std::vector<RawLayout> mends;
  const std::uint64_t held = file_bytes - layout.offset;
  const std::uint64_t slice = bytes / std::uint64_t(layout.size.z);
  if (const std::uint64_t depth = held / slice;
      held % slice == 0 && depth >= 2 && depth <= std::uint64_t(std::numeric_limits<int>::max())) {
    mends.push_back(layout);
    mends.back().size.z = int(depth);
  }
  if (bytes < file_bytes) {
    mends.push_back(layout);
    mends.back().offset = file_bytes - bytes;
  }
  return mends;
}

}  // namespace

std::optional<glm::u64vec3> raw_size(std::string_view text) {
  const auto parts = split(text, 'x');
  if (parts.size() != 3) return std::nullopt;
  glm::u64vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    const auto points = to_integer(parts[std::size_t(axis)]);
    if (!points || *points < 0) return std::nullopt;
    size[axis] = std::uint64_t(*points);
  }
  return size;
}

std::optional<ScalarType> raw_type(std::string_view text) {
  for (const ScalarType type : types)
    if (text == name_of(type)) return type;
  return std::nullopt;
}

Query query_from_name(const std::string& stem) {
  const auto parts = split(stem, '_');
  if (parts.size() < 2) return {};
  const std::string_view size = parts[parts.size() - 2], type = parts.back();
  if (!raw_size(size) || !raw_type(type)) return {};
  return {{"size", std::string(size)}, {"type", std::string(type)}};
}

RawLayout layout_of(const Query& query) {
  RawLayout layout;
  const auto text = [&](std::string_view key) -> std::string_view {
    const auto found = query.find(key);
    return found == query.end() ? std::string_view() : std::string_view(found->second);
  };
  if (const auto size = raw_size(text("size")))
    for (int axis = 0; axis < 3; ++axis)
      layout.size[axis] = int(std::min<std::uint64_t>((*size)[axis], std::numeric_limits<int>::max()));
  if (const auto type = raw_type(text("type"))) layout.type = *type;
  layout.big_endian = text("endian") == "big";
  if (const auto offset = to_integer(text("offset")); offset && *offset > 0)
    layout.offset = std::uint64_t(*offset);
  const auto spacing = to_vector(text("spacing"), ',');
  if (spacing && spacing->x > 0 && spacing->y > 0 && spacing->z > 0) layout.spacing = *spacing;
  return layout;
}

Query query_of(const RawLayout& layout, const Query& before) {
  Query query = before;
  query["size"] = fmt::format("{}x{}x{}", layout.size.x, layout.size.y, layout.size.z);
  query["type"] = name_of(layout.type);
  // What has its default need not be said, unless something else says otherwise
  const RawLayout usual;
  const auto say = [&](const char* key, bool differs, std::string value) {
    if (differs || before.contains(key)) query[key] = std::move(value);
  };
  say("endian", layout.big_endian, layout.big_endian ? "big" : "little");
  say("offset", layout.offset != usual.offset, fmt::format("{}", layout.offset));
  const glm::dvec3 s = layout.spacing;
  say("spacing", s != usual.spacing,
      fmt::format("{},{},{}", exact_text(s.x), exact_text(s.y), exact_text(s.z)));
  return query;
}

RawFit fit_of(const RawLayout& layout, std::uint64_t file_bytes) {
  if (layout.size == glm::ivec3(0)) return {false, "How many points are there on each axis?", {}};
  for (int axis = 0; axis < 3; ++axis)
    if (layout.size[axis] < 2)
      return {false,
              fmt::format("A volume has at least 2 points on each axis; {} has {}", "xyz"[axis],
                          layout.size[axis]),
              {}};
  const auto bytes = bytes_of(layout);
  if (!bytes) return {false, fmt::format("{} cannot be counted", size_text(layout.size)), {}};
  const std::string promise =
      fmt::format("{} of {} are {} bytes", size_text(layout.size), name_of(layout.type), grouped(*bytes));
  if (layout.offset >= file_bytes)
    return {false,
            fmt::format("{}; the file has {} altogether, and none after the offset", promise,
                        grouped(file_bytes)),
            {}};
  const std::uint64_t held = file_bytes - layout.offset;
  RawFit fit{held == *bytes,
             fmt::format("{}; the file has {}{}: {}", promise, grouped(held),
                         layout.offset > 0 ? " after the offset" : "", count_text(held, *bytes)),
             {}};
  if (!fit.fits) fit.mends = mends_of(layout, *bytes, file_bytes);
  return fit;
}

}  // namespace crest
