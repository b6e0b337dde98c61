// ParaView's colour maps (an array of objects with RGBPoints and Points, Kitware/ParaView:
// Remoting/Views/ColorMaps.json) and their kin: vtk.js's and VolView's, whose OpacityPoints are pairs, and
// what VisRTX writes.
#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/import_formats.h"
#include "presets/json.h"
#include "presets/json_text.h"

namespace crest {
namespace {

/// Without a comma that follows another one, as VisRTX writes them. Texts in quotes stay as they are.
std::string without_doubled_commas(std::string_view text) {
  std::string result;
  bool quoted = false, after_comma = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    if (!quoted && c == ',' && after_comma) continue;
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') after_comma = !quoted && c == ',';
    result += c;
  }
  return result;
}

bool is_color_map(const Json& json) {
  return json.is_object() &&
         (json.contains("RGBPoints") || json.contains("IndexedColors") || json.contains("Points"));
}

std::vector<double> numbers(const Json& map, const char* key) {
  const auto found = map.find(key);
  if (found == map.end()) return {};
  if (!found->is_array()) throw Error(fmt::format("{} is not an array of numbers", key));
  std::vector<double> result;
  for (const Json& number : *found) {
    if (!number.is_number()) throw Error(fmt::format("{}[{}] is not a number", key, result.size()));
    result.push_back(number.get<double>());
  }
  return result;
}

double in_unit(double number, std::string_view key, std::size_t index) {
  if (!(number >= 0 && number <= 1))
    throw Error(fmt::format("{}[{}]: {} is not in [0, 1]", key, index, number));
  return number;
}

std::vector<ColorNode> color_nodes(const Json& map) {
  constexpr const char* key = "RGBPoints";
  const std::vector<double> flat = numbers(map, key);
  if (flat.size() % 4 != 0)
    throw Error(fmt::format("{} has {} numbers, which are not x, r, g, b each", key, flat.size()));
  std::vector<ColorNode> nodes;
  for (std::size_t i = 0; i < flat.size(); i += 4)
    nodes.push_back({flat[i],
                     {in_unit(flat[i + 1], key, i + 1), in_unit(flat[i + 2], key, i + 2),
                      in_unit(flat[i + 3], key, i + 3)}});
  return nodes;
}

bool is_ascending(const std::vector<double>& flat, std::size_t stride) {
  for (std::size_t i = stride; i < flat.size(); i += stride)
    if (flat[i] < flat[i - stride]) return false;
  return true;
}

/// x, opacity, midpoint, sharpness each, as ParaView writes them; else pairs. Where they could be either -
/// ascending both ways - they are quads if all are straight lines (0.5, 0), and more than one.
bool are_quads(const std::vector<double>& flat) {
  if (flat.size() % 4 != 0 || !is_ascending(flat, 4)) return false;
  bool are_straight = true;
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    for (const std::size_t k : {1u, 2u, 3u})
      if (!(flat[i + k] >= 0 && flat[i + k] <= 1)) return false;
    are_straight = are_straight && flat[i + 2] == 0.5 && flat[i + 3] == 0;
  }
  return !is_ascending(flat, 2) || (are_straight && flat.size() > 4);
}

std::vector<OpacityNode> opacity_nodes(const Json& map, std::vector<std::string>& notes) {
  const bool is_vtkjs = map.contains("OpacityPoints");
  const char* key = is_vtkjs ? "OpacityPoints" : "Points";
  const std::vector<double> flat = numbers(map, key);
  std::vector<OpacityNode> nodes;
  if (!is_vtkjs && are_quads(flat)) {
    for (std::size_t i = 0; i < flat.size(); i += 4)
      nodes.push_back({flat[i], flat[i + 1], flat[i + 2], flat[i + 3]});
    return nodes;
  }
  if (flat.size() % 2 != 0)
    throw Error(fmt::format("{} has {} numbers, which are not x, opacity each", key, flat.size()));
  if (!is_vtkjs)
    notes.emplace_back(
        "Points holds pairs of value and opacity, where ParaView has midpoint and sharpness too: taken for "
        "straight "
        "lines");
  for (std::size_t i = 0; i < flat.size(); i += 2)
    nodes.push_back({flat[i], in_unit(flat[i + 1], key, i + 1)});
  return nodes;
}

ColorSpace color_space(const Json& map, std::vector<std::string>& notes) {
  const std::string name = map.value("ColorSpace", std::string("RGB"));
  if (name == "RGB") return ColorSpace::rgb;
  if (name == "HSV") return ColorSpace::hsv;
  if (name == "Lab" || name == "CIELAB") return ColorSpace::lab;
  if (name == "Diverging") return ColorSpace::diverging;
  if (name == "Step") return ColorSpace::step;
  notes.push_back(fmt::format("the colour space {} is taken for Lab", name));
  return ColorSpace::lab;
}

Imported read_map(const Json& map) {
  Imported result;
  std::vector<ColorNode> colors = color_nodes(map);
  std::vector<OpacityNode> opacities = opacity_nodes(map, result.notes);
  if (colors.empty() && opacities.empty())
    throw Error(map.contains("IndexedColors")
                    ? "its colours are for categories (IndexedColors), not for values"
                    : "has neither RGBPoints nor Points");
  result.has_colors = !colors.empty();
  result.has_opacities = !opacities.empty();
  if (opacities.empty()) {
    const auto [first, last] = std::ranges::minmax(colors, {}, &ColorNode::x);
    opacities = {{first.x, 0}, {last.x, 1}};
    result.notes.emplace_back("no opacities are in the file: a ramp from 0 to 1 is taken, as ParaView does");
  }
  result.preset.name = map.value("Name", std::string());
  TransferFunction& tf = result.preset.transfer_function;
  tf = straightened(std::move(colors), std::move(opacities), color_space(map, result.notes));
  tf.unit = LengthUnit::voxel;
  result.notes.emplace_back("no unit distance is in the file: one voxel is taken, as ParaView does");
  if (map.value("UseLogScale", 0) != 0)
    result.notes.emplace_back("the logarithmic scale of values is not kept");
  return result;
}

/// Why a map cannot be read, whatever it was that stumbled over it.
std::string why_not(const Json& map, std::vector<Imported>& all) {
  try {
    all.push_back(read_map(map));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

bool is_color_map_json(std::string_view content, std::string_view extension) {
  if (extension != ".json") return false;
  return content.find("\"RGBPoints\"") != content.npos || content.find("\"Points\"") != content.npos ||
         content.find("\"IndexedColors\"") != content.npos ||
         content.find("\"OpacityPoints\"") != content.npos;
}

std::vector<Imported> read_color_map_json(std::string_view content) {
  Json root;
  bool had_doubled_commas = false;
  try {
    root = parse_json(content);
  } catch (const Error&) {
    const std::string mended = without_doubled_commas(content);
    if (mended.size() == content.size()) throw;
    root = parse_json(mended);
    had_doubled_commas = true;
  }
  if (root.is_object()) root = Json::array({root});
  std::vector<Imported> all;
  std::string fault;  // of the first one that cannot be read: told where no other can
  for (std::size_t i = 0; root.is_array() && i < root.size(); ++i) {
    if (!is_color_map(root[i])) continue;
    const std::string why = why_not(root[i], all);
    if (!why.empty() && fault.empty()) fault = fmt::format("colour map {}: {}", i, why);
    if (why.empty() && had_doubled_commas)
      all.back().notes.emplace_back("commas that stand twice in the file are read as one");
  }
  if (all.empty() && !fault.empty()) throw Error(fault);
  if (all.empty()) throw Error("no colour map with RGBPoints is in the file");
  return all;
}

}  // namespace crest
