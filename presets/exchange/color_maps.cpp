#include "presets/exchange/color_maps.h"

#include "color_maps_embedded.h"
#include "presets/exchange/import_formats.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/peaks.h"

namespace crest {
namespace {

std::vector<glm::dvec3> distinct_colors(const Json& flat) {
  std::vector<glm::dvec3> colors;
  for (std::size_t i = 0; i + 2 < flat.size(); i += 3)
    colors.emplace_back(flat[i].get<double>(), flat[i + 1].get<double>(), flat[i + 2].get<double>());
  return colors;
}

TransferFunction with_distinct_colors(const TransferFunction& tf, const std::vector<glm::dvec3>& colors) {
  TransferFunction result = tf;
  std::size_t next = 0;
  for (const Peak& peak : find_peaks(tf)) {
    if (!peak.shown) continue;
    const glm::dvec3 color = colors[next++ % colors.size()];
    for (std::size_t i = peak.left; i <= peak.right; ++i) result.points[i].color = color;
  }
  return result;
}

}  // namespace

std::vector<ColorMap> color_maps() {
  std::vector<ColorMap> maps;
  for (const Json& json : parse_json(color_maps::embedded_files()[0].text)) {
    ColorMap map{.name = json["Name"], .source = json["Source"], .colors = {}, .distinct = {}};
    if (json.contains("IndexedColors")) {
      map.distinct = distinct_colors(json["IndexedColors"]);
    } else {
      map.colors = read_color_map_json(json.dump())[0].preset.transfer_function;
      map.in_data_values = json.contains("Values");
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

TransferFunction with_color_map(const TransferFunction& tf, const ColorMap& map, ValueRange volume) {
  if (!map.distinct.empty()) return with_distinct_colors(tf, map.distinct);
  const bool is_share = map.in_data_values && tf.domain == Domain::normalized;
  const TransferFunction colors = is_share             ? remap_values(map.colors, volume, {0, 1})
                                  : map.in_data_values ? map.colors
                                                       : remap_values(map.colors, {0, 1}, tf.range());
  TransferFunction result = tf;
  for (ControlPoint& point : result.points) point.color = evaluate(colors, point.value).color;
  return result;
}

}  // namespace crest
