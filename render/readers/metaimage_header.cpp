#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/headers.h"
#include "render/volume/query.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct MetaText {
  std::map<std::string, std::string> fields;  ///< to ElementDataFile, which is the last one
  std::vector<std::string> file_list;         ///< the lines after "ElementDataFile = LIST"
  int list_line = 1;                          ///< the number of the first of them
  std::size_t end = 0;                        ///< where they end, and local data begins
};

/// As long as MetaIO, which other programs read the format with, has room for; and no key twice, of which
/// programs take one or the other.
void check_field(const std::string& name, int line, std::string_view key, std::string_view value,
                 bool is_new) {
  constexpr std::size_t longest_line = 4096, longest_text = 254;
  constexpr std::string_view texts[] = {"Comment",        "Name",
                                        "ObjectType",     "ObjectSubType",
                                        "ObjectTypeName", "ObjectSubTypeName",
                                        "DistanceUnits",  "AnatomicalOrientation",
                                        "Modality"};
  constexpr std::string_view once[] = {"NDims", "DimSize", "ElementType", "ElementNumberOfChannels",
                                       "HeaderSize"};
  const bool is_text = std::ranges::find(texts, key) != std::end(texts);
  if (key.size() > longest_text || value.size() > (is_text ? longest_text : longest_line))
    throw Error(fmt::format("{}: line {} of its header is longer than MetaImage's may be", name, line));
  if (!is_new && std::ranges::find(once, key) != std::end(once))
    throw Error(fmt::format("{}: line {} of its header has {} once more", name, line, key));
}

MetaText parse(const std::string& name, std::string_view head) {
  MetaText text;
  HeaderLines lines(head);
  int number = 1;
  for (std::string_view line; !text.fields.contains("ElementDataFile") && lines.next(line); ++number) {
    if (trim(line).empty()) continue;
    const std::size_t equals = line.find_first_of("=:");
    if (equals == std::string_view::npos) break;
    const std::string_view key = trim(line.substr(0, equals)), value = trim(line.substr(equals + 1));
    check_field(name, number, key, value, !text.fields.contains(std::string(key)));
    text.fields[std::string(key)] = value;
  }
  for (const char* key : {"NDims", "DimSize", "ElementType", "ElementDataFile"}) {
    if (!text.fields.contains(key)) {
      throw Error(fmt::format("{}: not a MetaImage header: it has no line \"{} = ...\"", name, key));
    }
  }
  text.end = lines.position();
  text.list_line = number;
  for (std::string_view line; lines.next(line);) text.file_list.emplace_back(trim(line));
  while (!text.file_list.empty() && text.file_list.back().empty()) text.file_list.pop_back();
  return text;
}

std::int64_t integer_of(const std::string& name, const MetaText& text, const std::string& key,
                        std::int64_t fallback, std::int64_t min, std::int64_t max) {
  const auto found = text.fields.find(key);
  if (found == text.fields.end()) return fallback;
  const auto value = to_integer(found->second);
  if (value && *value >= min && *value <= max) return *value;
  throw Error(
      fmt::format("{}: {} = {} is not a whole number in [{}, {}]", name, key, found->second, min, max));
}

bool is_true(const MetaText& text, const std::string& key, bool fallback) {
  const auto found = text.fields.find(key);
  if (found == text.fields.end() || found->second.empty()) return fallback;
  return std::string_view("TtYy1").find(found->second[0]) != std::string_view::npos;
}

std::vector<fs::path> voxel_files(const std::string& name, const fs::path& path, const MetaText& text) {
  const std::string& value = text.fields.at("ElementDataFile");
  if (lower(value) == "local") return {path};
  auto parts = words(value);
  std::vector<fs::path> files;
  if (!parts.empty() && parts[0].starts_with("LIST")) {
    int number = text.list_line;
    for (const std::string& line : text.file_list) {
      if (line.empty()) {
        throw Error(
            fmt::format("{}: line {} of its header, in the list of its files, is empty", name, number));
      }
      files.push_back(path.parent_path() / line);
      ++number;
    }
  } else if (value.find('%') != std::string::npos) {
    if (parts.size() == 1) parts = {parts[0], "1", words(text.fields.at("DimSize")).back()};  // as MetaIO
    files = files_of_pattern(name, path.parent_path(), parts);
  } else {
    files = {path.parent_path() / value};
  }
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file)) {
      throw Error(fmt::format("{}: its ElementDataFile {} is {}", name, file.string(),
                              fs::exists(file) ? "no ordinary file" : "not there"));
    }
  }
  return files;
}

ScalarType type_of(const std::string& name, std::string text) {
  using enum ScalarType;
  static const std::map<std::string_view, ScalarType> types = {
      {"MET_CHAR", int8},     {"MET_UCHAR", uint8},    {"MET_SHORT", int16},     {"MET_USHORT", uint16},
      {"MET_INT", int32},     {"MET_UINT", uint32},    {"MET_LONG", int32},      {"MET_ULONG", uint32},
      {"MET_FLOAT", float32}, {"MET_DOUBLE", float64}, {"MET_LONG_LONG", int64}, {"MET_ULONG_LONG", uint64}};
  if (text.ends_with("_ARRAY")) text.erase(text.size() - 6);
  const auto found = types.find(text);
  if (found != types.end()) return found->second;
  throw Error(fmt::format("{}: its voxels are of a type ({}) that is not read; MET_CHAR to MET_DOUBLE are",
                          name, one_line(text)));
}

/// The numbers of the first of `keys` that is there; none when there is none.
std::vector<double> numbers_of(const std::string& name, const MetaText& text,
                               std::initializer_list<const char*> keys, std::size_t count) {
  for (const char* key : keys) {
    const auto found = text.fields.find(key);
    if (found == text.fields.end()) continue;
    std::vector<double> numbers;
    for (const std::string& word : words(found->second))
      numbers.push_back(to_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    if (numbers.size() >= count) return numbers;
    throw Error(fmt::format("{}: {} = {} has {} numbers, and needs {}", name, key, one_line(found->second),
                            numbers.size(), count));
  }
  return {};
}

void take_layout(const std::string& name, const MetaText& text, std::size_t axes, VoxelHeader& header) {
  const auto sizes = numbers_of(name, text, {"DimSize"}, axes);
  if (sizes.size() > axes)
    throw Error(fmt::format("{}: DimSize = {} has {} numbers, and NDims is {}", name,
                            one_line(text.fields.at("DimSize")), sizes.size(), axes));
  std::vector<std::uint64_t> dims;
  for (std::size_t a = 0; a < axes; ++a) {
    constexpr double most = 0x1p53;
    if (!(sizes[a] >= 1 && sizes[a] < most) || sizes[a] != std::floor(sizes[a]))
      throw Error(fmt::format("{}: DimSize = {} are not numbers of points", name,
                              one_line(text.fields.at("DimSize"))));
    dims.push_back(std::uint64_t(sizes[a]));
  }
  while (dims.size() > 3 && dims.back() == 1) dims.pop_back();
  if (dims.size() < 3 || dims.size() > 4) {
    throw Error(
        fmt::format("{}: it has {} dimensions, and a volume has three{}", name, dims.size(),
                    dims.size() == 2 ? ": put its slices into one file, or open a folder of images" : ""));
  }
  const auto channels = std::uint64_t(integer_of(name, text, "ElementNumberOfChannels", 1, 1, 1024));
  header.layout = interleaved({dims[0], dims[1], dims[2]}, channels, dims.size() > 3 ? dims[3] : 1);
}

void take_geometry(const std::string& name, const MetaText& text, std::size_t axes, VoxelHeader& header) {
  const auto spacing = numbers_of(name, text, {"ElementSpacing", "ElementSize"}, axes);
  const auto origin = numbers_of(name, text, {"Offset", "Position", "Origin"}, axes);
  const auto direction = numbers_of(name, text, {"TransformMatrix", "Rotation", "Orientation"}, axes * axes);
  for (std::size_t a = 0; a < 3; ++a) {
    if (!spacing.empty()) header.spacing[int(a)] = spacing[a];
    if (!origin.empty()) header.origin[int(a)] = origin[a];
    glm::dvec3 axis(0);
    for (std::size_t row = 0; row < 3 && !direction.empty(); ++row)
      axis[int(row)] = direction[a * axes + row];
    if (!direction.empty()) header.direction[int(a)] = glm::normalize(axis);
  }
  const auto anatomy = text.fields.find("AnatomicalOrientation");
  header.is_in_patient =
      !direction.empty() && anatomy != text.fields.end() && anatomy->second.find('?') == std::string::npos;
}

void take_data(const std::string& name, const fs::path& path, const MetaText& text, VoxelHeader& header) {
  constexpr std::int64_t most_bytes = std::int64_t(1) << 60;
  VoxelData& data = header.data;
  data.files = voxel_files(name, path, text);
  if (is_true(text, "CompressedData", false)) data.encoding = Encoding::deflate;
  if (!is_true(text, "BinaryData", true)) data.encoding = Encoding::decimal;
  if (data.files == std::vector{path}) {
    data.offset = text.end;
    data.first_line = std::size_t(text.list_line);
  }
  const std::int64_t skip = integer_of(name, text, "HeaderSize", 0, -1, most_bytes);
  if (skip > 0) data.offset = std::uint64_t(skip);
  data.at_file_end = skip == -1 && data.encoding == Encoding::raw;
  const bool big_endian =
      is_true(text, "BinaryDataByteOrderMSB", is_true(text, "ElementByteOrderMSB", false));
  header.endian = big_endian ? std::endian::big : std::endian::little;
}

}  // namespace

VoxelHeader read_metaimage_header(const fs::path& path) {
  const std::string name = path.string();
  const MetaText text = parse(name, read_head(path, longest_header));
  const auto axes = std::size_t(integer_of(name, text, "NDims", 0, 1, 10));
  VoxelHeader header;
  take_layout(name, text, axes, header);
  take_geometry(name, text, axes, header);
  header.type = type_of(name, text.fields.at("ElementType"));
  take_data(name, path, text, header);
  for (const char* key : {"ElementToIntensityFunctionSlope", "ElementToIntensityFunctionOffset"}) {
    if (text.fields.contains(key)) add_note(header.note, fmt::format("{} is not applied", key));
  }
  return header;
}

}  // namespace crest
