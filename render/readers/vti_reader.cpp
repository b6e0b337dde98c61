#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <sstream>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/base64.h"
#include "render/readers/choose_array.h"
#include "render/readers/readers.h"
#include "render/readers/text_voxels.h"
#include "render/readers/voxel_reader.h"
#include "render/readers/vti_data.h"
#include "render/readers/vti_pieces.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// The file's text up to its appended data, and where that begins: behind the "_".
struct VtiText {
  std::string xml;
  std::optional<std::uint64_t> appended = {};
  bool appended_is_base64 = false;
};

VtiText read_text(const FileRequest& request) {
  constexpr std::string_view mark = "<AppendedData";
  constexpr std::size_t block = std::size_t(1) << 20;
  std::ifstream file(request.path, std::ios::binary);
  VtiText text;
  std::string part(block, '\0');
  std::size_t at = std::string::npos;  // of the mark, whose end may be in a later part
  while (file.read(part.data(), std::streamsize(block)), file.gcount() > 0) {
    const std::size_t before = text.xml.size();
    text.xml.append(part, 0, std::size_t(file.gcount()));
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (before == 0 && text.xml.starts_with(byte_order_mark))
      text.xml.replace(0, byte_order_mark.size(), byte_order_mark.size(), ' ');  // places stay
    if (before == 0 && trim(text.xml).substr(0, 1) != "<")
      throw Error(fmt::format("{}: not a VTK XML file: it does not begin with \"<\"", request.name()));
    if (text.xml.size() > request.reading.memory / 4)
      throw Error(fmt::format("{}: reading it takes more memory than there is", request.name()));
    if (at == std::string::npos) at = text.xml.find(mark, before > mark.size() ? before - mark.size() : 0);
    if (at == std::string::npos) continue;
    const std::size_t end = text.xml.find('>', at);
    const std::size_t underscore = end == std::string::npos ? end : text.xml.find('_', end);
    if (underscore == std::string::npos) continue;
    text.appended_is_base64 = text.xml.substr(at, underscore - at).find("base64") != std::string::npos;
    text.appended = underscore + 1;
    text.xml.resize(at);
    text.xml += "</VTKFile>";
    break;
  }
  if (text.xml.empty()) throw Error(fmt::format("{}: not a VTK XML file: it is empty", request.name()));
  return text;
}

ScalarType type_of(const std::string& name, const std::string& text) {
  using enum ScalarType;
  static const std::map<std::string_view, ScalarType> types = {
      {"Int8", int8},     {"UInt8", uint8}, {"Int16", int16},   {"UInt16", uint16},   {"Int32", int32},
      {"UInt32", uint32}, {"Int64", int64}, {"UInt64", uint64}, {"Float32", float32}, {"Float64", float64}};
  const auto found = types.find(text);
  if (found != types.end()) return found->second;
  throw Error(
      fmt::format("{}: an array of type \"{}\" is not read; Int8 to Float64 are", name, one_line(text)));
}

/// The numbers of an attribute; `fallback` where there is none.
template <std::size_t count>
std::array<double, count> numbers_of(const std::string& name, pugi::xml_node node, const char* key,
                                     std::array<double, count> fallback) {
  const pugi::xml_attribute attribute = node.attribute(key);
  if (!attribute) return fallback;
  const auto list = words(attribute.value());
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = i < list.size() ? to_number(list[i]) : std::nullopt;
    if (!value || list.size() != count)
      throw Error(
          fmt::format("{}: {}=\"{}\" is not {} numbers", name, key, one_line(attribute.value()), count));
    numbers[i] = *value;
  }
  return numbers;
}

VtiCoding coding_of(const std::string& name, pugi::xml_node root) {
  VtiCoding coding;
  coding.endian = std::string_view(root.attribute("byte_order").value()) == "BigEndian" ? std::endian::big
                                                                                        : std::endian::little;
  coding.header_bytes = std::string_view(root.attribute("header_type").value()) == "UInt64" ? 8 : 4;
  const std::string compressor = root.attribute("compressor").value();
  coding.compressed = !compressor.empty();
  if (coding.compressed && compressor != "vtkZLibDataCompressor")
    throw Error(fmt::format("{}: arrays compressed by {} are not read; vtkZLibDataCompressor's are", name,
                            one_line(compressor)));
  return coding;
}

VtiExtent extent_of(const std::string& name, pugi::xml_node piece, VtiExtent whole) {
  const VtiExtent extent = numbers_of<6>(name, piece, "Extent", whole);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr double most = 0x1p30;
    const double begin = extent[2 * axis], end = extent[2 * axis + 1];
    if (!(std::abs(begin) < most && std::abs(end) < most && end >= begin) || begin != std::floor(begin) ||
        end != std::floor(end))
      throw Error(fmt::format("{}: its extent from {} to {} is none", name, begin, end));
  }
  return extent;
}

/// How many points, or cells.
glm::u64vec3 dims_of(const VtiExtent& extent, bool of_cells) {
  glm::u64vec3 dims;
  for (std::size_t axis = 0; axis < 3; ++axis)
    dims[int(axis)] = std::uint64_t(extent[2 * axis + 1] - extent[2 * axis]) + (of_cells ? 0 : 1);
  return dims;
}

void take_geometry(const std::string& name, pugi::xml_node image, const VtiExtent& extent, bool of_cells,
                   VoxelHeader& header) {
  const auto origin = numbers_of<3>(name, image, "Origin", {0, 0, 0});
  const auto spacing = numbers_of<3>(name, image, "Spacing", {1, 1, 1});
  const auto direction = numbers_of<9>(name, image, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  header.layout.dims = dims_of(extent, of_cells);
  glm::dvec3 first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = int(axis);
    header.spacing[a] = spacing[axis];
    first[a] = (extent[2 * axis] + (of_cells ? 0.5 : 0)) * spacing[axis];
    for (std::size_t row = 0; row < 3; ++row) header.direction[a][int(row)] = direction[3 * row + axis];
  }
  header.origin = glm::dvec3(origin[0], origin[1], origin[2]) + header.direction * first;
}

bool is_text(pugi::xml_node array) { return std::string_view(array.attribute("format").value()) == "ascii"; }

bool is_appended(pugi::xml_node array) {
  return std::string_view(array.attribute("format").value()) == "appended";
}

/// Where its appended data begins in the file.
std::uint64_t appended_place(const std::string& name, const VtiText& text, pugi::xml_node array) {
  const auto offset = to_integer(array.attribute("offset").value());
  if (!is_appended(array) || !offset || *offset < 0 || !text.appended)
    throw Error(
        fmt::format("{}: its array has neither data of its own nor a place in the appended data", name));
  return *text.appended + std::uint64_t(*offset);
}

/// The bytes of an array of so many values, in the file's order; text's in the machine's.
std::vector<std::byte> read_array(const FileRequest& request, const VtiText& text, pugi::xml_node array,
                                  const VtiCoding& coding, ScalarType type, std::uint64_t values) {
  const std::string name = request.name(), format = array.attribute("format").value();
  const std::uint64_t bytes = values * size_of(type);
  if (is_text(array)) {
    std::istringstream stream(array.child_value());
    // Counted in the text as UTF-8, which may be longer than the file's.
    const auto at = std::clamp<std::ptrdiff_t>(array.first_child().offset_debug(), 0, std::ssize(text.xml));
    const auto line = std::count(text.xml.begin(), text.xml.begin() + at, '\n');
    WordStream stream_words(stream, std::size_t(line) + 1);
    std::vector<std::byte> out(bytes);
    read_numbers(name, stream_words, type, out);
    return out;
  }
  if (format == "binary") return read_vti_base64(name, array.child_value(), coding, bytes);
  const std::uint64_t begin = appended_place(name, text, array);
  if (!text.appended_is_base64) return read_vti_raw(name, request.path, begin, coding, bytes);
  std::ifstream file(request.path, std::ios::binary);
  file.seekg(std::streamoff(begin));
  const std::string encoded{std::istreambuf_iterator<char>(file), {}};
  return read_vti_base64(name, encoded, coding, bytes);
}

std::vector<pugi::xml_node> arrays_in(pugi::xml_node data) {
  std::vector<pugi::xml_node> arrays;
  for (const pugi::xml_node array : data.children("DataArray")) arrays.push_back(array);
  return arrays;
}

pugi::xml_node image_of(const std::string& name, const pugi::xml_document& document) {
  const pugi::xml_node root = document.child("VTKFile");
  const std::string type = root.attribute("type").value();
  if (!root || type != "ImageData") {
    throw Error(fmt::format("{}: a VTK XML file of type \"{}\" is not read; ImageData is", name,
                            one_line(type.substr(0, 40))));
  }
  const pugi::xml_node image = root.child("ImageData");
  if (image.child("Piece")) return image;
  throw Error(fmt::format("{}: it has no pieces", name));
}

/// Of one piece of the file: what the chosen array holds of it.
struct Piece {
  VtiExtent extent;
  pugi::xml_node array;
};

/// The array of this name in each piece; the others have to be as the first one is.
std::vector<Piece> pieces_of(const std::string& name, pugi::xml_node image, const char* section,
                             const std::string& array_name) {
  const auto whole = numbers_of<6>(name, image, "WholeExtent", {});
  std::vector<Piece> pieces;
  for (const pugi::xml_node piece : image.children("Piece")) {
    const auto arrays = arrays_in(piece.child(section));
    const auto found = std::ranges::find_if(arrays, [&](const pugi::xml_node& array) {
      return one_line(array.attribute("Name").value()) == array_name;
    });
    if (found == arrays.end())
      throw Error(fmt::format("{}: its piece {} has no array \"{}\"", name, pieces.size() + 1, array_name));
    const auto says = [&](const char* key) { return std::string_view(found->attribute(key).value()); };
    for (const char* key : {"type", "NumberOfComponents"}) {
      if (!pieces.empty() && says(key) != pieces[0].array.attribute(key).value())
        throw Error(fmt::format("{}: {} of \"{}\" is not the same in its pieces", name, key, array_name));
    }
    if (!pieces.empty() && is_text(*found) != is_text(pieces[0].array))
      throw Error(
          fmt::format("{}: \"{}\" is text in some of its pieces, and not in others", name, array_name));
    pieces.push_back({extent_of(name, piece, whole), *found});
  }
  return pieces;
}

/// 0 where they cannot be counted.
std::uint64_t bytes_of_array(const VoxelHeader& header) {
  const glm::u64vec3 dims = header.layout.dims;
  const auto points = checked_product(dims.x * dims.y, dims.z);
  const auto values = points ? checked_product(*points, header.layout.components) : points;
  return values ? checked_product(*values, size_of(header.type)).value_or(0) : 0;
}

/// All of a volume's bytes, from its pieces.
std::vector<std::byte> join_pieces(const FileRequest& request, const VtiText& text,
                                   const std::vector<Piece>& pieces, const VtiExtent& whole, bool of_cells,
                                   const VtiCoding& coding, const VoxelHeader& header) {
  const auto read = [&](const Piece& piece) {
    const glm::u64vec3 dims = dims_of(piece.extent, of_cells);
    return read_array(request, text, piece.array, coding, header.type,
                      dims.x * dims.y * dims.z * header.layout.components);
  };
  if (pieces.size() == 1) return read(pieces[0]);
  VtiGrid grid(header.layout.dims, header.layout.components * size_of(header.type));
  for (const Piece& piece : pieces) {
    glm::u64vec3 first;
    for (std::size_t axis = 0; axis < 3; ++axis)
      first[int(axis)] = std::uint64_t(piece.extent[2 * axis] - whole[2 * axis]);
    grid.put(read(piece), first, dims_of(piece.extent, of_cells));
  }
  return grid.take(request.name());
}

}  // namespace

Volume read_vti(const FileRequest& request) {
  const std::string name = request.name();
  const VtiText text = read_text(request);
  pugi::xml_document document;
  if (const auto parsed = document.load_buffer(text.xml.data(), text.xml.size()); !parsed) {
    const auto end = text.xml.begin() + std::min<std::ptrdiff_t>(parsed.offset, std::ssize(text.xml));
    throw Error(fmt::format("{}: its XML is damaged in line {}: {}", name,
                            std::count(text.xml.begin(), end, '\n') + 1, parsed.description()));
  }
  const pugi::xml_node image = image_of(name, document), piece = image.child("Piece");
  VoxelHeader header;
  pugi::xml_node data = piece.child("PointData");
  std::vector<pugi::xml_node> arrays = arrays_in(data);
  const bool of_cells = arrays.empty();
  if (of_cells) {
    data = piece.child("CellData");
    arrays = arrays_in(data);
    add_note(header.note, "the file has values of its cells, which are taken at the cells' centres");
  }
  if (arrays.empty()) throw Error(fmt::format("{}: the VTK file has no arrays of its points or cells", name));
  std::vector<std::string> names;
  for (const pugi::xml_node array : arrays) names.emplace_back(one_line(array.attribute("Name").value()));
  const std::size_t chosen = choose_array(request, names, data.attribute("Scalars").value(), header.note);
  const std::vector<Piece> pieces = pieces_of(name, image, data.name(), names[chosen]);
  std::vector<VtiExtent> extents;
  for (const Piece& one : pieces) extents.push_back(one.extent);
  const VtiExtent whole = joined(extents);
  if (whole != numbers_of<6>(name, image, "WholeExtent", whole))
    add_note(header.note, "the file holds a part of its whole extent");
  if (pieces.size() > 1) add_note(header.note, fmt::format("joined from {} pieces", pieces.size()));

  const pugi::xml_node array = pieces[0].array;
  take_geometry(name, image, whole, of_cells, header);
  header.type = type_of(name, array.attribute("type").value());
  const auto components = array.attribute("NumberOfComponents").as_ullong(1);
  header.layout = interleaved(header.layout.dims, components);
  const VtiCoding coding = coding_of(name, document.child("VTKFile"));
  header.endian = is_text(array) ? std::endian::native : coding.endian;
  const std::uint64_t promised = bytes_of_array(header);
  if (pieces.size() == 1 && is_appended(array) && !text.appended_is_base64 && !coding.compressed &&
      promised) {
    const std::uint64_t place = appended_place(name, text, array);
    header.data = {{request.path}, find_vti_raw(name, request.path, place, coding, promised)};
    return read_voxels(request, header, ",array");
  }
  std::vector<std::byte> bytes;
  const std::size_t value_size = size_of(header.type);
  const auto read = [&](std::uint64_t first, std::span<std::byte> out) {
    if (bytes.empty()) bytes = join_pieces(request, text, pieces, whole, of_cells, coding, header);
    std::ranges::copy(std::span(bytes).subspan(first * value_size, out.size()), out.begin());
  };
  return read_voxels(request, header, ",array", read, promised);
}

}  // namespace crest
