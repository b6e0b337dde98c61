#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/headers.h"
#include "render/volume/query.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct NrrdText {
  NrrdFields fields;
  std::vector<std::string> file_list;  ///< the lines after "data file: LIST"
  std::size_t end = 0;                 ///< where an attached header ends
  std::size_t lines = 0;               ///< in it
  bool attached = false;
};

/// A field's name, of which the format has some in one word too.
std::string key_of(std::string_view text) {
  static const std::map<std::string_view, std::string_view> spellings = {
      {"datafile", "data file"}, {"lineskip", "line skip"}, {"byteskip", "byte skip"},
      {"axismins", "axis mins"}, {"axismaxs", "axis maxs"}, {"centerings", "centers"}};
  std::string key = lower(trim(text));
  std::erase(key, '\t');
  const auto found = spellings.find(key);
  return found == spellings.end() ? key : std::string(found->second);
}

/// "LIST", and the number of a file's axes behind it.
bool is_list_of_files(const std::string& value) {
  const auto parts = words(value);
  return !parts.empty() && parts[0] == "LIST";
}

NrrdText parse(const std::string& name, std::string_view head) {
  if (!head.starts_with("NRRD000"))
    throw Error(fmt::format("{}: not an NRRD file: it does not begin with NRRD000", name));
  NrrdText text;
  HeaderLines lines(head);
  bool is_list = false;  // of files, to the header's end
  for (std::string_view line; lines.next(line);) {
    ++text.lines;
    if (is_list) {
      if (!trim(line).empty()) text.file_list.emplace_back(line);
      continue;
    }
    if (line.empty()) {
      text.attached = !text.fields.contains("data file");
      break;
    }
    if (line.starts_with('#')) continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string_view::npos && line.substr(colon).starts_with(": ")) {
      const std::string key = key_of(line.substr(0, colon));
      const auto [field, is_new] = text.fields.emplace(key, trim(line.substr(colon + 1)));
      if (!is_new) throw Error(fmt::format("{}: the NRRD header has \"{}\" twice", name, key));
      is_list = key == "data file" && is_list_of_files(field->second);
    }
  }
  text.end = lines.position();
  if (!text.attached && !text.fields.contains("data file")) {
    throw Error(fmt::format("{}: the NRRD header has neither an end (an empty line) nor a data file", name));
  }
  return text;
}

ScalarType type_of(const std::string& name, const std::string& text) {
  using enum ScalarType;
  static const std::map<std::string_view, ScalarType> types = {{"signed char", int8},
                                                               {"int8", int8},
                                                               {"int8_t", int8},
                                                               {"uchar", uint8},
                                                               {"unsigned char", uint8},
                                                               {"uint8", uint8},
                                                               {"uint8_t", uint8},
                                                               {"short", int16},
                                                               {"short int", int16},
                                                               {"signed short", int16},
                                                               {"signed short int", int16},
                                                               {"int16", int16},
                                                               {"int16_t", int16},
                                                               {"ushort", uint16},
                                                               {"unsigned short", uint16},
                                                               {"unsigned short int", uint16},
                                                               {"uint16", uint16},
                                                               {"uint16_t", uint16},
                                                               {"int", int32},
                                                               {"signed int", int32},
                                                               {"int32", int32},
                                                               {"int32_t", int32},
                                                               {"uint", uint32},
                                                               {"unsigned int", uint32},
                                                               {"uint32", uint32},
                                                               {"uint32_t", uint32},
                                                               {"longlong", int64},
                                                               {"long long", int64},
                                                               {"long long int", int64},
                                                               {"signed long long", int64},
                                                               {"signed long long int", int64},
                                                               {"int64", int64},
                                                               {"int64_t", int64},
                                                               {"ulonglong", uint64},
                                                               {"unsigned long long", uint64},
                                                               {"unsigned long long int", uint64},
                                                               {"uint64", uint64},
                                                               {"uint64_t", uint64},
                                                               {"float", float32},
                                                               {"double", float64}};
  const auto found = types.find(lower(text));
  if (found != types.end()) return found->second;
  throw Error(fmt::format("{}: its voxels are of a type (\"{}\") that is not read; int8 to double are", name,
                          one_line(text)));
}

std::endian endian_of(const std::string& name, const NrrdText& text, ScalarType type, Encoding encoding) {
  const auto found = text.fields.find("endian");
  if (found != text.fields.end()) {
    const std::string endian = lower(found->second);
    if (endian == "little") return std::endian::little;
    if (endian == "big") return std::endian::big;
    throw Error(fmt::format("{}: endian: {} is neither little nor big", name, one_line(found->second)));
  }
  if (size_of(type) == 1 || encoding == Encoding::decimal) return std::endian::native;
  throw Error(fmt::format("{}: the NRRD header has no \"endian\" (little or big), which voxels of {} need",
                          name, name_of(type)));
}

/// A header has at most 16 axes, with short words for each.
void require_few_words(const std::string& name, const NrrdText& text) {
  constexpr std::size_t most_axes = 16, longest_word = 128, longest_labels = 4096;
  for (const char* key : {"sizes", "kinds", "spacings", "thicknesses", "centers", "axis mins", "axis maxs",
                          "space directions", "space origin"}) {
    const auto found = text.fields.find(key);
    if (found == text.fields.end()) continue;
    const std::string& value = found->second;
    const auto count = value.find('(') == std::string::npos ? std::ptrdiff_t(words(value).size())
                                                            : std::ranges::count(value, '(');
    const auto is_long = [](const std::string& word) { return word.size() > longest_word; };
    if (std::ranges::any_of(words(value), is_long))
      throw Error(fmt::format("{}: {} has a word of over {} characters", name, key, longest_word));
    if (count > std::ptrdiff_t(most_axes))
      throw Error(fmt::format("{}: {} of {} axes: NRRD has at most {}", name, key, count, most_axes));
  }
  for (const char* key : {"labels", "units", "space units"}) {
    const auto found = text.fields.find(key);
    if (found != text.fields.end() && found->second.size() > longest_labels)
      throw Error(fmt::format("{}: its {} are longer than {} bytes", name, key, longest_labels));
  }
}

Encoding encoding_of(const std::string& name, const std::string& text) {
  const std::string encoding = lower(text);
  if (encoding == "raw") return Encoding::raw;
  if (encoding == "gzip" || encoding == "gz") return Encoding::deflate;
  if (encoding == "ascii" || encoding == "text" || encoding == "txt") return Encoding::decimal;
  if (encoding == "hex") return Encoding::hexadecimal;
  throw Error(fmt::format("{}: NRRD encoding \"{}\" is not read; raw, gzip, ascii and hex are", name, text));
}

std::vector<fs::path> voxel_files(const std::string& name, const fs::path& folder, const NrrdText& text) {
  const std::string& value = text.fields.at("data file");
  const auto parts = words(value);
  std::vector<fs::path> files;
  if (is_list_of_files(value)) {
    for (const std::string& line : text.file_list) files.push_back(folder / line);
  } else if (value.find('%') != std::string::npos) {
    files = files_of_pattern(name, folder, parts);
  } else {
    files = {folder / value};
  }
  for (const fs::path& file : files) {
    const std::string file_name = lower(file.filename().string());
    if (file_name.ends_with(".nii") || file_name.ends_with(".nii.gz")) {
      throw Error(fmt::format("{}: its data file {} is a NIfTI file: open that one", name, file.string()));
    }
    if (!fs::is_regular_file(file)) {
      throw Error(fmt::format("{}: its data file {} is {}", name, file.string(),
                              fs::exists(file) ? "no ordinary file" : "not there"));
    }
  }
  return files;
}

std::int64_t skip_of(const std::string& name, const NrrdText& text, const std::string& key,
                     std::int64_t least) {
  const auto found = text.fields.find(key);
  if (found == text.fields.end()) return 0;
  const auto skip = to_integer(found->second);
  if (!skip || *skip < least || *skip > std::int64_t(1) << 60) {
    throw Error(fmt::format("{}: {}: {} is not a number from {} on", name, key, found->second, least));
  }
  return *skip;
}

/// Where the data begins after `count` lines from `offset` on.
std::uint64_t after_lines(const std::string& name, const fs::path& file, std::uint64_t offset,
                          std::int64_t count) {
  if (count == 0) return offset;
  const std::string head = read_head(file, std::size_t(offset) + longest_header);
  HeaderLines lines(std::string_view(head).substr(std::min(std::size_t(offset), head.size())));
  std::string_view line;
  for (std::int64_t i = 0; i < count; ++i) {
    if (!lines.next(line))
      throw Error(fmt::format("{}: line skip: the file has no {} lines to skip", name, count));
  }
  return offset + lines.position();
}

}  // namespace

VoxelHeader read_nrrd_header(const fs::path& path) {
  const std::string name = path.string();
  const NrrdText text = parse(name, read_head(path, longest_header));
  for (const char* key : {"type", "dimension", "sizes", "encoding"}) {
    if (!text.fields.contains(key)) throw Error(fmt::format("{}: the NRRD header has no \"{}\"", name, key));
  }
  require_few_words(name, text);
  VoxelHeader header;
  take_nrrd_axes(name, text.fields, header);
  header.type = type_of(name, text.fields.at("type"));
  header.data.encoding = encoding_of(name, text.fields.at("encoding"));
  header.endian = endian_of(name, text, header.type, header.data.encoding);
  if (text.attached) {
    header.data.files = {path};
    header.data.offset = text.end;
    header.data.first_line = text.lines + 1;
  } else {
    header.data.files = voxel_files(name, path.parent_path(), text);
  }
  const std::int64_t line_skip = skip_of(name, text, "line skip", 0);
  const std::int64_t byte_skip = skip_of(name, text, "byte skip", -1);
  if (line_skip > 0 && header.data.files.size() > 1)
    throw Error(fmt::format("{}: line skip is read with one data file only", name));
  if (header.data.files.size() == 1) {
    header.data.offset = after_lines(name, header.data.files[0], header.data.offset, line_skip);
    header.data.first_line += std::size_t(line_skip);
  }
  constexpr std::int64_t most_inflated = std::int64_t(1) << 26;
  if (header.data.encoding == Encoding::deflate && (byte_skip < 0 || byte_skip > most_inflated)) {
    throw Error(fmt::format("{}: byte skip: {} in compressed data; it is from 0 to {}", name, byte_skip,
                            most_inflated));
  }
  const bool is_text =
      header.data.encoding == Encoding::decimal || header.data.encoding == Encoding::hexadecimal;
  if (is_text && byte_skip < 0)
    throw Error(fmt::format("{}: byte skip: -1 in a text; it is for raw voxels", name));
  if (byte_skip > 0) (is_text ? header.data.offset : header.data.skip) += std::uint64_t(byte_skip);
  header.data.at_file_end = byte_skip == -1;
  return header;
}

}  // namespace crest
