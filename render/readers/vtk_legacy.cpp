#include "render/readers/vtk_legacy.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/text_voxels.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// Words and lines of the file, with the place that they end at.
class Scanner {
 public:
  explicit Scanner(const fs::path& path)
      : name_(path.string()), file_(path, std::ios::binary), size_(fs::file_size(path)) {}

  /// To the line's end, which is taken too. Throws Error for what is too long for a header.
  std::string line() {
    std::string text;
    for (char c; get(c) && c != '\n';) {
      text += c;
      if (text.size() > longest) fail("it is too long");
    }
    return std::string(trim(text));
  }
  /// The next word, which may be lines away, in lower case; empty at the file's end.
  std::string word() {
    std::string text;
    for (char c; get(c);) {
      const bool blank = trim(std::string_view(&c, 1)).empty();
      if (blank && text.empty()) continue;
      if (blank) {
        back(c);
        break;
      }
      text += c;
      if (text.size() > longest) fail("it is too long");
    }
    return text;
  }
  std::uint64_t count(std::string_view of) {
    const std::string text = word();
    const auto value = to_integer(text);
    if (!value || *value < 0)
      fail(fmt::format("{}: \"{}\" is not a count", of, one_line(text.substr(0, 40))));
    return std::uint64_t(*value);
  }
  double number(std::string_view of) {
    const std::string text = word();
    const auto value = to_number(text);
    if (!value) fail(fmt::format("{}: \"{}\" is not a number", of, one_line(text.substr(0, 40))));
    return *value;
  }
  std::optional<unsigned char> byte() {
    char c = 0;
    return get(c) ? std::optional(static_cast<unsigned char>(c)) : std::nullopt;
  }
  bool at_end() const { return position_ >= size_; }
  /// Past bytes, or as many words; false where the file ends before.
  bool skip_bytes(std::uint64_t bytes) {
    if (bytes > size_ - std::min(size_, position_)) return false;
    go_to(position_ + bytes);
    return true;
  }
  bool skip_words(std::uint64_t words) {
    file_.clear();
    file_.seekg(std::streamoff(position_));
    WordStream stream(file_, line_);
    std::string_view text;
    for (std::uint64_t i = 0; i < words; ++i)
      if (!stream.next(text)) return false;
    line_ = stream.line();
    go_to(position_ + stream.taken());
    return true;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: line {} of the VTK file: {}", name_, line_, what));
  }
  std::uint64_t position() const { return position_; }
  std::size_t line_number() const { return line_; }
  /// Back to an earlier place.
  void go_back(std::uint64_t position, std::size_t line) {
    go_to(position);
    line_ = line;
  }

 private:
  static constexpr std::size_t longest = 4096;
  bool get(char& c) {
    if (!file_.get(c)) return false;
    ++position_;
    line_ += c == '\n';
    return true;
  }
  void back(char c) {
    file_.clear();
    file_.unget();
    --position_;
    line_ -= c == '\n';
  }
  void go_to(std::uint64_t position) {
    file_.clear();
    file_.seekg(std::streamoff(position));
    position_ = position;
  }

  std::string name_;
  std::ifstream file_;
  std::uint64_t size_, position_ = 0;
  std::size_t line_ = 1;
};

std::optional<ScalarType> type_of(const std::string& text, bool is_text) {
  using enum ScalarType;
  static const std::map<std::string_view, ScalarType> types = {{"unsigned_char", uint8},
                                                               {"char", int8},
                                                               {"signed_char", int8},
                                                               {"unsigned_short", uint16},
                                                               {"short", int16},
                                                               {"unsigned_int", uint32},
                                                               {"int", int32},
                                                               {"unsigned_long", uint64},
                                                               {"long", int64},
                                                               {"vtktypeint64", int64},
                                                               {"vtktypeuint64", uint64},
                                                               {"vtkidtype", int32},
                                                               {"float", float32},
                                                               {"double", float64}};
  const std::string name = lower(text);
  if (name == "bit" && is_text) return uint8;
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// VTK writes "my%20name" for a name with a space in it.
std::string decoded(const std::string& name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    const char* const digits = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      text += char(code);
      i += 2;
    } else {
      text += name[i];
    }
  }
  return text;
}

class Sections {
 public:
  Sections(Scanner& scanner, VtkLegacy& file) : in_(scanner), file_(file) {}

  /// Takes what the keyword begins; false when it begins nothing that is known, or the file ends within.
  bool take(const std::string& keyword) {
    if (keyword == "point_data" || keyword == "cell_data") {
      section_ = keyword == "point_data" ? VtkArray::Section::points : VtkArray::Section::cells;
      tuples_ = in_.count(keyword);
      return true;
    }
    if (keyword == "field") return take_field();
    if (keyword == "metadata") {  // ends with an empty line
      in_.line();
      while (!in_.line().empty()) continue;
      return true;
    }
    if (keyword == "lookup_table") {
      const auto words_left = words(in_.line());
      const auto size = words_left.size() > 1 ? to_integer(words_left[1]).value_or(-1) : -1;
      return size >= 0 && skip(ScalarType::uint8, 4 * std::uint64_t(size));
    }
    return take_attribute(keyword);
  }

 private:
  bool skip(ScalarType type, std::uint64_t numbers) {
    if (file_.is_text) return in_.skip_words(numbers);
    const auto bytes = checked_product(numbers, size_of(type));
    return bytes && in_.skip_bytes(*bytes);
  }

  bool add(const std::string& name, bool is_scalars, const std::string& type_name, std::uint64_t components,
           std::uint64_t tuples) {
    const auto type = type_of(type_name, file_.is_text);
    if (!type)
      in_.fail(fmt::format("numbers of type \"{}\" are not read", one_line(type_name.substr(0, 40))));
    const auto numbers = checked_product(components, tuples);
    if (components == 0 || !numbers) in_.fail("its numbers cannot be counted");
    file_.arrays.push_back({decoded(name), section_, is_scalars, *type, components, tuples, in_.position(),
                            in_.line_number(), false});
    return skip(*type, *numbers);
  }

  /// Bytes; as text they are written as parts of 255.
  bool add_colours(const std::string& name, std::uint64_t components) {
    const std::size_t place = file_.arrays.size();
    const bool whole = add(name, false, file_.is_text ? "float" : "unsigned_char", components, tuples_);
    file_.arrays[place].is_of_255 = file_.is_text;
    return whole;
  }

  bool take_field() {
    in_.word();
    const std::uint64_t count = in_.count("FIELD");
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string name = in_.word();
      const std::uint64_t components = in_.count(name), tuples = in_.count(name);
      const std::string type = in_.word();
      in_.line();
      const bool whole = lower(type) == "string" ? skip_strings(components, tuples)
                                                 : add(name, false, type, components, tuples);
      if (!whole) return false;
      skip_metadata();
    }
    return true;
  }
  /// In text a line each; else behind a length whose two highest bits say how many bytes it has.
  bool skip_strings(std::uint64_t components, std::uint64_t tuples) {
    const auto strings = checked_product(components, tuples);
    for (std::uint64_t i = 0; strings && i < *strings; ++i) {
      if (file_.is_text) {
        if (in_.at_end()) return false;
        in_.line();
        continue;
      }
      const auto first = in_.byte();
      if (!first) return false;
      std::uint64_t length = *first & 0x3fu;
      const int more = *first >> 6 == 3 ? 0 : *first >> 6 == 2 ? 1 : *first >> 6 == 1 ? 3 : 7;
      for (int k = 0; k < more; ++k) length = length << 8 | in_.byte().value_or(0);
      if (!in_.skip_bytes(length)) return false;
    }
    return strings.has_value();
  }
  /// It may follow an array within a field.
  void skip_metadata() {
    const std::uint64_t position = in_.position();
    const std::size_t line = in_.line_number();
    if (lower(peek_word()) == "metadata")
      take("metadata");
    else
      in_.go_back(position, line);
  }
  std::string peek_word() { return in_.word(); }

  bool take_attribute(const std::string& keyword) {
    static const std::map<std::string_view, std::uint64_t> fixed = {
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    const bool is_scalars = keyword == "scalars", is_colours = keyword == "color_scalars",
               is_texture = keyword == "texture_coordinates";
    const auto components = fixed.find(keyword);
    if (!is_scalars && !is_colours && !is_texture && components == fixed.end()) return false;
    const auto said = words(in_.line());
    const auto number = [&](std::size_t i) {
      const auto value = i < said.size() ? to_integer(said[i]) : std::nullopt;
      if (!value || *value < 1 || *value > 1024)
        in_.fail(fmt::format("{} has no number of components", keyword));
      return std::uint64_t(*value);
    };
    if (said.size() < 2) in_.fail(fmt::format("{} has no name and type", keyword));
    if (is_colours) return add_colours(said[0], number(1));
    if (is_texture) return said.size() > 2 && add(said[0], false, said[2], number(1), tuples_);
    if (!is_scalars) return add(said[0], false, said[1], components->second, tuples_);
    const std::uint64_t position = in_.position();
    const std::size_t line = in_.line_number();
    if (lower(in_.word()) == "lookup_table")
      in_.line();
    else
      in_.go_back(position, line);
    return add(said[0], true, said[1], said.size() > 2 ? number(2) : 1, tuples_);
  }

  Scanner& in_;
  VtkLegacy& file_;
  VtkArray::Section section_ = VtkArray::Section::dataset;
  std::uint64_t tuples_ = 0;
};

/// The lines before the attributes; false for a keyword that is not one of theirs.
bool take_geometry(Scanner& in, const std::string& keyword, VtkLegacy& file) {
  if (keyword == "dataset") {
    const std::string type = in.word();
    if (lower(type) != "structured_points")
      in.fail(fmt::format("DATASET {} is not read; STRUCTURED_POINTS is", one_line(type.substr(0, 40))));
    return true;
  }
  const bool spacing = keyword == "spacing" || keyword == "aspect_ratio";
  if (keyword != "dimensions" && keyword != "origin" && !spacing) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (keyword == "dimensions") {
      constexpr std::uint64_t most = std::numeric_limits<int>::max();
      file.dims[axis] = int(std::min(in.count("DIMENSIONS"), most));
    } else {
      (spacing ? file.spacing : file.origin)[axis] = in.number(keyword);
    }
  }
  return true;
}

}  // namespace

VtkLegacy scan_vtk_legacy(const fs::path& path) {
  const std::string name = path.string();
  Scanner in(path);
  if (!lower(in.line()).starts_with("# vtk datafile"))
    throw Error(fmt::format("{}: not a legacy VTK file: it does not begin with \"# vtk DataFile\"", name));
  in.line();
  VtkLegacy file;
  const std::string form = lower(in.word());  // empty lines may be before it
  if (form != "ascii" && form != "binary") in.fail("it is neither ASCII nor BINARY");
  file.is_text = form == "ascii";
  Sections sections(in, file);
  for (std::string word = in.word(); !word.empty(); word = in.word()) {
    const std::string keyword = lower(word);
    const std::size_t line = in.line_number(), before = file.arrays.size();
    if (take_geometry(in, keyword, file) || sections.take(keyword)) continue;
    if (before == file.arrays.size())
      file.unread = fmt::format("\"{}\" in line {}", one_line(word.substr(0, 40)), line);
    break;  // or its numbers end with the file: who reads them says so
  }
  return file;
}

}  // namespace crest
