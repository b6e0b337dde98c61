#include "presets/points_text.h"

#include "presets/error.h"
#include "presets/json.h"
#include "presets/preset_json.h"

namespace crest {

std::string points_text(const TransferFunction& points) {
  Preset preset;
  preset.transfer_function = points;
  const Json tf = preset_to_json(preset, Fields::telling)["transfer_function"];
  return print_json({{"domain", tf["domain"]}, {"points", tf["points"]}});
}

TransferFunction points_in(std::string_view text) {
  Json json = parse_json(text);
  if (!json.is_object()) throw Error(summary_of(json) + " holds no points");
  if (!json.contains("transfer_function")) json = {{"transfer_function", std::move(json)}};
  TransferFunction points = preset_from_json(std::move(json)).transfer_function;
  if (points.points.empty()) throw Error("it holds no points");
  return points;
}

}  // namespace crest
