#include "render/volume/grid_part.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <optional>

#include "presets/error.h"

namespace crest {
namespace {

/// A whole number in [least, most]; `fallback` where the text is empty.
std::optional<std::uint64_t> whole_number(std::string_view text, std::uint64_t fallback, std::uint64_t least,
                                          std::uint64_t most) {
  if (text.empty()) return fallback;
  const auto number = to_integer(text);
  if (!number || *number < 0) return std::nullopt;
  const auto value = std::uint64_t(*number);
  return value >= least && value <= most ? std::optional(value) : std::nullopt;
}

bool take_crop(std::string_view text, GridPart& part) {
  const auto axes = split(text, ',');
  if (axes.size() != 3) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto ends = split(axes[std::size_t(axis)], ':');
    if (ends.size() != 2) return false;
    const auto first = whole_number(ends[0], 0, 0, part.full[axis]);
    const auto end = whole_number(ends[1], part.full[axis], 0, part.full[axis]);
    if (!first || !end || *first >= *end) return false;
    part.first[axis] = *first;
    part.end[axis] = *end;
  }
  return true;
}

bool take_stride(std::string_view text, GridPart& part) {
  constexpr std::uint64_t most = (std::uint64_t(1) << 31) - 1;
  const auto axes = split(text, ',');
  if (axes.size() != 1 && axes.size() != 3) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view number = axes[axes.size() == 1 ? 0 : std::size_t(axis)];
    const auto stride = number.empty() ? std::nullopt : whole_number(number, 1, 1, most);
    if (!stride) return false;
    part.stride[axis] = *stride;
  }
  return true;
}

std::string size_text(glm::u64vec3 size) { return fmt::format("{}x{}x{}", size.x, size.y, size.z); }

std::string box_text(const GridPart& part) {
  return fmt::format("{}:{},{}:{},{}:{}", part.first.x, part.end.x, part.first.y, part.end.y, part.first.z,
                     part.end.z);
}

std::string ordinal(std::uint64_t number) {
  const std::uint64_t last = number % 10, teens = number / 10 % 10;
  return fmt::format("{}{}", number,
                     teens == 1  ? "th"
                     : last == 1 ? "st"
                     : last == 2 ? "nd"
                     : last == 3 ? "rd"
                                 : "th");
}

/// "every 2nd point", "every 2nd, 2nd and 3rd point on x, y and z"; empty where all are taken.
std::string stride_text(glm::u64vec3 stride) {
  if (stride == glm::u64vec3(1)) return {};
  if (stride == glm::u64vec3(stride.x)) return fmt::format("every {} point", ordinal(stride.x));
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (stride[axis] > 1)
      text +=
          fmt::format("{}every {} point on {}", text.empty() ? "" : ", ", ordinal(stride[axis]), "xyz"[axis]);
  }
  return text;
}

}  // namespace

GridPart at_stride(GridPart part, std::uint64_t stride) {
  const glm::u64vec3 most = glm::max(part.end - part.first, glm::u64vec3(2)) - glm::u64vec3(1);
  part.stride = glm::min(glm::max(glm::u64vec3(stride), part.stride), most);
  return part;
}

GridPart whole_grid(glm::u64vec3 dims) { return {dims, glm::u64vec3(0), dims, glm::u64vec3(1)}; }

GridPart part_from_query(std::string_view name, const Query& query, glm::u64vec3 dims) {
  GridPart part = whole_grid(dims);
  const auto crop = query.find("crop"), stride = query.find("stride");
  if (crop != query.end() && !take_crop(crop->second, part)) {
    throw Error(
        fmt::format("{}: crop={} is no box in {} points, such as 0:{},:,{}: (the first point is taken, "
                    "the one after the \":\" is not)",
                    name, crop->second, size_text(dims), dims.x, dims.z / 2));
  }
  if (stride != query.end() && !take_stride(stride->second, part))
    throw Error(
        fmt::format("{}: stride={} is neither a number like 2 nor three like 2,2,1", name, stride->second));
  const glm::u64vec3 left = part.dims();
  for (int axis = 0; axis < 3; ++axis) {
    if (left[axis] < 2 && dims[axis] >= 2)
      throw Error(fmt::format("{}: {} leaves {} point on axis {}, and a volume has at least 2 on each", name,
                              short_part_text(part), left[axis], "xyz"[axis]));
  }
  return part;
}

Query with_part(Query query, const GridPart& part) {
  query.erase("crop");
  query.erase("stride");
  const glm::u64vec3 s = part.stride;
  if (!part.is_box_whole()) query["crop"] = box_text(part);
  if (s != glm::u64vec3(1))
    query["stride"] =
        s == glm::u64vec3(s.x) ? fmt::format("{}", s.x) : fmt::format("{},{},{}", s.x, s.y, s.z);
  return query;
}

std::string part_text(const GridPart& part) {
  if (part.is_whole()) return {};
  const std::string stride = stride_text(part.stride), size = size_text(part.full);
  if (part.is_box_whole()) return fmt::format("{} of {}", stride, size);
  if (stride.empty()) return fmt::format("the box {} of {}", box_text(part), size);
  return fmt::format("{} of {}, of the box {}", stride, size, box_text(part));
}

std::string short_part_text(const GridPart& part) {
  const std::string stride = stride_text(part.stride);
  if (part.is_box_whole()) return stride;
  return fmt::format("{}{}box {}", stride, stride.empty() ? "" : ", ", box_text(part));
}

}  // namespace crest
