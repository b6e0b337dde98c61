#include "render/readers/voxel_reader.h"

#include <fmt/core.h>

#include <limits>

#include "presets/error.h"
#include "render/files/geometry.h"
#include "render/readers/select_one.h"
#include "render/readers/subtract.h"
#include "render/readers/voxel_stream.h"
#include "render/volume/memory.h"
#include "render/volume/orientation.h"
#include "render/volume/voxel_store.h"

namespace crest {
namespace {

void require_countable(const std::string& name, const VoxelLayout& layout) {
  constexpr std::uint64_t most_components = 1024;
  require_memory(name, {whole_grid(layout.dims), sizeof(double)}, std::numeric_limits<std::uint64_t>::max());
  const auto per_point = checked_product(layout.components * sizeof(double), layout.frames);
  if (layout.components == 0 || layout.components > most_components || layout.frames == 0 || !per_point ||
      !checked_product(layout.dims.x * layout.dims.y * layout.dims.z, *per_point)) {
    throw Error(fmt::format("{}: {}x{}x{} points of {} components in {} frames cannot be counted", name,
                            layout.dims.x, layout.dims.y, layout.dims.z, layout.components, layout.frames));
  }
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

/// Also the stored values of one slab, at least those of a row.
MemoryNeed need_of(const VoxelHeader& header, const GridPart& part, std::uint64_t held_besides) {
  const std::uint64_t stored =
      header.layout.dims.x * header.layout.dims.y * header.layout.dims.z * header.layout.components;
  return {part, held_size_of(header.type),
          std::min(slab_bytes, stored * size_of(header.type)) + held_besides};
}

}  // namespace

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
  VoxelStream stream(name, header.data, header.type, stored);
  Volume volume = read_voxels(
      request.reading_also(besides), as_read, keys,
      [&](std::uint64_t first, std::span<std::byte> out) { stream.read(first, out); }, 0);
  if (const auto file = stream.finish(); file && !header.data.more_may_follow)
    add_note(volume.note,
             fmt::format("{} goes on behind the voxels that the header tells of", file->filename().string()));
  return volume;
}

Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys,
                   const ReadValues& read, std::uint64_t held_besides) {
  const std::string name = request.name();
  require_known_keys(name, request.query, "component,frame,subtract" + std::string(part_keys) + keys);
  const VoxelLayout& layout = header.layout;
  require_countable(name, layout);
  Volume volume;
  const std::uint64_t component =
      select_one(request, ChoiceKind::component, layout.components, volume.note, header.component_names);
  const std::uint64_t frame = select_frame(request, layout.frames, volume);
  const GridPart part = request.part_of(layout.dims);
  request.require_memory(need_of(header, part, held_besides));
  add_note(volume.note, header.note);
  if (header.scaling != LinearMap()) {
    add_note(volume.note, fmt::format("values are {} times the stored ones plus {}", header.scaling.slope,
                                      header.scaling.intercept));
  }
  volume.file_type = header.type;
  volume.grid = {glm::ivec3(layout.dims), header.spacing, header.origin};
  volume.direction = header.direction;
  volume.is_in_patient = header.is_in_patient;
  add_note(volume.note, orientation_note(header.direction));

  const StoredAs stored{header.type, header.endian, subtracted(request, header.scaling, volume.note)};
  SlabsRead slabs =
      read_slabs(part_of(one_of(layout, component, frame), part), stored, read, request.reading.progress);
  volume.values = std::move(slabs.values);
  add_note(volume.note, rounding_note(slabs.rounding, header.type, stored.map));
  place_part(volume, part);
  return volume;
}

}  // namespace crest
