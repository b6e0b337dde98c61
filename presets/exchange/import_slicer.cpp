// 3D Slicer's volume properties: .vp.json, .vp, and the entries of presets.xml.
#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/import_formats.h"
#include "presets/exchange/numbers_text.h"
#include "presets/exchange/xml_text.h"
#include "presets/json.h"
#include "presets/json_text.h"

namespace crest {
namespace {

constexpr const char* gradient_note = "opacity by gradient is not kept: Crest has none";

void require_unit(double number, const char* what, double x) {
  if (!(number >= 0 && number <= 1))
    throw Error(fmt::format("the {} at {}: {} is not in [0, 1]", what, x, number));
}

/// A property as a preset.
Imported make_imported(std::string name, std::vector<ColorNode> colors, std::vector<OpacityNode> opacities,
                       bool shaded) {
  if (colors.empty() && opacities.empty()) throw Error("has neither colours nor opacities");
  for (const ColorNode& n : colors) {
    for (const double c : {n.color.r, n.color.g, n.color.b}) require_unit(c, "colour", n.x);
    require_unit(n.midpoint, "midpoint", n.x);
    require_unit(n.sharpness, "sharpness", n.x);
  }
  for (const OpacityNode& n : opacities) {
    require_unit(n.opacity, "opacity", n.x);
    require_unit(n.midpoint, "midpoint", n.x);
    require_unit(n.sharpness, "sharpness", n.x);
  }
  Imported result;
  result.preset.name = std::move(name);
  result.has_colors = !colors.empty();
  result.has_opacities = !opacities.empty();
  result.preset.transfer_function = straightened(std::move(colors), std::move(opacities), ColorSpace::rgb);
  result.preset.rendering.shading = shaded ? Shading::gradient : Shading::none;
  return result;
}

const Json& member(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw Error(fmt::format("{} is missing", key));
  return *found;
}

Imported read_component(const Json& property) {
  const Json& components = member(property, "components");
  if (!components.is_array() || components.empty()) throw Error("components is not an array with an element");
  const Json& component = components[0];
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  if (component.contains("rgbTransferFunction"))
    for (const Json& p : member(component["rgbTransferFunction"], "points")) {
      const auto color = member(p, "color").get<std::vector<double>>();
      if (color.size() != 3) throw Error("a colour has not three numbers");
      colors.push_back({member(p, "x").get<double>(), glm::dvec3(color[0], color[1], color[2]),
                        p.value("midpoint", 0.5), p.value("sharpness", 0.0)});
    }
  if (component.contains("scalarOpacity"))
    for (const Json& p : member(component["scalarOpacity"], "points"))
      opacities.push_back({member(p, "x").get<double>(), member(p, "y").get<double>(),
                           p.value("midpoint", 0.5), p.value("sharpness", 0.0)});
  Imported result = make_imported(property.value("name", std::string()), std::move(colors),
                                  std::move(opacities), component.value("shade", false));
  result.preset.transfer_function.unit_distance = component.value("scalarOpacityUnitDistance", 1.0);
  if (components.size() > 1) result.notes.emplace_back("only the first component is read");
  const auto gradient = component.find("gradientOpacity");
  if (gradient != component.end() && !component.value("disableGradientOpacity", false))
    for (const Json& p : member(*gradient, "points"))
      if (member(p, "y").get<double>() != 1) {
        result.notes.emplace_back(gradient_note);
        break;
      }
  return result;
}

/// "COUNT number number ...", as the numbers.
std::vector<double> counted(std::string_view text, const char* what, std::size_t stride) {
  const auto read = to_numbers(text);
  if (!read) throw Error(fmt::format("{} has something in it that is not a number", what));
  if (read->empty()) return {};
  if (double(read->size() - 1) != read->front() || (read->size() - 1) % stride != 0)
    throw Error(fmt::format("{} says that it has {} numbers, {} each, and has {}", what, read->front(),
                            stride, read->size() - 1));
  return {read->begin() + 1, read->end()};
}

Imported from_texts(std::string name, std::string_view opacity, std::string_view gradient,
                    std::string_view color, bool shaded) {
  std::vector<OpacityNode> opacities;
  std::vector<ColorNode> colors;
  const std::vector<double> o = counted(opacity, "scalarOpacity", 2), c = counted(color, "colorTransfer", 4),
                            g = counted(gradient, "gradientOpacity", 2);
  for (std::size_t i = 0; i < o.size(); i += 2) opacities.push_back({o[i], o[i + 1]});
  for (std::size_t i = 0; i < c.size(); i += 4) colors.push_back({c[i], {c[i + 1], c[i + 2], c[i + 3]}});
  Imported result = make_imported(std::move(name), std::move(colors), std::move(opacities), shaded);
  result.notes.emplace_back("no unit distance is in the file: one world unit is taken, as Slicer does");
  for (std::size_t i = 1; i < g.size(); i += 2)
    if (g[i] != 1) {
      result.notes.emplace_back(gradient_note);
      break;
    }
  return result;
}

}  // namespace

bool is_slicer_json(std::string_view content, std::string_view extension) {
  return extension == ".json" && content.find("\"volumeProperties\"") != content.npos;
}

std::vector<Imported> read_slicer_json(std::string_view content) {
  const Json root = parse_json(content);
  std::vector<Imported> all;
  try {
    const Json& properties = member(root, "volumeProperties");
    for (const Json& property : properties) {
      all.push_back(read_component(property));
      if (properties.size() > 1 && all.size() > 1)
        all.back().notes.emplace_back("Slicer itself reads the first property alone");
    }
  } catch (const Json::exception& error) {
    throw Error(fmt::format("volumeProperties[{}]: {}", all.size(), error.what()));
  } catch (const Error& error) {
    throw Error(fmt::format("volumeProperties[{}]: {}", all.size(), error.what()));
  }
  if (all.empty()) throw Error("volumeProperties is empty");
  return all;
}

bool is_slicer_vp(std::string_view, std::string_view extension) { return extension == ".vp"; }

std::vector<Imported> read_slicer_vp(std::string_view content) {
  const std::vector<std::string_view> lines = lines_of(content);
  if (lines.size() < 9)
    throw Error(
        fmt::format("has {} lines, where a volume property has nine: interpolation, shade, diffuse, ambient, "
                    "specular, power, opacity, opacity by gradient, colour",
                    lines.size()));
  const auto shade = to_numbers(lines[1]);
  if (!shade || shade->size() != 1) throw Error("line 2, shade, is not a number");
  return {from_texts("", lines[6], lines[7], lines[8], shade->front() != 0)};
}

bool is_slicer_presets(std::string_view content, std::string_view extension) {
  return extension == ".xml" && content.find("<VolumeProperty") != content.npos;
}

std::vector<Imported> read_slicer_presets(std::string_view content) {
  const pugi::xml_document document = parse_xml(content);
  std::vector<Imported> all;
  for (const auto& found : document.select_nodes("//VolumeProperty")) {
    const pugi::xml_node node = found.node();
    const std::string name = node.attribute("name").as_string();
    try {
      all.push_back(from_texts(
          name, node.attribute("scalarOpacity").as_string(), node.attribute("gradientOpacity").as_string(),
          node.attribute("colorTransfer").as_string(), node.attribute("shade").as_int() != 0));
    } catch (const Error& error) {
      throw Error(fmt::format("VolumeProperty \"{}\": {}", name, error.what()));
    }
  }
  if (all.empty()) throw Error("no VolumeProperty is in the file");
  return all;
}

}  // namespace crest
