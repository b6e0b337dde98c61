// ParaView's legacy colour maps (<ColorMap> with <Point>s) and Inviwo's transfer functions (.itf).
#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/import_formats.h"
#include "presets/exchange/numbers_text.h"
#include "presets/exchange/words.h"
#include "presets/exchange/xml_text.h"

namespace crest {
namespace {

/// An attribute as a number.
double number(const pugi::xml_node& node, const char* name) {
  const auto read = to_numbers(node.attribute(name).as_string());
  if (!read || read->size() != 1)
    throw Error(fmt::format("<{}> at byte {}: {}=\"{}\" is not a number", node.name(), node.offset_debug(),
                            name, node.attribute(name).as_string()));
  return read->front();
}

double unit_number(const pugi::xml_node& node, const char* name) {
  const double value = number(node, name);
  if (!(value >= 0 && value <= 1))
    throw Error(fmt::format("<{}> at byte {}: {}=\"{}\" is not in [0, 1]", node.name(), node.offset_debug(),
                            name, value));
  return value;
}

Imported read_color_map(const pugi::xml_node& map) {
  Imported result;
  result.preset.name = map.attribute("name").as_string();
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  for (const pugi::xml_node& point : map.children("Point")) {
    const double x = number(point, "x");
    colors.push_back({x, {unit_number(point, "r"), unit_number(point, "g"), unit_number(point, "b")}});
    if (point.attribute("o")) opacities.push_back({x, unit_number(point, "o")});
  }
  if (colors.empty()) throw Error(fmt::format("the colour map \"{}\" has no <Point>", result.preset.name));
  // Of ParaView's own maps all have o="1", which says nothing
  const bool says_nothing =
      std::ranges::all_of(opacities, [](const OpacityNode& n) { return n.opacity == 1; });
  if (opacities.size() != colors.size() || says_nothing) {
    const auto [first, last] = std::ranges::minmax(colors, {}, &ColorNode::x);
    opacities = {{first.x, 0}, {last.x, 1}};
    result.has_opacities = false;
    result.notes.emplace_back("no opacities are in the file: a ramp from 0 to 1 is taken, as ParaView does");
  }
  const std::string space = map.attribute("space").as_string("RGB");
  const ColorSpace in = space == "Lab" || space == "CIELAB"    ? ColorSpace::lab
                        : space == "Diverging"                 ? ColorSpace::diverging
                        : space == "HSV" || space == "Wrapped" ? ColorSpace::hsv
                        : space == "Step"                      ? ColorSpace::step
                                                               : ColorSpace::rgb;
  if (in == ColorSpace::rgb && space != "RGB")
    result.notes.push_back(fmt::format("the colour space {} is taken for RGB", space));
  TransferFunction& tf = result.preset.transfer_function;
  tf = straightened(std::move(colors), std::move(opacities), in);
  tf.unit = LengthUnit::voxel;
  result.notes.emplace_back("no unit distance is in the file: one voxel is taken, as ParaView does");
  return result;
}

}  // namespace

bool is_paraview_xml(std::string_view content, std::string_view extension) {
  return extension == ".xml" && content.find("<ColorMap") != content.npos;
}

std::vector<Imported> read_paraview_xml(std::string_view content) {
  const pugi::xml_document document = parse_xml(content);
  std::vector<Imported> all;
  for (const auto& found : document.select_nodes("//ColorMap")) all.push_back(read_color_map(found.node()));
  if (all.empty()) throw Error("no <ColorMap> is in the file");
  return all;
}

bool is_inviwo(std::string_view content, std::string_view extension) {
  return extension == ".itf" || (extension == ".xml" && content.find("<InviwoWorkspace") != content.npos);
}

std::vector<Imported> read_inviwo(std::string_view content) {
  const pugi::xml_document document = parse_xml(content);
  const pugi::xml_node root = document.child("InviwoWorkspace");
  if (!root) throw Error("not a transfer function of Inviwo's: <InviwoWorkspace> is missing");
  Imported result;
  struct Point {
    double x, opacity;
    glm::dvec3 color;
  };
  std::vector<Point> points;
  for (const pugi::xml_node& point : root.child("Points").children("Point")) {
    const pugi::xml_node rgba = point.child("rgba");
    points.push_back({number(point.child("pos"), "content"),
                      unit_number(rgba, "w"),
                      {unit_number(rgba, "x"), unit_number(rgba, "y"), unit_number(rgba, "z")}});
  }
  if (points.empty()) throw Error("has no <Point> with <pos> and <rgba>");
  // As Inviwo sorts them: by position, then by opacity
  std::ranges::stable_sort(points, {}, [](const Point& p) { return std::pair(p.x, p.opacity); });
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  for (const Point& p : points) {
    colors.push_back({p.x, p.color});
    opacities.push_back({p.x, p.opacity});
  }
  TransferFunction& tf = result.preset.transfer_function;
  tf = straightened(std::move(colors), std::move(opacities), ColorSpace::rgb);
  constexpr int relative = 0;
  if (root.child("type").attribute("content").as_int(relative) == relative) tf.domain = Domain::normalized;
  const double mask_min = root.child("maskMin").attribute("content").as_double(0),
               mask_max = root.child("maskMax").attribute("content").as_double(1);
  if (mask_min > 0 || mask_max < 1) result.notes.emplace_back("the mask is not kept");
  result.share_of_side = inviwo_share;
  result.notes.emplace_back(
      "opacities are those of 1/150 of the volume's side: one world unit is taken where no volume is known");
  return {std::move(result)};
}

}  // namespace crest
