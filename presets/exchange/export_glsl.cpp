// The TF as GLSL source, for a renderer of one's own.
#include <fmt/format.h>  // all of format_to: clang calls it otherwise than the library

#include <cmath>
#include <iterator>

#include "presets/error.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/script_text.h"
#include "presets/exchange/words.h"
#include "presets/peaks.h"

namespace crest {
namespace {

constexpr const char* function = R"(
// Colour and opacity of one unit distance at a value: linear between the points, at a step that of its right side. Over
// a length d the opacity is 1 - pow(1 - a, d / tf_unit_distance).
vec4 transfer_function(float value) {
  int low = 0, high = tf_count;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (tf_values[middle] <= value) low = middle;
    else high = middle;
  }
  if (high == tf_count || !(value > tf_values[low])) return tf_materials[low];
  return mix(tf_materials[low], tf_materials[high], (value - tf_values[low]) / (tf_values[high] - tf_values[low]));
}
)";

/// As GLSL reads it: with a point or an exponent.
std::string literal(double number) {
  std::string text = fmt::format("{}", float(number));
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string material(const glm::dvec3& color, double opacity) {
  return fmt::format("vec4({}, {}, {}, {})", literal(color.r), literal(color.g), literal(color.b),
                     literal(opacity));
}

/// "const TYPE NAME[n] = TYPE[](...);", an element to a line.
template <class Elements, class ToText>
std::string array_of(const char* type, const char* name, const Elements& elements, const ToText& to_text) {
  std::string text = fmt::format("const {0} {1}[{2}] = {0}[](\n", type, name, elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
    fmt::format_to(std::back_inserter(text), "  {}{}\n", to_text(elements[i]),
                   i + 1 < elements.size() ? "," : ");");
  return text;
}

}  // namespace

Exported write_glsl(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  if (!(float(tf.unit_distance) > 0) || !std::isfinite(float(tf.unit_distance)))
    throw Error(fmt::format("the unit distance {} is not a 32-bit float", tf.unit_distance));
  for (const ControlPoint& point : tf.points)
    if (!std::isfinite(float(point.value)))
      throw Error(fmt::format("the value {} is not a 32-bit float", point.value));
  std::vector<Peak> peaks = shown_peaks(find_peaks(tf));
  std::string text = fmt::format("// Written by Crest from the preset \"{}\". GLSL 3.30, GLSL ES 3.00.\n",
                                 one_line(input.name));
  fmt::format_to(std::back_inserter(text),
                 "const float tf_unit_distance = {};  // in world units\nconst int tf_count = {};\n",
                 literal(tf.unit_distance), tf.points.size());
  text += array_of("float", "tf_values", tf.points, [](const ControlPoint& p) { return literal(p.value); });
  text += array_of("vec4", "tf_materials", tf.points,
                   [](const ControlPoint& p) { return material(p.color, p.opacity); });
  text += function;
  fmt::format_to(std::back_inserter(text),
                 "\n// Surfaces at the peaks, by value: a ray that crosses one takes its colour, and its "
                 "opacity whole.\n"
                 "struct TfPeak {{ float value; vec4 color_opacity; }};\nconst int tf_peak_count = {};\n",
                 peaks.size());
  if (peaks.empty()) peaks.emplace_back();  // an array has an element
  text += array_of("TfPeak", "tf_peaks", peaks, [](const Peak& p) {
    return fmt::format("TfPeak({}, {})", literal(p.value), material(p.color, p.opacity));
  });
  Exported result;
  result.files.push_back({"", std::move(text)});
  int merged = 0;
  for (std::size_t i = 1; i < tf.points.size(); ++i)
    merged += tf.points[i].value != tf.points[i - 1].value &&
              float(tf.points[i].value) == float(tf.points[i - 1].value);
  if (merged > 0)
    result.losses.push_back(fmt::format("{} {} on the one before, in 32-bit float", merged,
                                        merged == 1 ? "point falls" : "points fall"));
  say_no_rendering(input, result.losses);
  return result;
}

Preset drawn_by_glsl(const ExportInput& input) {
  Preset drawn = input.preset;
  for (ControlPoint& point : drawn.transfer_function.points) point.value = double(float(point.value));
  return drawn;
}

}  // namespace crest
