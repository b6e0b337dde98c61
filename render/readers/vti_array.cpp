// Where the arrays of a VTK XML file are: in the text, or behind it.
#include <fmt/core.h>

#include <algorithm>
#include <istream>
#include <streambuf>

#include "presets/error.h"
#include "render/readers/reopened_file.h"
#include "render/readers/text_voxels.h"
#include "render/readers/vti_file.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

using SharedFile = std::shared_ptr<const VtiFile>;

/// An element's text, where it stands. It keeps the file.
class ElementText : public std::streambuf {
 public:
  ElementText(SharedFile file, pugi::xml_node element) : file_(std::move(file)) {
    char* text = const_cast<char*>(element.child_value());
    setg(text, text, text + std::string_view(text).size());
  }

 private:
  SharedFile file_;
};

/// Numbers as text.
class TextArray : public ByteStream {
 public:
  TextArray(const SharedFile& file, pugi::xml_node array, ScalarType type, std::uint64_t values)
      : value_size_(size_of(type)),
        text_(file, array),
        stream_(&text_),
        words_(stream_, line_of(*file, array)),
        numbers_(file->name, words_, type, values) {}
  void read(std::uint64_t first, std::span<std::byte> out) override {
    numbers_.skip(first / value_size_ - numbers_.taken());
    numbers_.read(out);
  }
  bool finish() override {
    numbers_.finish();
    return false;
  }

 private:
  /// By its place in the text as UTF-8, which may be longer than the file's.
  static std::size_t line_of(const VtiFile& file, pugi::xml_node array) {
    const auto at = std::size_t(std::max<std::ptrdiff_t>(array.first_child().offset_debug(), 0));
    const auto behind = std::ranges::upper_bound(file.arrays, at, {}, &VtiLine::begin);
    return behind == file.arrays.begin() ? 1 : std::prev(behind)->line;
  }

  std::size_t value_size_;
  ElementText text_;
  std::istream stream_;
  WordStream words_;
  NumberReader numbers_;
};

std::unique_ptr<ByteStream> open_array(const SharedFile& file, const VtiPiece& piece,
                                       const VtiChoice& choice) {
  const pugi::xml_node array = piece.array;
  const std::string_view format = array.attribute("format").value();
  const glm::u64vec3 dims = dims_of(piece.extent, choice.of_cells);
  const auto values = checked_product({dims.x, dims.y, dims.z, choice.components});
  const auto bytes = values ? checked_product(*values, size_of(choice.type)) : values;
  if (!bytes) throw Error(fmt::format("{}: the points of its pieces cannot be counted", file->name));
  if (format == "ascii") return std::make_unique<TextArray>(file, array, choice.type, *values);
  const auto with = [&](std::unique_ptr<VtiBytes> data) {
    return open_vti_array(file->name, std::move(data), file->coding, choice.type, *bytes);
  };
  if (format == "binary") return with(base64_vti_bytes(std::make_unique<ElementText>(file, array)));
  const auto offset = to_integer(array.attribute("offset").value());
  if (format != "appended" || !offset || *offset < 0 || !file->appended)
    throw Error(fmt::format("{}: its array has neither data of its own nor a place in the appended data",
                            file->name));
  const std::uint64_t begin = *file->appended + std::uint64_t(*offset);
  if (!file->appended_is_base64) return with(raw_vti_bytes(file->path, begin));
  return with(base64_vti_bytes(std::make_unique<ReopenedFile>(file->path, begin)));
}

}  // namespace

std::unique_ptr<ByteStream> open_vti_grid(const SharedFile& file, const std::vector<VtiPiece>& pieces,
                                          const VtiChoice& choice) {
  if (pieces.size() == 1) return open_array(file, pieces[0], choice);
  const VtiExtent whole = joined(pieces);
  std::vector<VtiPart> parts;
  for (const VtiPiece& piece : pieces) {
    open_array(file, piece, choice);  // what it lacks is said before others are read
    const glm::u64vec3 dims = dims_of(piece.extent, choice.of_cells);
    parts.push_back({place_of(piece.extent, whole), dims, [file, piece, choice, dims] {
                       return VtiSource{open_array(file, piece, choice), dims, glm::u64vec3(0)};
                     }});
  }
  return std::make_unique<VtiGrid>(file->name, dims_of(whole, choice.of_cells),
                                   choice.components * size_of(choice.type), std::move(parts));
}

}  // namespace crest
