#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/headers.h"
#include "render/readers/select_one.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_axes = 16;  // of teem, which the format comes from

enum class Role { unknown, space, component, frame };

/// What the header says of one axis.
struct Axis {
  std::uint64_t size = 0;
  double spacing = nan, min = nan, max = nan;
  bool is_cell = false, says_spacing = false;
  std::string kind = {};
  bool has_direction = false;       ///< a vector, not "none"
  std::vector<double> vector = {};  ///< from point to point, in space
  Role role = Role::unknown;
};

const std::string* find(const NrrdFields& fields, std::string_view key) {
  const auto found = fields.find(std::string(key));
  return found == fields.end() ? nullptr : &found->second;
}

[[noreturn]] void throw_bad(const std::string& name, std::string_view key, const std::string& value,
                            std::string_view right) {
  throw Error(fmt::format("{}: {}: {} is not {}", name, key, value, right));
}

/// "(1,0,0) none (0, 2, 0)": nothing for "none".
std::vector<std::optional<std::vector<double>>> vectors_of(const std::string& name, std::string_view key,
                                                           const std::string& text) {
  std::vector<std::optional<std::vector<double>>> vectors;
  for (std::string_view rest = trim(text); !rest.empty(); rest = trim(rest)) {
    if (lower(rest.substr(0, 4)) == "none") {
      vectors.emplace_back();
      rest.remove_prefix(4);
      continue;
    }
    const std::size_t end = rest.find(')');
    if (rest[0] != '(' || end == std::string_view::npos) throw_bad(name, key, text, "like (1,0,0) (0,1,0)");
    std::vector<double> vector;
    for (const std::string_view part : split(rest.substr(1, end - 1), ','))
      vector.push_back(to_number(trim(part)).value_or(nan));
    vectors.emplace_back(std::move(vector));
    rest.remove_prefix(end + 1);
  }
  return vectors;
}

/// Words of a field that has one for each axis; none where there is no such field.
std::vector<std::string> words_of(const std::string& name, const NrrdFields& fields, std::string_view key,
                                  std::size_t axes) {
  const std::string* text = find(fields, key);
  if (!text) return {};
  auto list = words(*text);
  if (list.size() != axes)
    throw Error(
        fmt::format("{}: {}: it has {} words, and the dimension is {}", name, key, list.size(), axes));
  return list;
}

void take_numbers(const std::string& name, const NrrdFields& fields, std::string_view key,
                  std::vector<Axis>& axes, double Axis::*member) {
  const auto list = words_of(name, fields, key, axes.size());
  for (std::size_t a = 0; a < list.size(); ++a) axes[a].*member = to_number(list[a]).value_or(nan);
}

void take_directions(const std::string& name, const NrrdFields& fields, std::vector<Axis>& axes) {
  const std::string* text = find(fields, "space directions");
  if (!text) return;
  const auto vectors = vectors_of(name, "space directions", *text);
  if (vectors.size() != axes.size()) {
    throw Error(fmt::format("{}: space directions: they are {}, and the dimension is {}", name,
                            vectors.size(), axes.size()));
  }
  for (std::size_t a = 0; a < axes.size(); ++a) {
    // Old files have (nan,nan,nan) for "none"
    if (!vectors[a] || std::ranges::all_of(*vectors[a], [](double v) { return std::isnan(v); })) continue;
    axes[a].has_direction = true;
    axes[a].vector = *vectors[a];
  }
}

std::vector<Axis> axes_of(const std::string& name, const NrrdFields& fields) {
  const std::string& dimension = fields.at("dimension");
  const auto count = to_integer(dimension);
  if (!count || *count < 1 || *count > std::int64_t(most_axes))
    throw_bad(name, "dimension", dimension, "a whole number from 1 to 16");
  std::vector<Axis> axes{std::size_t(*count)};
  const auto sizes = words_of(name, fields, "sizes", axes.size());
  std::uint64_t all = 1;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto size = to_integer(sizes[a]);
    if (!size || *size < 1) throw_bad(name, "sizes", sizes[a], "a number of points");
    axes[a].size = std::uint64_t(*size);
    const auto product = checked_product(all, axes[a].size);
    if (!product)
      throw Error(fmt::format("{}: sizes: {} points cannot be counted", name, fields.at("sizes")));
    all = *product;
  }
  take_numbers(name, fields, "spacings", axes, &Axis::spacing);
  for (Axis& axis : axes) axis.says_spacing = find(fields, "spacings") != nullptr;
  take_numbers(name, fields, "axis mins", axes, &Axis::min);
  take_numbers(name, fields, "axis maxs", axes, &Axis::max);
  const auto kinds = words_of(name, fields, "kinds", axes.size());
  for (std::size_t a = 0; a < kinds.size(); ++a) axes[a].kind = lower(kinds[a]);
  const auto centers = words_of(name, fields, "centers", axes.size());
  for (std::size_t a = 0; a < centers.size(); ++a) axes[a].is_cell = lower(centers[a]) == "cell";
  take_directions(name, fields, axes);
  return axes;
}

/// Along the fourth coordinate of a space with time.
bool is_along_time(const Axis& axis) {
  const auto& v = axis.vector;
  return v.size() == 4 && v[0] == 0 && v[1] == 0 && v[2] == 0 && v[3] != 0;
}

/// By directions where there are some, else by kinds, else by order: three axes of space, then frames.
void find_roles(const std::string& name, bool has_directions, std::vector<Axis>& axes) {
  std::size_t spatial = 0, components = 0, frames = 0;
  const auto take = [&](Axis& axis, Role role) {
    axis.role = role;
    ++(role == Role::space ? spatial : role == Role::component ? components : frames);
  };
  for (Axis& axis : axes) {
    const bool unsaid = axis.kind.empty() || axis.kind == "???" || axis.kind == "none";
    const bool in_space =
        has_directions ? axis.has_direction : unsaid || axis.kind == "domain" || axis.kind == "space";
    if (axis.kind == "time" || is_along_time(axis) || (in_space && spatial == 3))
      take(axis, Role::frame);
    else if (in_space)
      take(axis, Role::space);
    else
      take(axis, (unsaid || axis.kind == "list") && components > 0 ? Role::frame : Role::component);
  }
  if (spatial == 2 && frames == 1) {  // images one after another
    for (Axis& axis : axes)
      if (axis.role == Role::frame) axis.role = Role::space;
    spatial = 3, frames = 0;
  }
  if (spatial < 3) {
    throw Error(
        fmt::format("{}: it has {} dimensions, and a volume has three{}", name, spatial,
                    spatial == 2 ? ": put its slices into one file, or open a folder of images" : ""));
  }
  if (components > 1 || frames > 1) {
    throw Error(
        fmt::format("{}: it has {} axes, and {} of them are components, {} frames: one of each is read", name,
                    axes.size(), components, frames));
  }
}

/// Of the kinds that say what their components are.
Names names_of(const Axis& components) {
  const std::string& kind = components.kind;
  if (kind == "rgb-color" || kind == "rgba-color") return colour_names(components.size);
  if (kind == "complex") return complex_names();
  return {};
}

void take_layout(const std::vector<Axis>& axes, VoxelHeader& header) {
  VoxelLayout& layout = header.layout;
  std::uint64_t stride = 1;
  int spatial = 0;
  for (const Axis& axis : axes) {
    if (axis.role == Role::space) {
      layout.dims[spatial] = axis.size;
      layout.stride[spatial++] = stride;
    } else if (axis.role == Role::component) {
      layout.components = axis.size;
      layout.component_stride = stride;
      header.component_names = names_of(axis);
    } else {
      layout.frames = axis.size;
      layout.frame_stride = stride;
    }
    stride *= axis.size;
  }
}

/// From a patient's coordinates to those that DICOM has, to the left, the back and the head; nothing for
/// other spaces.
std::optional<glm::dvec3> to_lps(const std::string& space) {
  const std::string name = lower(space);
  if (name.starts_with("right-anterior-superior") || name == "ras" || name == "rast")
    return glm::dvec3(-1, -1, 1);
  if (name.starts_with("left-anterior-superior") || name == "las" || name == "last")
    return glm::dvec3(1, -1, 1);
  if (name.starts_with("left-posterior-superior") || name == "lps" || name == "lpst") return glm::dvec3(1);
  return std::nullopt;
}

glm::dvec3 first_three(const std::vector<double>& v) {
  return {v.empty() ? 0 : v[0], v.size() < 2 ? 0 : v[1], v.size() < 3 ? 0 : v[2]};
}

void take_axis_geometry(const Axis& axis, int column, glm::dvec3 flips, VoxelHeader& header) {
  if (axis.has_direction) {
    const glm::dvec3 vector = flips * first_three(axis.vector);
    header.spacing[column] = glm::length(vector);
    header.direction[column] = vector / header.spacing[column];
    return;
  }
  const double points = double(axis.size) - (axis.is_cell ? 0 : 1);
  if (!std::isnan(axis.max - axis.min) && std::isnan(axis.spacing))
    header.spacing[column] = (axis.max - axis.min) / points;
  else if (axis.says_spacing)
    header.spacing[column] = axis.spacing;  // NaN is one that is not known
  if (!std::isnan(axis.min))
    header.origin[column] = axis.min + (axis.is_cell ? 0.5 * header.spacing[column] : 0);
}

}  // namespace

void take_nrrd_axes(const std::string& name, const NrrdFields& fields, VoxelHeader& header) {
  std::vector<Axis> axes = axes_of(name, fields);
  const std::string* directions = find(fields, "space directions");
  find_roles(name, directions != nullptr, axes);
  take_layout(axes, header);
  const std::string* space = find(fields, "space");
  const std::optional<glm::dvec3> patient = to_lps(space ? *space : "");
  const glm::dvec3 flips = patient.value_or(glm::dvec3(1));
  header.is_in_patient = patient && directions;
  int column = 0;
  for (const Axis& axis : axes)
    if (axis.role == Role::space) take_axis_geometry(axis, column++, flips, header);
  if (const std::string* origin = find(fields, "space origin")) {
    const auto vectors = vectors_of(name, "space origin", *origin);
    if (vectors.size() != 1 || !vectors[0]) throw_bad(name, "space origin", *origin, "like (0,0,0)");
    header.origin = flips * first_three(*vectors[0]);
  }
}

}  // namespace crest
