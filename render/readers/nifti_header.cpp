// NIfTI-1 and NIfTI-2 (nifti.nimh.nih.gov), in one file or as a pair, and Analyze 7.5, which the first one's
// header is compatible with.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/binary_fields.h"
#include "render/readers/headers.h"
#include "render/readers/select_one.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// Both versions' fields, in one form.
struct Nifti {
  bool swapped = false, is_second = false, is_analyze = false, is_pair = false;
  std::int64_t dim[8] = {};
  int datatype = 0, qform = 0, sform = 0, units = 0;
  double pixdim[8] = {};
  double offset = 0, slope = 0, intercept = 0;
  double quaternion[3] = {}, quaternion_offset[3] = {}, rows[3][4] = {};
};

constexpr std::size_t first_size = 348, second_size = 540;

Nifti parse_first(const BinaryFields& f) {
  Nifti n;
  n.swapped = f.swapped;
  const std::string_view magic = f.bytes.substr(344, 3);
  n.is_analyze = magic != "n+1" && magic != "ni1";
  n.is_pair = magic != "n+1";
  for (std::size_t i = 0; i < 8; ++i) n.dim[i] = f.at<std::int16_t>(40 + 2 * i);
  for (std::size_t i = 0; i < 8; ++i) n.pixdim[i] = f.at<float>(76 + 4 * i);
  n.datatype = f.at<std::int16_t>(70);
  n.offset = f.at<float>(108);
  n.slope = f.at<float>(112);
  if (n.is_analyze) return n;
  n.intercept = f.at<float>(116);
  n.units = f.bytes[123];
  n.qform = f.at<std::int16_t>(252);
  n.sform = f.at<std::int16_t>(254);
  for (std::size_t i = 0; i < 3; ++i) n.quaternion[i] = f.at<float>(256 + 4 * i);
  for (std::size_t i = 0; i < 3; ++i) n.quaternion_offset[i] = f.at<float>(268 + 4 * i);
  for (std::size_t i = 0; i < 12; ++i) n.rows[i / 4][i % 4] = f.at<float>(280 + 4 * i);
  return n;
}

Nifti parse_second(const BinaryFields& f) {
  Nifti n;
  n.swapped = f.swapped;
  n.is_second = true;
  n.is_pair = f.bytes.substr(4, 3) == "ni2";
  for (std::size_t i = 0; i < 8; ++i) n.dim[i] = f.at<std::int64_t>(16 + 8 * i);
  for (std::size_t i = 0; i < 8; ++i) n.pixdim[i] = f.at<double>(104 + 8 * i);
  n.datatype = f.at<std::int16_t>(12);
  n.offset = double(f.at<std::int64_t>(168));
  n.slope = f.at<double>(176);
  n.intercept = f.at<double>(184);
  n.units = f.at<std::int32_t>(500);
  n.qform = f.at<std::int32_t>(344);
  n.sform = f.at<std::int32_t>(348);
  for (std::size_t i = 0; i < 3; ++i) n.quaternion[i] = f.at<double>(352 + 8 * i);
  for (std::size_t i = 0; i < 3; ++i) n.quaternion_offset[i] = f.at<double>(376 + 8 * i);
  for (std::size_t i = 0; i < 12; ++i) n.rows[i / 4][i % 4] = f.at<double>(400 + 8 * i);
  return n;
}

Nifti parse(const std::string& name, std::string_view head) {
  for (const bool swapped : {false, true}) {
    const BinaryFields fields{head, swapped};
    const auto size = head.size() < first_size ? 0 : fields.at<std::int32_t>(0);
    if (size == std::int32_t(first_size)) return parse_first(fields);
    if (size == std::int32_t(second_size) && head.size() >= second_size) return parse_second(fields);
  }
  throw Error(fmt::format("{}: not a NIfTI file: its header's size is neither 348 nor 540", name));
}

struct Stored {
  ScalarType type;
  std::uint64_t components = 1;  ///< 2 of a complex number, 3 and 4 of a colour
};

Stored stored_type(const std::string& name, int code) {
  using enum ScalarType;
  switch (code) {
    case 2:
      return {uint8};
    case 4:
      return {int16};
    case 8:
      return {int32};
    case 16:
      return {float32};
    case 32:
      return {float32, 2};
    case 64:
      return {float64};
    case 128:
      return {uint8, 3};
    case 256:
      return {int8};
    case 512:
      return {uint16};
    case 768:
      return {uint32};
    case 1024:
      return {int64};
    case 1280:
      return {uint64};
    case 1792:
      return {float64, 2};
    case 2304:
      return {uint8, 4};
    default:
      throw Error(
          fmt::format("{}: its voxels are of a type (NIfTI datatype {}) that is not read; int8 to float64, "
                      "complex and RGB are",
                      name, code));
  }
}

void take_layout(const std::string& name, const Nifti& n, std::uint64_t parts, VoxelLayout& layout) {
  std::int64_t axes = n.dim[0];
  if (axes < 1 || axes > 7)
    throw Error(fmt::format("{}: it has {} dimensions, and a volume has three", name, axes));
  while (axes > 3 && n.dim[axes] <= 1) --axes;  // some programs write 0 for what is not there
  if (axes < 3 || axes > 5) {
    throw Error(fmt::format("{}: it has {} dimensions, and a volume has three{}", name, axes,
                            axes == 2 ? ": put its slices into one file, or open a folder of images" : ""));
  }
  for (std::int64_t i = 1; i <= 3; ++i) {
    if (n.dim[i] < 1) throw Error(fmt::format("{}: axis {} has {} points", name, i, n.dim[i]));
  }
  const auto size = [&](int i) { return i <= axes ? std::uint64_t(std::max<std::int64_t>(n.dim[i], 1)) : 1; };
  if (parts > 1 && size(5) > 1)
    throw Error(fmt::format("{}: vectors of colours or of complex numbers are not read", name));
  layout = interleaved({size(1), size(2), size(3)}, parts, size(4));
  if (size(5) == 1) return;
  layout.components = size(5);  // the slowest axis
  layout.component_stride = layout.frame_stride * layout.frames;
}

/// Columns from the quaternion, by the standard's formula.
glm::dmat3 rotation_of(const Nifti& n) {
  const double b = n.quaternion[0], c = n.quaternion[1], d = n.quaternion[2];
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  glm::dmat3 r;
  r[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  r[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  r[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c};
  if (n.pixdim[0] < 0) r[2] = -r[2];
  return r;
}

/// From the sform where there is one, else from the qform; in DICOM's coordinates, to the left and the back.
void take_geometry(const Nifti& n, VoxelHeader& header) {
  constexpr double tolerance = 0.01;
  constexpr int metres = 1, micrometres = 3, space_units = 7;
  const int units = n.units & space_units;
  const double millimetres = units == metres ? 1e3 : units == micrometres ? 1e-3 : 1;
  for (int i = 0; i < 3; ++i) header.spacing[i] = std::abs(n.pixdim[i + 1]) * millimetres;
  const glm::dvec3 to_lps(-1, -1, 1);
  header.is_in_patient = n.sform > 0 || n.qform > 0;
  if (n.sform > 0) {
    for (int column = 0; column < 3; ++column) {
      const glm::dvec3 vector(n.rows[0][column], n.rows[1][column], n.rows[2][column]);
      header.direction[column] = to_lps * vector / glm::length(vector);
      const double length = glm::length(vector) * millimetres, spacing = header.spacing[column];
      if (!(spacing > 0))
        header.spacing[column] = length;
      else if (std::abs(length - spacing) > tolerance * spacing)
        add_note(header.note,
                 fmt::format("on axis {} its sform says a spacing of {:.6g}, and its pixdim {:.6g}, "
                             "which is taken",
                             column + 1, length, spacing));
    }
    header.origin = to_lps * glm::dvec3(n.rows[0][3], n.rows[1][3], n.rows[2][3]) * millimetres;
  } else if (n.qform > 0) {
    const glm::dmat3 rotation = rotation_of(n);
    for (int column = 0; column < 3; ++column) header.direction[column] = to_lps * rotation[column];
    const auto& o = n.quaternion_offset;
    header.origin = to_lps * glm::dvec3(o[0], o[1], o[2]) * millimetres;
  }
}

void take_scaling(const Nifti& n, VoxelHeader& header) {
  if (n.is_analyze) {
    add_note(header.note, "an Analyze file, which does not tell left from right");
    if (n.slope != 0 && n.slope != 1 && std::isfinite(n.slope))
      add_note(header.note, fmt::format("SPM's scale factor {} is not applied", n.slope));
    return;
  }
  if (n.slope == 0 || (std::isnan(n.slope) && std::isnan(n.intercept))) return;  // there is no scaling at all
  if (std::isfinite(n.slope) && std::isfinite(n.intercept))
    header.scaling = {n.slope, n.intercept};
  else
    add_note(header.note, fmt::format("its slope {} and intercept {} are no numbers, and not applied",
                                      n.slope, n.intercept));
}

bool is_compressed(const fs::path& path) { return read_head(path, 2) == "\x1f\x8b"; }

/// The other file of a pair: NAME.hdr and NAME.img, either of which may be compressed.
fs::path other_of_pair(const fs::path& path, const std::string& extension) {
  fs::path stem = path;
  if (lower(stem.extension().string()) == ".gz") stem.replace_extension();
  const bool upper = stem.extension().string().find_first_of("HI") != std::string::npos;
  std::string wanted = extension;
  if (upper)
    for (char& c : wanted) c = char(std::toupper(c));
  for (const char* more : {"", ".gz"}) {
    const fs::path other = fs::path(stem).replace_extension(wanted).string() + more;
    if (fs::is_regular_file(other)) return other;
  }
  throw Error(fmt::format("{}: the other file of the pair, {}, is not there", path.string(),
                          fs::path(stem).replace_extension(wanted).filename().string()));
}

bool is_image_of_pair(const fs::path& path) {
  const std::string file = lower(path.filename().string());
  return file.ends_with(".img") || file.ends_with(".img.gz");
}

}  // namespace

VoxelHeader read_nifti_header(const fs::path& path) {
  const std::string name = path.string();
  const fs::path head_file = is_image_of_pair(path) ? other_of_pair(path, ".hdr") : path;
  const std::string head = read_head(head_file, second_size, is_compressed(head_file));
  const Nifti n = parse(name, head);
  const Stored stored = stored_type(name, n.datatype);
  if (!(n.offset >= 0 && n.offset < 0x1p60))
    throw Error(fmt::format("{}: vox_offset {} is not a place in the file", name, n.offset));
  VoxelHeader header;
  header.type = stored.type;
  header.endian =
      n.swapped == (std::endian::native == std::endian::little) ? std::endian::big : std::endian::little;
  take_layout(name, n, stored.components, header.layout);
  const bool is_colour = stored.components > 2;
  header.component_names = stored.components == 2 ? complex_names() : colour_names(stored.components);
  const fs::path image = n.is_pair ? other_of_pair(head_file, ".img") : head_file;
  header.data = {{image}, 0, is_compressed(image) ? Encoding::deflate : Encoding::raw};
  header.data.skip = std::uint64_t(n.offset);
  if (!n.is_pair) {
    constexpr std::size_t extension_flag = 4;
    const std::size_t unsaid = (n.is_second ? second_size : first_size) + extension_flag;
    header.data.skip = n.offset == 0 ? unsaid : std::max(header.data.skip, std::uint64_t(first_size));
  }
  take_geometry(n, header);
  if (!is_colour) take_scaling(n, header);
  return header;
}

}  // namespace crest
