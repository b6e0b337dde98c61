// ImageJ's "hyperstacks" (ij.io.FileSaver, getDescriptionString, and ij.io.FileOpener).
#include <fmt/core.h>

#include <cmath>
#include <map>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/tiff_planes.h"
#include "render/readers/voxel_header.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {
namespace {

using ImageJFields = std::map<std::string, std::string, std::less<>>;

/// ImageJ's values are a function of the stored ones, "cf": signed ones are kept so, as c0=-32768 and c1=1.
void take_calibration(const ImageJFields& fields, PlaneOrder& order) {
  constexpr double straight_line = 0, none = 20;
  const auto number = [&](const char* key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::nullopt : to_number(found->second);
  };
  const auto intercept = number("c0"), slope = number("c1");
  auto function = number("cf");
  if (!function && intercept && slope && fields.contains("vunit")) function = straight_line;  // by default
  if (!function || *function == none) return;
  if (*function == straight_line && intercept && slope)
    order.scaling = {*slope, *intercept};
  else
    add_note(order.note, "ImageJ's calibration of its values is not applied: it is no straight line");
}

ImageJFields imagej_fields(const std::string& description) {
  ImageJFields fields;
  HeaderLines lines(description);
  std::string_view line;
  while (lines.next(line)) {
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos)
      fields.emplace(trim(line.substr(0, equals)), trim(line.substr(equals + 1)));
  }
  return fields;
}

/// 1 where it says no such number.
std::size_t count_of(const ImageJFields& fields, const char* key) {
  const auto found = fields.find(key);
  const auto value = found == fields.end() ? std::nullopt : to_integer(found->second);
  return value && *value > 0 && *value < (1 << 24) ? std::size_t(*value) : 1;
}

/// ImageJ writes "\\u00B5m".
std::string unit_of(const std::string& text) {
  constexpr std::string_view escaped = "\\u00B5";
  return one_line(text.starts_with(escaped) ? "µ" + text.substr(escaped.size()) : text);
}

/// "lengths in cm, on z in mm".
std::string lengths_note(const ImageJFields& fields) {
  const std::string unit = unit_of(fields.at("unit"));
  std::string note = "lengths in " + unit;
  for (const auto& [key, axis] : {std::pair("yunit", "y"), {"zunit", "z"}}) {
    const auto other = fields.find(key);
    if (other != fields.end() && unit_of(other->second) != unit)
      note += fmt::format(", on {} in {}", axis, unit_of(other->second));
  }
  return note;
}

void take_imagej_spacing(const ImageJFields& fields, const TiffDescription& description, PlaneOrder& order) {
  constexpr double micrometres_a_centimetre = 1e4;
  const auto spacing = fields.find("spacing");
  const auto z = spacing == fields.end() ? std::nullopt : to_number(spacing->second);
  if (spacing != fields.end() && !z)
    add_note(order.note,
             fmt::format("its slices' distance, \"{}\", is no number", one_line(spacing->second)));
  const double x = description.pixels_per_unit_x, y = description.pixels_per_unit_y;
  const bool has_unit = fields.contains("unit") && fields.at("unit") != "pixel";
  if (!z && !has_unit) return;
  const bool by_centimetres = description.in_centimetres && has_unit && fields.at("unit") == "um";
  const double length = by_centimetres ? micrometres_a_centimetre : 1;
  order.spacing = {x > 0 && has_unit ? length / x : 1, y > 0 && has_unit ? length / y : 1,
                   z ? std::abs(*z) : 1};
  if (has_unit) order.lengths = lengths_note(fields);
}

}  // namespace

bool is_imagej(const std::string& text) { return text.starts_with("ImageJ="); }

PlaneOrder order_imagej(const std::string& name, const TiffDescription& description, std::size_t pages) {
  const ImageJFields fields = imagej_fields(description.text);
  PlaneOrder order;
  order.components = count_of(fields, "channels"), order.slices = count_of(fields, "slices");
  order.frames = count_of(fields, "frames");
  const auto slices = checked_product(order.components, order.slices);
  const auto planes = slices ? checked_product(*slices, order.frames) : std::nullopt;
  if (planes == 1)
    order.slices = pages;
  else if (planes != pages)
    throw Error(fmt::format(
        "{}: its ImageJ description tells of {} images ({} channels, {} slices, {} frames), and the "
        "file has {}",
        name, planes ? fmt::format("{}", *planes) : "over 2^64", order.components, order.slices, order.frames,
        pages));
  order.pages.resize(pages);
  const bool slices_first = fields.contains("order") && fields.at("order") == "zct";  // as Micro-Manager says
  for (std::size_t page = 0; page < pages; ++page) {  // else channels, then slices
    const std::size_t component =
                          slices_first ? page / order.slices % order.components : page % order.components,
                      slice = slices_first ? page % order.slices : page / order.components % order.slices;
    order.pages[place_in(order, component, slice, page / order.components / order.slices)] = page;
  }
  take_imagej_spacing(fields, description, order);
  take_calibration(fields, order);
  take_only_axis_as_slices(order);
  return order;
}

bool take_one_of_imagej(const TiffDescription& description, PlaneOrder& order) {
  const ImageJFields fields = imagej_fields(description.text);
  take_imagej_spacing(fields, description, order);
  if (order.spacing && !fields.contains("spacing")) add_note(order.lengths, unknown_distance);
  take_calibration(fields, order);
  return count_of(fields, "channels") > 1 || count_of(fields, "frames") > 1;
}

std::size_t imagej_images(const std::string& description) {
  return is_imagej(description) ? count_of(imagej_fields(description), "images") : 1;
}

}  // namespace crest
