// OME-TIFF (docs.openmicroscopy.org, ome-model, specification).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/tiff_planes.h"
#include "render/readers/voxel_header.h"

namespace crest {
namespace {

/// Sizes of OME's planes, by their letters.
struct OmeSizes {
  std::string letters;  ///< of C, Z and T, the fastest first
  std::map<char, std::size_t> size = {{'C', 1}, {'Z', 1}, {'T', 1}};
};

std::array<std::size_t, 3> plane_at(const OmeSizes& sizes, std::size_t number) {
  std::map<char, std::size_t> at;
  for (const char letter : sizes.letters) {
    at[letter] = number % sizes.size.at(letter);
    number /= sizes.size.at(letter);
  }
  return {at['C'], at['Z'], at['T']};
}

std::size_t number_of(const OmeSizes& sizes, std::size_t c, std::size_t z, std::size_t t) {
  std::size_t number = 0, step = 1;
  for (const char letter : sizes.letters) {
    number += step * (letter == 'C' ? c : letter == 'Z' ? z : t);
    step *= sizes.size.at(letter);
  }
  return number;
}

/// The blocks of planes that are in this file. A file says of each block's what it is called, and its own
/// number; it may have got another name since.
class OwnBlocks {
 public:
  OwnBlocks(const std::string& path, pugi::xml_node ome)
      : name_(std::filesystem::path(path).filename().string()), number_(ome.attribute("UUID").as_string()) {
    bool has_number = false, has_name = false;
    std::set<std::string> names;
    for (const pugi::xml_node image : ome.children("Image"))
      for (const pugi::xml_node block : image.child("Pixels").children("TiffData")) {
        has_number = has_number || is_number(block);
        has_name = has_name || file_of(block) == name_;
        names.insert(file_of(block));
      }
    by_ = has_number ? By::number : has_name ? By::name : names.size() > 1 ? By::none : By::all;
  }

  bool has(pugi::xml_node block) const {
    switch (by_) {
      case By::number:
        return is_number(block);
      case By::name:
        return file_of(block) == name_;
      case By::none:
        return file_of(block).empty();
      case By::all:
        break;
    }
    return true;
  }
  bool has_any(pugi::xml_node pixels) const {
    const auto blocks = pixels.children("TiffData");
    return std::ranges::any_of(blocks, [&](pugi::xml_node block) { return has(block); });
  }
  /// ": others are in b.ome.tif, ...", where there are such planes.
  std::string others_text(pugi::xml_node pixels) const {
    for (const pugi::xml_node block : pixels.children("TiffData"))
      if (!has(block))
        return fmt::format(": others are in {}, and one file that holds all is read",
                           one_line(file_of(block)));
    return "";
  }

 private:
  enum class By { number, name, none, all };
  static std::string file_of(pugi::xml_node block) {
    return block.child("UUID").attribute("FileName").as_string();
  }
  bool is_number(pugi::xml_node block) const {
    return !number_.empty() && number_ == block.child("UUID").text().as_string();
  }

  std::string name_, number_;
  By by_ = By::all;
};

/// Where each plane's page is.
void take_tiff_data(const std::string& name, pugi::xml_node pixels, const OwnBlocks& own,
                    const OmeSizes& sizes, std::size_t pages, PlaneOrder& order) {
  const std::size_t planes = order.pages.size();
  std::vector<bool> found(planes, false);
  const auto put = [&](std::size_t plane, std::size_t page) {
    if (plane >= planes || page >= pages)
      throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages{}", name,
                              planes, pages, own.others_text(pixels)));
    if (found[plane])
      throw Error(fmt::format("{}: its OME description tells twice where plane {} is", name, plane));
    const auto [c, z, t] = plane_at(sizes, plane);
    order.pages[place_in(order, c, z, t)] = page;
    found[plane] = true;
  };
  const auto blocks = pixels.children("TiffData");
  for (const pugi::xml_node block : blocks) {
    if (!own.has(block)) continue;
    const pugi::xml_attribute ifd = block.attribute("IFD");
    const std::size_t first =
        number_of(sizes, block.attribute("FirstC").as_uint(), block.attribute("FirstZ").as_uint(),
                  block.attribute("FirstT").as_uint());
    const std::size_t count =
        block.attribute("PlaneCount").as_uint(ifd ? 1u : unsigned(std::min<std::size_t>(planes, 1u << 24)));
    for (std::size_t i = 0; i < std::min(count, planes); ++i) put(first + i, ifd.as_uint() + i);
  }
  if (blocks.begin() == blocks.end())
    for (std::size_t plane = 0; plane < planes; ++plane) put(plane, plane);
  if (std::ranges::find(found, false) != found.end())
    throw Error(
        fmt::format("{}: its OME description tells of {} planes, some of which are in no page of this file{}",
                    name, planes, own.others_text(pixels)));
}

/// How many micrometres a unit of OME's is; nothing for "pixel" and "reference frame", which are no lengths,
/// and for others that no microscope has.
std::optional<double> micrometres_of(const std::string& unit) {
  static const std::map<std::string_view, double> units = {
      {"µm", 1},   {"\u03bcm", 1}, {"um", 1},   {"nm", 1e-3}, {"pm", 1e-6},
      {"Å", 1e-4}, {"mm", 1e3},    {"cm", 1e4}, {"m", 1e6},   {"in", 25400}};
  const auto found = units.find(unit);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

void take_ome_spacing(pugi::xml_node pixels, PlaneOrder& order) {
  glm::dvec3 spacing;
  std::string others;
  for (const auto& [axis, key] :
       {std::pair(0, "PhysicalSizeX"), {1, "PhysicalSizeY"}, {2, "PhysicalSizeZ"}}) {
    const std::string unit = pixels.attribute(fmt::format("{}Unit", key).c_str()).as_string("µm");
    const auto micrometres = micrometres_of(unit);
    spacing[axis] = pixels.attribute(key).as_double(0) * micrometres.value_or(1);
    if (!micrometres && others.find(unit) == std::string::npos)
      others += fmt::format("{}\"{}\"", others.empty() ? "" : " and ", one_line(unit.substr(0, 40)));
  }
  if (!(spacing.x > 0 && spacing.y > 0)) return;
  order.spacing = {spacing.x, spacing.y, spacing.z > 0 ? spacing.z : 1};
  order.lengths = others.empty() ? "lengths in micrometres" : fmt::format("lengths in {}", others);
  if (!(spacing.z > 0)) add_note(order.lengths, unknown_distance);
}

/// Channels of a pixel in one plane.
unsigned samples_of(pugi::xml_node pixels) {
  return std::max(1u, pixels.child("Channel").attribute("SamplesPerPixel").as_uint(1));
}

pugi::xml_node pixels_of(const pugi::xml_document& document, std::size_t image) {
  const auto images = document.child("OME").children("Image");
  const auto found = std::ranges::next(images.begin(), std::ptrdiff_t(image), images.end());
  return found == images.end() ? pugi::xml_node() : found->child("Pixels");
}

/// The number of the first image that has planes in this file; of the first one where none says so.
std::size_t own_image(const OwnBlocks& own, const pugi::xml_document& document) {
  std::size_t number = 0;
  for (const pugi::xml_node image : document.child("OME").children("Image")) {
    if (own.has_any(image.child("Pixels"))) return number;
    ++number;
  }
  return 0;
}

}  // namespace

bool is_ome(const std::string& text) { return text.find("<OME") != std::string::npos; }

PlaneOrder order_ome(const std::string& name, const TiffDescription& description, std::size_t pages) {
  const std::string& text = description.text;
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  if (const auto elsewhere = document.child("OME").child("BinaryOnly")) {
    PlaneOrder order = order_pages(description, pages);
    add_note(order.note,
             fmt::format("its description is in {}, which is not read",
                         one_line(elsewhere.attribute("MetadataFile").as_string("another file"))));
    return order;
  }
  const OwnBlocks own(name, document.child("OME"));
  const std::size_t chosen = own_image(own, document);
  const pugi::xml_node pixels = pixels_of(document, chosen);
  if (!pixels) throw Error(fmt::format("{}: its OME description has no pixels", name));
  OmeSizes sizes;
  for (const char letter : std::string_view(pixels.attribute("DimensionOrder").as_string("XYZCT")))
    if (letter == 'C' || letter == 'Z' || letter == 'T') sizes.letters += letter;
  if (sizes.letters.size() != 3)
    throw Error(fmt::format("{}: its OME description has no order of dimensions", name));
  constexpr std::size_t longest = std::size_t(1) << 20;
  for (auto& [letter, size] : sizes.size)
    size = std::clamp<std::size_t>(pixels.attribute(fmt::format("Size{}", letter).c_str()).as_uint(1), 1,
                                   longest);
  const std::size_t samples = samples_of(pixels);
  if (sizes.size['C'] % samples == 0) sizes.size['C'] /= samples;
  PlaneOrder order;
  order.components = sizes.size['C'], order.slices = sizes.size['Z'], order.frames = sizes.size['T'];
  const std::size_t planes = order.components * order.slices * order.frames;
  if (planes > pages)
    throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages{}", name,
                            planes, pages, own.others_text(pixels)));
  order.pages.resize(planes);
  take_tiff_data(name, pixels, own, sizes, pages, order);
  take_ome_spacing(pixels, order);
  const auto images = document.child("OME").children("Image");
  if (const auto count = std::distance(images.begin(), images.end()); count > 1)
    add_note(order.note, chosen == 0 ? fmt::format("the first of its {} images", count)
                                     : fmt::format("image {} of its {}", chosen + 1, count));
  take_only_axis_as_slices(order);
  return order;
}

bool take_one_of_ome(const std::string& text, PlaneOrder& order) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const pugi::xml_node pixels = document.first_element_by_path("OME/Image/Pixels");
  take_ome_spacing(pixels, order);
  return pixels.attribute("SizeC").as_uint(1) > samples_of(pixels) ||
         pixels.attribute("SizeT").as_uint(1) > 1;
}

}  // namespace crest
