#include "render/readers/vti_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/choose_array.h"
#include "render/readers/open_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

void read_text(VtiFile& file, std::uint64_t most_bytes) {
  constexpr std::string_view mark = "<AppendedData";
  constexpr std::size_t block = std::size_t(1) << 16, longest_tag = std::size_t(1) << 12;
  std::ifstream stream = open_file(file.path);
  std::string part(block, '\0');
  std::size_t at = std::string::npos;  // of the mark, whose end may be in a later part
  while (stream.read(part.data(), std::streamsize(block)), stream.gcount() > 0) {
    const std::size_t before = file.xml.size();
    file.xml.append(part, 0, std::size_t(stream.gcount()));
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (before == 0 && file.xml.starts_with(byte_order_mark))
      file.xml.replace(0, byte_order_mark.size(), byte_order_mark.size(), ' ');  // places stay
    if (before == 0 && trim(file.xml).substr(0, 1) != "<")
      throw Error(fmt::format("{}: not a VTK XML file: it does not begin with \"<\"", file.name));
    if (file.xml.size() > most_bytes)
      throw Error(fmt::format("{}: reading it takes more memory than there is", file.name));
    if (at == std::string::npos) at = file.xml.find(mark, before > mark.size() ? before - mark.size() : 0);
    if (at == std::string::npos) continue;
    const std::size_t end = file.xml.find('>', at);
    const std::size_t underscore = end == std::string::npos ? end : file.xml.find('_', end);
    if (underscore == std::string::npos && file.xml.size() - at > longest_tag)
      throw Error(
          fmt::format("{}: its appended data has no begin: \"<AppendedData ...>\" and \"_\"", file.name));
    if (underscore == std::string::npos) continue;
    file.appended_is_base64 = file.xml.substr(at, underscore - at).find("base64") != std::string::npos;
    file.appended = underscore + 1;
    file.xml.resize(at);
    file.xml += "</VTKFile>";
    file.xml.shrink_to_fit();  // there may be thousands of such files
    break;
  }
  if (file.xml.empty()) throw Error(fmt::format("{}: not a VTK XML file: it is empty", file.name));
}

std::size_t lines_in(std::string_view text) { return std::size_t(std::ranges::count(text, '\n')); }

/// Found before the text is parsed, which changes it.
std::vector<VtiLine> lines_of_arrays(std::string_view xml) {
  std::vector<VtiLine> arrays;
  std::size_t line = 1, counted = 0;
  for (std::size_t at = 0; (at = xml.find("<DataArray", at)) != xml.npos;) {
    at = std::min(xml.find('>', at), xml.size());
    line += lines_in(xml.substr(counted, at - counted));
    counted = at;
    arrays.push_back({at, line});
  }
  return arrays;
}

/// The line of a place in the text, which is read again.
std::size_t line_at(const VtiFile& file, std::ptrdiff_t place, std::uint64_t most_bytes) {
  VtiFile again{.path = file.path, .name = file.name, .xml = {}};
  read_text(again, most_bytes);
  return lines_in(std::string_view(again.xml).substr(0, std::size_t(std::max<std::ptrdiff_t>(place, 0)))) + 1;
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

pugi::xml_node image_of(const VtiFile& file, const std::string& type) {
  const pugi::xml_node root = file.document.child("VTKFile");
  const std::string is = root.attribute("type").value();
  if (!root || is != type)
    throw Error(fmt::format("{}: a VTK XML file of type \"{}\" is not read; {} is", file.name,
                            one_line(is.substr(0, 40)), type));
  const pugi::xml_node image = root.child(type.c_str());
  if (image.child("Piece")) return image;
  throw Error(fmt::format("{}: it has no pieces", file.name));
}

}  // namespace

std::shared_ptr<const VtiFile> open_vti(const std::string& name, const fs::path& path,
                                        const std::string& type, std::uint64_t most_bytes) {
  const auto file = std::make_shared<VtiFile>(VtiFile{.path = path, .name = name, .xml = {}});
  read_text(*file, most_bytes);
  file->arrays = lines_of_arrays(file->xml);
  if (const auto parsed = file->document.load_buffer_inplace(file->xml.data(), file->xml.size()); !parsed)
    throw Error(fmt::format("{}: its XML is damaged in line {}: {}", name,
                            line_at(*file, parsed.offset, most_bytes), parsed.description()));
  file->image = image_of(*file, type);
  file->coding = coding_of(name, file->document.child("VTKFile"));
  return file;
}

VtiChoice choose_vti_array(const FileRequest& request, const std::string& prefix, pugi::xml_node parent,
                           std::string& note) {
  VtiChoice choice;
  const auto arrays_in = [&](const char* section) {
    const std::string in = prefix + section, kind = prefix + "DataArray";
    std::vector<pugi::xml_node> arrays;
    for (const pugi::xml_node array : parent.child(in.c_str()).children(kind.c_str()))
      if (std::string_view(array.attribute("Name").value()) != "vtkGhostType") arrays.push_back(array);
    return arrays;
  };
  std::vector<pugi::xml_node> arrays = arrays_in("PointData");
  choice.of_cells = arrays.empty();
  if (choice.of_cells) {
    arrays = arrays_in("CellData");
    add_note(note, "the file has values of its cells, which are taken at the cells' centres");
  }
  if (arrays.empty())
    throw Error(fmt::format("{}: the VTK file has no arrays of its points or cells", request.name()));
  std::vector<std::string> names;
  for (const pugi::xml_node array : arrays) names.emplace_back(one_line(array.attribute("Name").value()));
  const char* active = arrays[0].parent().attribute("Scalars").value();
  const std::size_t chosen = choose_array(request, names, active, note);
  choice.name = names[chosen];
  choice.type = type_of(request.name(), arrays[chosen].attribute("type").value());
  choice.components = arrays[chosen].attribute("NumberOfComponents").as_ullong(1);
  return choice;
}

VtiExtent vti_extent(const std::string& name, pugi::xml_node element, const char* key,
                     const VtiExtent& fallback) {
  const VtiExtent extent = numbers_of<6>(name, element, key, fallback);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr double most = 0x1p30;
    const double begin = extent[2 * axis], end = extent[2 * axis + 1];
    if (!(std::abs(begin) < most && std::abs(end) < most && end >= begin) || begin != std::floor(begin) ||
        end != std::floor(end))
      throw Error(fmt::format("{}: its extent from {} to {} is none", name, begin, end));
  }
  return extent;
}

void take_vti_geometry(const VtiFile& file, const VtiExtent& extent, const VtiChoice& choice,
                       VoxelHeader& header) {
  const auto origin = numbers_of<3>(file.name, file.image, "Origin", {0, 0, 0});
  const auto spacing = numbers_of<3>(file.name, file.image, "Spacing", {1, 1, 1});
  const auto direction = numbers_of<9>(file.name, file.image, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  glm::dvec3 first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = int(axis);
    header.spacing[a] = spacing[axis];
    first[a] = (extent[2 * axis] + (choice.of_cells ? 0.5 : 0)) * spacing[axis];
    for (std::size_t row = 0; row < 3; ++row) header.direction[a][int(row)] = direction[3 * row + axis];
  }
  header.origin = glm::dvec3(origin[0], origin[1], origin[2]) + header.direction * first;
  header.type = choice.type;
  header.endian = std::endian::native;
  header.layout = interleaved(dims_of(extent, choice.of_cells), choice.components);
}

std::vector<VtiPiece> vti_pieces(const VtiFile& file, const VtiChoice& choice) {
  const auto whole = numbers_of<6>(file.name, file.image, "WholeExtent", {});
  std::vector<VtiPiece> pieces;
  for (const pugi::xml_node piece : file.image.children("Piece")) {
    const std::size_t number = pieces.size() + 1;
    const auto arrays = piece.child(choice.of_cells ? "CellData" : "PointData").children("DataArray");
    const auto found = std::ranges::find_if(arrays, [&](const pugi::xml_node& array) {
      return one_line(array.attribute("Name").value()) == choice.name;
    });
    if (found == arrays.end())
      throw Error(fmt::format("{}: its piece {} has no array \"{}\"", file.name, number, choice.name));
    if (type_of(file.name, found->attribute("type").value()) != choice.type ||
        found->attribute("NumberOfComponents").as_ullong(1) != choice.components)
      throw Error(fmt::format("{}: the type or the components of \"{}\" are not the same in its pieces",
                              file.name, choice.name));
    pieces.push_back({vti_extent(file.name, piece, "Extent", whole), *found});
  }
  return pieces;
}

VtiExtent joined(const std::vector<VtiPiece>& pieces) {
  VtiExtent whole = pieces.front().extent;
  for (const VtiPiece& piece : pieces) whole = joined(whole, piece.extent);
  return whole;
}

}  // namespace crest
