#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "presets/exchange/exporters.h"

namespace crest {

inline ControlPoint point(double value, double opacity) {
  return {.value = value, .color = glm::dvec3(1), .opacity = opacity, .surface = {}, .unknown = {}};
}

inline TransferFunction spike() {
  TransferFunction tf;
  tf.unit_distance = 4;
  for (const double value : {0.0, 0.5, 0.5, 0.5, 1.0}) tf.points.push_back(point(value, 0));
  tf.points[2].opacity = 0.9;
  tf.points[2].color = {1, 0, 0};
  return tf;
}

inline ExportInput input_of(TransferFunction tf) {
  ExportInput input;
  input.name = "Name";
  input.stem = "file";
  input.preset.transfer_function = std::move(tf);
  return input;
}

inline Exported exported(std::string_view format, const ExportInput& input) {
  return find_exporter(format).write(input);
}
inline std::string text_of(std::string_view format, const ExportInput& input) {
  return exported(format, input).files.at(0).content;
}

inline bool any_says(const std::vector<std::string>& sentences, std::string_view words) {
  return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(words) != s.npos; });
}

}  // namespace crest
