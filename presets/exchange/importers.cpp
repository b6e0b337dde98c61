#include "presets/exchange/importers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/import_formats.h"
#include "presets/exchange/words.h"
#include "presets/json.h"
#include "presets/preset_json.h"
#include "presets/printable.h"

namespace crest {
namespace {

constexpr std::size_t largest_file = std::size_t(64) << 20;

std::string lower_extension(const std::filesystem::path& name) {
  std::string extension = name.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string summaries() {
  std::string text;
  for (const Importer& importer : importers())
    text += fmt::format("{}{}", text.empty() ? "" : "; ", importer.summary);
  return text;
}

}  // namespace

std::span<const Importer> importers() {
  static constexpr Importer list[] = {
      {"slicer", "3D Slicer's .vp.json", is_slicer_json, read_slicer_json},
      {"paraview", "ParaView's, vtk.js's and VolView's colour maps, .json", is_color_map_json,
       read_color_map_json},
      {"slicer-vp", "3D Slicer's .vp", is_slicer_vp, read_slicer_vp},
      {"slicer-presets", "3D Slicer's presets.xml", is_slicer_presets, read_slicer_presets},
      {"paraview-xml", "ParaView's colour maps, .xml", is_paraview_xml, read_paraview_xml},
      {"inviwo", "Inviwo's .itf", is_inviwo, read_inviwo},
      {"1dt", "ImageVis3D's and VisRTX's .1dt", is_1dt, read_1dt},
      {"csv", "tables, .csv: value, red, green, blue, opacity", is_csv, read_csv},
  };
  return list;
}

std::span<const std::string_view> preset_extensions() {
  static constexpr std::string_view list[] = {".json", ".vp", ".xml", ".itf", ".1dt", ".csv"};
  return list;
}

const Importer* find_importer(std::string_view content, const std::filesystem::path& name) {
  const std::string extension = lower_extension(name);
  const auto found =
      std::ranges::find_if(importers(), [&](const Importer& i) { return i.recognises(content, extension); });
  return found == importers().end() ? nullptr : &*found;
}

std::vector<Imported> import_presets(const std::filesystem::path& path) {
  return import_presets(read_file(path, largest_file), path);
}

std::vector<Imported> import_presets(std::string_view content, const std::filesystem::path& name) {
  const Importer* importer = find_importer(content, name);
  if (!importer)
    throw Error(fmt::format("{}: none of the formats that are imported: {}", name.string(), summaries()));
  try {
    std::vector<Imported> all = importer->read(content);
    for (Imported& one : all) {
      if (one.preset.name.empty()) one.preset.name = name.stem().string();
      one.preset.name = printable(one.preset.name);  // whatever bytes it had there
      preset_from_json(
          preset_to_json(one.preset, Fields::telling));  // what a preset may not hold is not let in
    }
    return all;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", name.string(), error.what()));
  }
}

TransferFunction for_volume(const Imported& imported, const glm::dvec3& size) {
  TransferFunction tf = imported.preset.transfer_function;
  if (imported.share_of_side > 0) tf.unit_distance = imported.share_of_side * mean_side(size);
  return tf;
}

const Imported& choose(const std::vector<Imported>& all, std::string_view name, std::string_view source) {
  std::string names;
  for (const Imported& one : all) {
    if (one.preset.name == name) return one;
    names += fmt::format("{}{}", names.empty() ? " " : ", ", one.preset.name);
  }
  if (name.empty() && all.size() == 1) return all.front();
  throw Error(name.empty() ? fmt::format("{}: has {} presets, of which --name chooses one:{}", source,
                                         all.size(), names)
                           : fmt::format("{}: has no preset named {}; there are:{}", source, name, names));
}

TransferFunction combined(const TransferFunction& base, const TransferFunction& other, TfParts take,
                          bool fit) {
  TransferFunction fitted = other;
  if (!base.points.empty() && (fit || (take != TfParts::both && base.domain != other.domain))) {
    fitted = remap_values(other, other.range(), base.range());
    fitted.domain = base.domain;
  }
  if (take == TfParts::both || base.points.empty()) return fitted;
  if (take == TfParts::colors) return merged(fitted, base);
  TransferFunction result = merged(base, fitted);
  result.min_prominence = base.min_prominence;
  result.plateau_width = base.plateau_width;
  result.spike_width = base.spike_width;
  return result;
}

bool is_over_unit_range(const TransferFunction& tf) {
  return tf.domain == Domain::data && tf.range() == ValueRange{0, 1};
}

}  // namespace crest
