#include "render/readers/voxel_reader.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <limits>
#include <span>

#include "presets/error.h"
#include "render/readers/select_one.h"
#include "render/readers/subtract.h"
#include "render/volume/memory.h"
#include "render/volume/orientation.h"
#include "render/volume/rounding.h"

namespace crest {
namespace {

/// The stored values that hold the selected ones, and where those lie among them.
struct Selection {
  std::uint64_t first = 0, count = 0;
  glm::u64vec3 stride{0};
};

void require_countable(const std::string& name, const VoxelLayout& layout) {
  constexpr std::uint64_t most_components = 1024;
  require_memory(name, layout.dims, sizeof(double), std::numeric_limits<std::uint64_t>::max());
  const auto per_point = checked_product(layout.components * sizeof(double), layout.frames);
  if (layout.components == 0 || layout.components > most_components || layout.frames == 0 || !per_point ||
      !checked_product(layout.dims.x * layout.dims.y * layout.dims.z, *per_point)) {
    throw Error(fmt::format("{}: {}x{}x{} points of {} components in {} frames cannot be counted", name,
                            layout.dims.x, layout.dims.y, layout.dims.z, layout.components, layout.frames));
  }
}

Selection select(const FileRequest& request, const VoxelHeader& header, Volume& volume) {
  const VoxelLayout& layout = header.layout;
  const std::uint64_t component =
      select_one(request, ChoiceKind::component, layout.components, volume.note, header.component_names);
  const std::uint64_t frame = select_frame(request, layout.frames, volume);
  Selection selection{layout.start + component * layout.component_stride + frame * layout.frame_stride, 1,
                      layout.stride};
  for (int axis = 0; axis < 3; ++axis) selection.count += (layout.dims[axis] - 1) * layout.stride[axis];
  return selection;
}

/// Rows of x, which most layouts have at a fixed distance.
std::vector<float> gather(std::span<const std::byte> bytes, const VoxelHeader& header, glm::u64vec3 stride,
                          LinearMap map) {
  const glm::u64vec3 dims = header.layout.dims;
  const std::size_t value_size = size_of(header.type);
  std::vector<float> values(dims.x * dims.y * dims.z);
  if (stride.y == stride.x * dims.x && stride.z == stride.y * dims.y) {
    convert_to_float(bytes, header.type, stride.x, values, map);
    return values;
  }
  tbb::parallel_for(std::uint64_t(0), dims.y * dims.z, [&](std::uint64_t row) {
    const std::uint64_t first = row % dims.y * stride.y + row / dims.y * stride.z;
    convert_to_float(bytes.subspan(first * value_size), header.type, stride.x,
                     std::span(values).subspan(row * dims.x, dims.x), map);
  });
  return values;
}

/// Of other files than the one that is named, and of what is inflated to find a part of it.
std::uint64_t bytes_besides(const std::filesystem::path& path, const VoxelHeader& header,
                            std::uint64_t stored) {
  const bool inflates = header.data.encoding == Encoding::deflate;
  std::uint64_t bytes = inflates ? header.data.skip + stored * size_of(header.type) : 0;
  for (const auto& file : header.data.files)
    if (file != path) bytes += std::filesystem::file_size(file);
  return bytes;
}

}  // namespace

VoxelLayout interleaved(glm::u64vec3 dims, std::uint64_t components, std::uint64_t frames) {
  VoxelLayout layout{dims, {components, components * dims.x, components * dims.x * dims.y}};
  layout.components = components;
  layout.component_stride = 1;
  layout.frames = frames;
  layout.frame_stride = components * dims.x * dims.y * dims.z;
  return layout;
}

void add_note(std::string& note, const std::string& more) {
  if (!note.empty() && !more.empty()) note += "; ";
  note += more;
}

Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys) {
  const std::string name = request.name();
  const std::uint64_t stored = header.layout.stored_values();
  require_countable(name, header.layout);
  require_room(name, header.data, stored, size_of(header.type));
  VoxelHeader as_read = header;
  if (header.data.encoding == Encoding::decimal) as_read.endian = std::endian::native;
  const std::uint64_t besides = bytes_besides(request.path, header, stored);
  return read_voxels(request.reading_also(besides), as_read, keys,
                     [&](std::uint64_t first, std::uint64_t count) {
                       return read_stored(name, header.data, header.type, stored, first, count);
                     });
}

Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys,
                   const FetchValues& fetch) {
  const std::string name = request.name();
  require_known_keys(name, request.query, "component,frame,subtract" + keys);
  const VoxelLayout& layout = header.layout;
  require_countable(name, layout);
  Volume volume;
  const Selection selection = select(request, header, volume);
  const std::uint64_t points = layout.dims.x * layout.dims.y * layout.dims.z;
  request.require_memory(layout.dims, (selection.count + points - 1) / points * size_of(header.type));
  add_note(volume.note, header.note);
  if (header.scaling != LinearMap()) {
    add_note(volume.note, fmt::format("values are {} times the stored ones plus {}", header.scaling.slope,
                                      header.scaling.intercept));
  }
  volume.file_type = header.type;
  volume.grid = {glm::ivec3(layout.dims), header.spacing, header.origin};
  volume.direction = header.direction;
  add_note(volume.note, orientation_note(header.direction));

  const LinearMap map = subtracted(request, header.scaling, volume.note);
  std::vector<std::byte> bytes = fetch(selection.first, selection.count);
  if (header.endian != std::endian::native) swap_bytes(bytes, size_of(header.type));
  volume.values = gather(bytes, header, selection.stride, map);
  const std::size_t between = layout.component_stride == 1 ? layout.components : 1;
  add_note(volume.note, rounding_note(bytes, header.type, between, map));
  return volume;
}

}  // namespace crest
