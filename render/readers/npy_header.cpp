// NumPy's .npy, versions 1 to 3 (numpy.lib.format).
#include <fmt/core.h>

#include <optional>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/binary_fields.h"
#include "render/readers/headers.h"
#include "render/readers/select_one.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct NpyText {
  std::string dictionary;
  std::size_t end = 0;  ///< where the values begin
};

NpyText read_dictionary(const fs::path& path) {
  constexpr std::string_view magic = "\x93NUMPY";
  const std::string name = path.string(), head = read_head(path, 12);
  if (head.size() < 12 || !head.starts_with(magic))
    throw Error(fmt::format("{}: not a NumPy file: it does not begin with \\x93NUMPY", name));
  const int version = head[6];
  if (version < 1 || version > 3)
    throw Error(fmt::format("{}: NumPy format {} is not read; 1 to 3 are", name, version));
  const BinaryFields fields{head, std::endian::native != std::endian::little};
  const std::size_t begin = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? fields.at<std::uint16_t>(8) : fields.at<std::uint32_t>(8);
  if (length > longest_header) throw Error(fmt::format("{}: its header is too long", name));
  const std::string whole = read_head(path, begin + length);
  if (whole.size() < begin + length) throw Error(fmt::format("{}: its header ends early", name));
  return {whole.substr(begin), begin + length};
}

/// The text of one of the dictionary's values: "'<f4'", "False", "(5, 6, 8)".
std::string value_of(const std::string& name, const std::string& dictionary, const std::string& key) {
  for (const char quote : {'\'', '"'}) {
    const std::size_t at = dictionary.find(quote + key + quote);
    if (at == std::string::npos) continue;
    const std::size_t colon = dictionary.find(':', at);
    if (colon == std::string::npos) break;
    const std::string_view rest = trim(std::string_view(dictionary).substr(colon + 1));
    const char closing = rest.starts_with('(') ? ')' : rest.starts_with('[') ? ']' : ',';
    const std::size_t end = rest.find_first_of(closing == ',' ? ",}" : std::string(1, closing));
    if (end == std::string_view::npos) break;
    return std::string(trim(rest.substr(0, closing == ',' ? end : end + 1)));
  }
  throw Error(fmt::format("{}: the NumPy header has no \"{}\"", name, key));
}

void take_type(const std::string& name, std::string text, VoxelHeader& header, std::uint64_t& parts) {
  using enum ScalarType;
  static constexpr std::pair<std::string_view, ScalarType> types[] = {
      {"b1", uint8},   {"i1", int8},    {"u1", uint8},   {"i2", int16},   {"u2", uint16},
      {"i4", int32},   {"u4", uint32},  {"i8", int64},   {"u8", uint64},  {"f2", float16},
      {"f4", float32}, {"f8", float64}, {"c8", float32}, {"c16", float64}};
  if (text.size() > 2 && (text[0] == '\'' || text[0] == '"')) text = text.substr(1, text.size() - 2);
  const char order = text.empty() ? ' ' : text[0];
  const std::string_view kind = text.empty() ? std::string_view() : std::string_view(text).substr(1);
  for (const auto& [word, type] : types) {
    if (kind != word) continue;
    header.type = type;
    header.endian = order == '>'   ? std::endian::big
                    : order == '=' ? std::endian::native
                                   : std::endian::little;
    parts = word[0] == 'c' ? 2 : 1;
    return;
  }
  throw Error(fmt::format(
      "{}: numbers of NumPy's type {} are not read; those of i1 to i8, u1 to u8, f2 to f8, c8 and "
      "c16 are",
      name, one_line(text.substr(0, 60))));
}

std::vector<std::uint64_t> shape_of(const std::string& name, const std::string& text) {
  std::vector<std::uint64_t> shape;
  std::uint64_t all = 1;
  for (const std::string_view part : split(std::string_view(text).substr(1, text.size() - 2), ',')) {
    std::string_view digits = trim(part);
    if (digits.empty()) continue;
    if (digits.ends_with('L')) digits.remove_suffix(1);  // of Python 2
    const auto size = to_integer(digits);
    const auto product = size && *size > 0 ? checked_product(all, std::uint64_t(*size)) : std::nullopt;
    if (!product)
      throw Error(fmt::format("{}: its shape {} is none that can be counted", name, one_line(text)));
    shape.push_back(std::uint64_t(*size));
    all = *product;
  }
  return shape;
}

/// Of a[z][y][x] the last axis is x. A fourth one counts frames in front, or components behind, where it is
/// short.
void take_layout(const std::string& name, std::vector<std::uint64_t> shape, bool fortran, std::uint64_t parts,
                 VoxelHeader& header) {
  constexpr std::uint64_t most_colours = 4;
  std::vector<std::uint64_t> stride(shape.size(), parts);
  for (std::size_t a = 1; a < shape.size(); ++a) {
    if (fortran)
      stride[a] = stride[a - 1] * shape[a - 1];
    else
      stride[shape.size() - 1 - a] = stride[shape.size() - a] * shape[shape.size() - a];
  }
  while (shape.size() > 3 && shape.front() == 1) shape.erase(shape.begin()), stride.erase(stride.begin());
  while (shape.size() > 3 && shape.back() == 1) shape.pop_back(), stride.pop_back();
  const std::size_t axes = shape.size();
  const bool colours = axes == 5 || (axes == 4 && shape[3] <= most_colours && shape[0] > most_colours);
  if (axes < 3 || axes > 5 || (colours && parts > 1)) {
    throw Error(fmt::format("{}: it has {} dimensions, and a volume has three{}", name, axes,
                            axes == 2 ? ": stack its slices into one array" : ""));
  }
  VoxelLayout& layout = header.layout;
  layout.components = colours ? shape.back() : parts;
  layout.component_stride = colours ? stride.back() : 1;
  const std::size_t first = axes - (colours ? 4 : 3);
  if (first > 0) layout.frames = shape[0], layout.frame_stride = stride[0];
  for (std::size_t a = 0; a < 3; ++a) {
    layout.dims[int(2 - a)] = shape[first + a];
    layout.stride[int(2 - a)] = stride[first + a];
  }
  if (axes > 3) {
    add_note(header.note, fmt::format("its axes are taken as {}z, y, x{}", first > 0 ? "frames, " : "",
                                      colours ? ", components" : ""));
  }
}

}  // namespace

VoxelHeader read_npy_header(const fs::path& path) {
  const std::string name = path.string();
  const NpyText text = read_dictionary(path);
  VoxelHeader header;
  std::uint64_t parts = 1;
  take_type(name, value_of(name, text.dictionary, "descr"), header, parts);
  const std::string shape = value_of(name, text.dictionary, "shape");
  if (!shape.starts_with('(')) throw Error(fmt::format("{}: its shape {} is none", name, one_line(shape)));
  const bool fortran = value_of(name, text.dictionary, "fortran_order") == "True";
  take_layout(name, shape_of(name, shape), fortran, parts, header);
  if (parts == 2) header.component_names = complex_names();
  header.data = {{path}, text.end, Encoding::raw};
  return header;
}

}  // namespace crest
