// MRC2014 (Cheng et al., J. Struct. Biol. 192, 2015), with what CCP4, IMOD and older programs write.
#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/binary_fields.h"
#include "render/readers/headers.h"
#include "render/readers/select_one.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t header_size = 1024;

struct Mode {
  ScalarType type;
  std::uint64_t components = 1;
};

/// Mode 0 is signed since MRC2014; IMOD says which in a flag of its own. Many a program writes what the
/// version does not say, and the range of its values (DMIN, DMAX) tells.
bool bytes_are_signed(const BinaryFields& f) {
  constexpr std::int32_t imod = 1146047817, mrc2014 = 20140;
  if (f.at<std::int32_t>(152) == imod) return (f.at<std::int32_t>(156) & 1) != 0;
  const float least = f.at<float>(76), greatest = f.at<float>(80);
  if (least < 0 && greatest <= 127 && least >= -128 && greatest >= least) return true;
  if (least >= 0 && greatest > 127 && greatest <= 255) return false;
  return f.at<std::int32_t>(108) >= mrc2014;
}

std::optional<Mode> mode_of(const BinaryFields& f) {
  using enum ScalarType;
  switch (f.at<std::int32_t>(12)) {
    case 0:
      return Mode{bytes_are_signed(f) ? int8 : uint8};
    case 1:
      return Mode{int16};
    case 2:
      return Mode{float32};
    case 6:
      return Mode{uint16};
    case 12:
      return Mode{float16};
    case 16:
      return Mode{uint8, 3};
    default:
      return std::nullopt;
  }
}

glm::ivec3 three(const BinaryFields& f, std::size_t offset) {
  return {f.at<std::int32_t>(offset), f.at<std::int32_t>(offset + 4), f.at<std::int32_t>(offset + 8)};
}
glm::dvec3 three_reals(const BinaryFields& f, std::size_t offset) {
  return {f.at<float>(offset), f.at<float>(offset + 4), f.at<float>(offset + 8)};
}

std::int32_t extended_bytes(const BinaryFields& f) { return f.at<std::int32_t>(92); }

bool has_sizes(const BinaryFields& f) {
  constexpr std::int32_t greatest_mode = 1000;
  const glm::ivec3 n = three(f, 0);
  const auto mode = f.at<std::int32_t>(12);
  return n.x > 0 && n.y > 0 && n.z > 0 && mode >= 0 && mode < greatest_mode;
}

/// Whether the file is as long as the header says, read in this byte order.
bool fits(const BinaryFields& f, std::uint64_t file_bytes) {
  const auto mode = mode_of(f);
  if (!has_sizes(f) || !mode || extended_bytes(f) < 0) return false;
  const glm::ivec3 n = three(f, 0);
  const auto bytes = checked_product(
      {std::uint64_t(n.x), std::uint64_t(n.y), std::uint64_t(n.z), mode->components, size_of(mode->type)});
  return bytes && *bytes <= file_bytes &&
         header_size + std::uint64_t(extended_bytes(f)) <= file_bytes - *bytes;
}

/// In the order that the stamp says; where it says none, or one in which nothing fits, in that which fits.
BinaryFields in_byte_order(const std::string& name, std::string_view head, std::uint64_t file_bytes,
                           std::string& note) {
  const char stamp = head[212];
  const bool big = stamp == 0x11, little = stamp == 0x44;
  const BinaryFields said{head, big == (std::endian::native == std::endian::little)};
  const BinaryFields other{head, !said.swapped};
  const bool only_other_fits = !fits(said, file_bytes) && fits(other, file_bytes);
  if ((big || little) && has_sizes(said) && extended_bytes(said) >= 0 && !only_other_fits) return said;
  const auto text = [](const BinaryFields& f) {
    return f.swapped == (std::endian::native == std::endian::little) ? "big-endian" : "little-endian";
  };
  for (const BinaryFields& f : {said, other}) {
    if (!fits(f, file_bytes)) continue;
    note = fmt::format("its stamp of the byte order is {}: its sizes are {}",
                       big || little ? "wrong" : "missing", text(f));
    return f;
  }
  const BinaryFields& likelier = has_sizes(said) ? said : has_sizes(other) ? other : said;
  const glm::ivec3 n = three(likelier, 0);
  const std::string as =
      fmt::format("sizes {} {} {} and mode {}", n.x, n.y, n.z, likelier.at<std::int32_t>(12));
  const std::string stamp_fault = big || little ? "" : ", and no stamp that says the byte order";
  if (!has_sizes(likelier))
    throw Error(fmt::format("{}: not an MRC file: its header has {}{}", name, as, stamp_fault));
  throw Error(
      fmt::format("{}: its header has {} ({}) behind an extended header of {} bytes, which its {} bytes "
                  "do not hold{}",
                  name, as, text(likelier), extended_bytes(likelier), file_bytes, stamp_fault));
}

/// Bytes before the voxels. Some programs copy a header and not the extended one that it tells of: the file
/// is then as long as without.
std::uint64_t bytes_before(const BinaryFields& f, const Mode& mode, std::uint64_t file_bytes,
                           std::string& note) {
  const std::uint64_t extended = std::uint64_t(extended_bytes(f));
  const glm::u64vec3 n(three(f, 0));
  const auto voxels = checked_product({n.x, n.y, n.z, mode.components, size_of(mode.type)});
  if (extended == 0 || !voxels || file_bytes != header_size + *voxels) return header_size + extended;
  add_note(note, fmt::format("it tells of an extended header of {} bytes, which is not there", extended));
  return header_size;
}

/// Which axis of space each of the file's axes is, from 0: MAPC, MAPR and MAPS.
glm::ivec3 axis_order(const std::string& name, const BinaryFields& f) {
  const glm::ivec3 map = three(f, 64);
  if (map == glm::ivec3(0)) return {0, 1, 2};  // of old programs, which know no order
  bool found[4] = {};
  for (int i = 0; i < 3; ++i)
    if (map[i] >= 1 && map[i] <= 3) found[map[i]] = true;
  if (found[1] && found[2] && found[3]) return map - 1;
  throw Error(fmt::format("{}: its axes' order {} {} {} (MAPC, MAPR, MAPS) is not one of 1, 2 and 3", name,
                          map.x, map.y, map.z));
}

/// Axes put in the order of space. A stack of volumes (space group 401) has MZ sections in each.
void take_layout(const std::string& name, const BinaryFields& f, const Mode& mode, glm::ivec3 order,
                 VoxelHeader& header) {
  constexpr std::int32_t volume_stack = 401;
  glm::u64vec3 sizes(three(f, 0));
  std::uint64_t frames = 1;
  if (const std::int32_t group = f.at<std::int32_t>(88), sections = f.at<std::int32_t>(36);
      group >= volume_stack && group < volume_stack + 230 && sections > 0) {
    if (sizes.z % std::uint64_t(sections) != 0) {
      throw Error(fmt::format("{}: a stack of volumes with {} sections, which {} are not a multiple of", name,
                              sections, sizes.z));
    }
    frames = sizes.z / std::uint64_t(sections);
    sizes.z = std::uint64_t(sections);
  }
  const VoxelLayout stored = interleaved(sizes, mode.components, frames);
  header.layout = stored;
  for (int i = 0; i < 3; ++i) {
    header.layout.dims[order[i]] = stored.dims[i];
    header.layout.stride[order[i]] = stored.stride[i];
  }
}

void take_geometry(const BinaryFields& f, glm::ivec3 order, VoxelHeader& header) {
  const glm::ivec3 samples = three(f, 28), start = three(f, 16);
  const glm::dvec3 cell = three_reals(f, 40), angles = three_reals(f, 52), origin = three_reals(f, 196);
  for (int axis = 0; axis < 3; ++axis)
    header.spacing[axis] = samples[axis] > 0 ? cell[axis] / samples[axis] : 0;
  header.origin = origin;
  if (origin == glm::dvec3(0))
    for (int i = 0; i < 3; ++i) header.origin[order[i]] = start[i] * header.spacing[order[i]];
  for (int i = 0; i < 3; ++i) {
    if (angles[i] == 0 || std::abs(angles[i] - 90) < 0.01) continue;
    add_note(header.note,
             fmt::format("its cell's angles are {:.4g}, {:.4g} and {:.4g} degrees, and shown as right ones",
                         angles.x, angles.y, angles.z));
    break;
  }
  if (order != glm::ivec3(0, 1, 2))
    add_note(header.note, fmt::format("its axes are stored in the order {} {} {}, and put in order",
                                      order.x + 1, order.y + 1, order.z + 1));
}

}  // namespace

VoxelHeader read_mrc_header(const fs::path& path) {
  const std::string name = path.string();
  const bool is_compressed = read_head(path, 2) == "\x1f\x8b";  // as the EMDB's maps come
  const std::string head = read_head(path, header_size, is_compressed);
  if (head.size() < header_size)
    throw Error(fmt::format("{}: not an MRC file: its header has fewer than 1024 bytes", name));
  const std::uint64_t most_bytes = fs::file_size(path) * (is_compressed ? greatest_inflation : 1);
  VoxelHeader header;
  const BinaryFields f = in_byte_order(name, head, most_bytes, header.note);
  const auto mode = mode_of(f);
  if (!mode) {
    throw Error(
        fmt::format("{}: MRC mode {} is not read; 0 (int8), 1 (int16), 2 (float32), 6 (uint16), 12 (float16) "
                    "and 16 (RGB) are",
                    name, f.at<std::int32_t>(12)));
  }
  const glm::ivec3 order = axis_order(name, f);
  header.type = mode->type;
  if (size_of(mode->type) == 1 && mode->components == 1)
    add_note(header.note, fmt::format("bytes are taken as {}", name_of(mode->type)));
  header.endian =
      f.swapped == (std::endian::native == std::endian::little) ? std::endian::big : std::endian::little;
  header.data = {{path}, 0, is_compressed ? Encoding::deflate : Encoding::raw};
  (is_compressed ? header.data.skip : header.data.offset) =
      bytes_before(f, *mode, is_compressed ? 0 : most_bytes, header.note);
  take_layout(name, f, *mode, order, header);
  header.component_names = colour_names(mode->components);
  take_geometry(f, order, header);
  return header;
}

}  // namespace crest
