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

struct MetaText {
  std::map<std::string, std::string> fields;  ///< to ElementDataFile, which is the last one
  std::vector<std::string> file_list;         ///< the lines after "ElementDataFile = LIST"
  int list_line = 1;                          ///< the number of the first of them
  std::size_t end = 0;                        ///< where they end, and local data begins
};

/// MetaIO reads keys and some values into buffers of a fixed size, and of a key that is there twice the
/// first.
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
  const auto parts = words(value);
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
    files = files_of_pattern(name, path.parent_path(), parts);
  } else {
    files = {path.parent_path() / value};
  }
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file)) {
      throw Error(fmt::format("{}: its ElementDataFile {} is not there", name, file.string()));
    }
  }
  return files;
}

}  // namespace

FileHeader read_metaimage_header(const fs::path& path) {
  constexpr std::int64_t most_bytes = std::int64_t(1) << 60;
  const std::string name = path.string();
  const MetaText text = parse(name, read_head(path, longest_header));
  integer_of(name, text, "NDims", 0, 1, 10);  // MetaIO's arrays have 10 places
  integer_of(name, text, "ElementNumberOfChannels", 1, 1, 1024);
  FileHeader header;
  header.data.files = voxel_files(name, path, text);
  const bool local = header.data.files == std::vector{path};
  if (is_true(text, "CompressedData", false)) header.data.encoding = Encoding::deflate;
  if (!is_true(text, "BinaryData", true)) header.data.encoding = Encoding::decimal;
  if (local) header.data.offset = text.end;
  const std::int64_t skip = integer_of(name, text, "HeaderSize", 0, -1, most_bytes);
  if (skip > 0) header.data.offset = std::uint64_t(skip);
  if (header.data.encoding == Encoding::deflate) {
    const bool big_endian =
        is_true(text, "BinaryDataByteOrderMSB", is_true(text, "ElementByteOrderMSB", false));
    header.inflate_here = big_endian ? std::endian::big : std::endian::little;
  }
  return header;
}

}  // namespace crest
