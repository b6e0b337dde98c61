// Presets, what changes them, and what is made of them.
#include <algorithm>
#include <random>

#include <fmt/core.h>

#include "presets/error.h"
#include "presets/exchange/exporters.h"
#include "presets/exchange/importers.h"
#include "presets/peaks.h"
#include "presets/points_text.h"
#include "presets/preset_changes.h"
#include "presets/preset_file.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"
#include "tests/presets/random_preset.h"

namespace crest::fuzz {
namespace {

void require_kept(const Preset& preset) {
  const std::string text = write_preset(preset);
  const Preset again = parse_preset(text, "again");
  require(again == preset, "a preset is the same when it is written and read again");
  require(write_preset(again) == text, "its text is the same, too");
  require(is_own_preset(text), "it is known as a preset");
}

/// The fields of the sample, for --set.
Preset base() {
  std::mt19937 random(7);
  Preset preset = random_preset(random);
  preset.rendering = {};
  return preset;
}

}  // namespace

void read_preset(std::string_view input) {
  is_own_preset(input);
  const Preset preset = parse_preset(input, "file");
  require_kept(preset);
  const std::vector<Peak> peaks = find_peaks(preset.transfer_function);
  base_transfer_function(preset.transfer_function, peaks);
  require(preset_changes(preset, preset).empty(), "nothing leads from a preset to itself");
  preset_changes(base(), preset);
}

std::vector<std::string> preset_seeds() {
  std::vector<std::string> seeds;
  for (const LibraryPreset& preset : library()) seeds.emplace_back(preset.text);
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i) seeds.push_back(write_preset(random_preset(random)));
  return seeds;
}

void read_exported(std::string_view input) {
  ExportInput in{.name = "a name", .stem = "file", .preset = {}, .volume = {}, .rows = 16};
  in.volume = ExportVolume{.file = "/a 'b'.nrrd",
                           .name = "v",
                           .range = {-10, 300},
                           .dims = {5, 4, 3},
                           .spacing = {1, 2, 3},
                           .origin = {},
                           .raw = {}};
  const Preset preset = parse_preset(input, "file");
  in.name = preset.name;
  in.preset = ready_for_export(preset, in.volume);
  for (const Exporter& exporter : exporters()) {
    Exported exported;
    try {
      exported = exporter.write(in);
    } catch (const Error&) {
      continue;  // this target cannot have it
    }
    exporter.as_drawn(in);
    const std::string name = "file" + std::string(exporter.extension);
    const std::string& content = exported.files.at(0).content;
    if (const Importer* importer = find_importer(content, name)) {
      const auto imported = importer->read(content);
      require(!imported.empty(), fmt::format("what is written as {} can be read", exporter.name));
    }
  }
}

void read_points(std::string_view input) {
  const TransferFunction tf = points_in(input);
  require(points_in(points_text(tf)).points == tf.points, "points are the same when they are copied again");
}

std::vector<std::string> points_seeds() {
  std::vector<std::string> seeds;
  std::mt19937 random(2);
  for (int i = 0; i < 6; ++i) {
    const Preset preset = random_preset(random);
    seeds.push_back(points_text(preset.transfer_function));
    if (i == 0) seeds.push_back(write_preset(preset));
  }
  return seeds;
}

void read_assignments(std::string_view input) {
  const Preset before = base();
  Preset preset = before;
  while (!input.empty()) {
    const std::size_t end = std::min(input.find('\n'), input.size());
    preset = set_field(preset, input.substr(0, end));
    input.remove_prefix(std::min(end + 1, input.size()));
  }
  require_kept(preset);
  preset_changes(before, preset);
  Preset led = before;
  for (const std::string& assignment : assignments_between(before.rendering, preset.rendering))
    led = set_field(led, assignment);
  require(led.rendering == preset.rendering, "assignments_between leads from one rendering to the other");
}

std::vector<std::string> assignment_seeds() {
  std::vector<std::string> seeds = {"rendering.step=0.5\nrendering.mode=DVR_ONLY",
                                    "transfer_function.points[0].opacity=0.3\ncamera=null",
                                    "transfer_function.points=[{\"value\":0,\"opacity\":1}]\nname=\"a\"",
                                    "rendering.clip_box={\"min\":[0,0,0],\"max\":[1,1,1]}",
                                    "camera.eye[0]=1e3\ntags=[\"a\",\"b\"]",
                                    "transfer_function.points[0].surface.mode=on"};
  std::mt19937 random(3);
  const Preset from = base();
  for (int i = 0; i < 12; ++i) {
    std::string lines;
    for (const std::string& line : assignments_between(from.rendering, random_preset(random).rendering))
      lines += line + "\n";
    seeds.push_back(lines);
  }
  return seeds;
}

}  // namespace crest::fuzz
