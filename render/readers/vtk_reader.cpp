#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/error.h"
#include "render/readers/choose_array.h"
#include "render/readers/readers.h"
#include "render/readers/voxel_reader.h"
#include "render/readers/vtk_legacy.h"

namespace crest {
namespace {

using Section = VtkArray::Section;

std::vector<VtkArray> arrays_of(const VtkLegacy& file, Section section) {
  std::vector<VtkArray> arrays;
  for (const VtkArray& array : file.arrays)
    if (array.section == section) arrays.push_back(array);
  return arrays;
}

/// The name of the only SCALARS; empty when there are others, or none.
std::string only_scalars(const std::vector<VtkArray>& arrays) {
  if (std::ranges::count(arrays, true, &VtkArray::is_scalars) != 1) return {};
  return std::ranges::find(arrays, true, &VtkArray::is_scalars)->name;
}

/// Where a file has values of its cells alone, they are points at the cells' centres.
void move_to_centres(VtkLegacy& file, std::string& note) {
  file.origin += 0.5 * file.spacing;
  file.dims -= 1;
  add_note(note, "the file has values of its cells, which are taken at the cells' centres");
}

}  // namespace

Volume read_vtk(const FileRequest& request) {
  const std::string name = request.name();
  VtkLegacy file = scan_vtk_legacy(request.path);
  VoxelHeader header;
  std::vector<VtkArray> arrays = arrays_of(file, Section::points);
  if (arrays.empty()) {
    arrays = arrays_of(file, Section::cells);
    if (!arrays.empty()) move_to_centres(file, header.note);
  }
  if (arrays.empty()) {
    throw Error(fmt::format("{}: the VTK file has no SCALARS, VECTORS or FIELD of its points or cells{}",
                            name, file.unread.empty() ? "" : fmt::format("; it has {}", file.unread)));
  }
  std::vector<std::string> names;
  for (const VtkArray& array : arrays) names.push_back(array.name);
  const VtkArray& array = arrays[choose_array(request, names, only_scalars(arrays), header.note)];

  const glm::u64vec3 dims(glm::max(file.dims, 0));
  header.layout = interleaved(dims, array.components);
  header.type = array.type;
  header.endian = std::endian::big;
  header.data = {{request.path}, array.offset, file.is_text ? Encoding::decimal : Encoding::raw};
  header.data.first_line = array.line;
  header.data.more_may_follow = true;
  header.spacing = file.spacing;
  header.origin = file.origin;
  constexpr std::uint64_t most = std::uint64_t(1) << 20;  // points on an axis whose product cannot overflow
  if (dims.x <= most && dims.y <= most && dims.z <= most && array.tuples != dims.x * dims.y * dims.z) {
    throw Error(fmt::format("{}: DIMENSIONS promises {} values, and {} has {}", name,
                            dims.x * dims.y * dims.z, array.name, array.tuples));
  }
  if (!file.unread.empty())
    add_note(header.note, fmt::format("what follows its arrays is not read: {}", file.unread));
  if (array.is_of_255) {
    header.scaling = {255, 0};
    if (request.query.contains("subtract"))
      throw Error(fmt::format("{}: {} holds bytes, written as text: subtract is for large integers", name,
                              array.name));
  }
  Volume volume = read_voxels(request, header, ",array");
  if (array.is_of_255)
    for (float& value : volume.values.floats()) value = std::round(value);  // which text has to six digits
  return volume;
}

}  // namespace crest
