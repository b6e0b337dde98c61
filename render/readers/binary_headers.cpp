#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/headers.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// The value at a byte offset of a header of either byte order.
template <class T>
T value_at(std::string_view head, std::size_t offset, bool swapped) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, head.data() + offset, sizeof(T));
  if (swapped) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

std::optional<ScalarType> nifti_type(std::int16_t code) {
  using enum ScalarType;
  switch (code) {
    case 2:
      return uint8;
    case 4:
      return int16;
    case 8:
      return int32;
    case 16:
      return float32;
    case 64:
      return float64;
    case 256:
      return int8;
    case 512:
      return uint16;
    case 768:
      return uint32;
    case 1024:
      return int64;
    case 1280:
      return uint64;
    default:
      return std::nullopt;
  }
}

}  // namespace

FileHeader read_nifti_header(const fs::path& path) {
  constexpr std::size_t header_size = 348, datatype = 70, vox_offset = 108, slope = 112, intercept = 116;
  constexpr std::int32_t second_version = 540;
  const std::string name = path.string();
  const bool compressed = read_head(path, 2) == "\x1f\x8b";
  const std::string head = read_head(path, header_size, compressed);
  for (const bool swapped : {false, true}) {
    const auto size = head.size() == header_size ? value_at<std::int32_t>(head, 0, swapped) : 0;
    if (size == second_version) throw Error(fmt::format("{}: NIfTI-2 is not read, NIfTI-1 is", name));
    if (size != std::int32_t(header_size)) continue;
    const double begin = value_at<float>(head, vox_offset, swapped);
    if (!(begin >= 0 && begin < 0x1p60)) {
      throw Error(fmt::format("{}: vox_offset {} is not a place in the file", name, begin));
    }
    FileHeader header;
    header.data = {{path}, 0, compressed ? Encoding::deflate : Encoding::raw};
    header.data.skip = std::max(std::uint64_t(begin), std::uint64_t(header_size));
    header.stored_type = nifti_type(value_at<std::int16_t>(head, datatype, swapped));
    const LinearMap scaling{value_at<float>(head, slope, swapped), value_at<float>(head, intercept, swapped)};
    const bool scales = scaling.slope != 0;  // 0 says that there is no scaling at all
    if (scales && std::isfinite(scaling.slope) && std::isfinite(scaling.intercept)) header.scaling = scaling;
    return header;
  }
  throw Error(fmt::format("{}: not a NIfTI file: its header's size is not 348", name));
}

FileHeader read_mrc_header(const fs::path& path) {
  constexpr std::size_t header_size = 1024, stamp = 212, mode = 12, extended_size = 92, version = 108,
                        imod_stamp = 152, imod_flags = 156;
  constexpr std::int32_t imod = 1146047817;
  const std::string name = path.string();
  const std::string head = read_head(path, header_size);
  if (head.size() < header_size)
    throw Error(fmt::format("{}: not an MRC file: its header has fewer than 1024 bytes", name));
  const bool swapped = head[stamp] == 0x11;
  const auto integer = [&](std::size_t offset) { return value_at<std::int32_t>(head, offset, swapped); };
  if (integer(0) < 1 || integer(4) < 1 || integer(8) < 1 || integer(mode) < 0 || integer(extended_size) < 0) {
    throw Error(fmt::format("{}: not an MRC file: its header has sizes {} {} {} and mode {}", name,
                            integer(0), integer(4), integer(8), integer(mode)));
  }
  FileHeader header;
  header.data = {{path}, header_size + std::uint64_t(integer(extended_size)), Encoding::raw};
  // Mode 0 is signed since MRC2014; IMOD says which in a flag of its own.
  const bool is_signed =
      integer(imod_stamp) == imod ? (integer(imod_flags) & 1) != 0 : integer(version) >= 20140;
  if (integer(mode) == 0 && is_signed) header.stored_type = ScalarType::int8;
  return header;
}

FileHeader read_vtk_header(const fs::path& path) {
  constexpr std::size_t longest = std::size_t(1) << 16;
  const std::string name = path.string();
  const std::string head = read_head(path, longest);
  if (!head.starts_with("# vtk DataFile")) {
    throw Error(fmt::format("{}: not a legacy VTK file: it does not begin with \"# vtk DataFile\"", name));
  }
  FileHeader header;
  header.data.files = {path};
  HeaderLines lines(head);
  bool found = false;
  std::string_view line;
  for (int number = 1; !found && lines.next(line); ++number) {
    const std::string text = lower(trim(line));
    if (number == 3 && text == "ascii") header.data.encoding = Encoding::decimal;
    for (const char* key : {"scalars", "color_scalars", "vectors", "tensors"})
      found = found || text.starts_with(key);
  }
  if (!found) throw Error(fmt::format("{}: the VTK file's head has no SCALARS", name));
  header.data.offset = lines.position();  // a LOOKUP_TABLE line may follow: ITK says where it ends
  return header;
}

}  // namespace crest
