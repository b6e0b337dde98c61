#include "presets/preset_file.h"
#include "tests/json.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "presets/error.h"
#include "presets/names.h"
#include "tests/presets/random_preset.h"

namespace crest {
namespace {

using nlohmann::json;

/// A whole preset with every field, to be spoiled one field at a time.
json sample() {
  return test::parse_json(R"({
    "format": "crest-preset", "version": 1, "name": "Two shells", "notes": "n",
    "transfer_function": {"domain": "normalized", "unit_distance": 2.5, "unit": "voxel", "min_prominence": 0.1,
      "plateau_width": 0.25, "spike_width": 0.02,
      "points": [{"value": 0, "color": [0, 0, 1], "opacity": 0},
                 {"value": 120.5, "color": [1, 0.2, 0], "opacity": 0.9, "surface": {"mode": "on", "opacity": 0.75}},
                 {"value": 120.5, "opacity": 0.25}]},
    "rendering": {"mode": "PEAK_XOR_DVR", "peak_form": "paper", "engine": "raycaster", "step": 0.25,
      "vdls": {"homo_regions": false, "leaves": 64, "merge_threshold": 3, "early_test": false, "layers_per_pass": 2,
               "back_to_front": true, "gradient_volume": false},
      "classification": "preintegrated", "preintegration_bins": 512, "placement": "eye", "sampling": "footprint",
      "s_k": 0.5, "adaptive": true, "skipping": false, "filter": "bspline", "root_filter": "bc", "bc_b": 1,
      "bc_c": -0.25, "gradient": "filter", "max_peaks": 2, "clip_box": {"min": [-1, 0, 0.5], "max": [1, 2, 3]}, "peak_bins": 64,  "shading": "gradient", "early_termination": 0.001, "background": [0.1, 0.2, 0.3]},
    "camera": {"eye": [1, 2, 3], "target": [0, 0, 1], "up": [0, 1, 0], "fov_y_degrees": 45}})");
}

std::string error_of(const std::string& text) {
  try {
    parse_preset(text, "FILE");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParsePreset, ReadsEveryField) {
  const Preset p = parse_preset(sample().dump(), "FILE");
  EXPECT_EQ(p.name, "Two shells");
  EXPECT_EQ(p.notes, "n");
  const TransferFunction& tf = p.transfer_function;
  EXPECT_EQ(tf.domain, Domain::normalized);
  EXPECT_EQ(tf.unit, LengthUnit::voxel);
  EXPECT_EQ(tf.unit_distance, 2.5);
  EXPECT_EQ(tf.min_prominence, 0.1);
  EXPECT_EQ(tf.plateau_width, 0.25);
  EXPECT_EQ(tf.spike_width, 0.02);
  ASSERT_EQ(tf.points.size(), 3u);
  EXPECT_EQ(tf.points[1].value, 120.5);
  EXPECT_EQ(tf.points[1].color, glm::dvec3(1, 0.2, 0));
  EXPECT_EQ(tf.points[1].opacity, 0.9);
  EXPECT_EQ(tf.points[1].surface, (Surface{SurfaceMode::on, 0.75}));
  EXPECT_EQ(tf.points[2].color, glm::dvec3(1)) << "white by default";
  EXPECT_EQ(p.rendering.mode, Mode::peak_xor_dvr);
  EXPECT_EQ(p.rendering.peak_form, PeakForm::paper);
  EXPECT_EQ(p.rendering.step, 0.25);
  EXPECT_EQ(p.rendering.classification, ClassificationMethod::preintegrated);
  EXPECT_EQ(p.rendering.preintegration_bins, 512);
  EXPECT_EQ(p.rendering.vdls, (VdlsOptions{false, 64, 3, false, 2, true, false}));
  EXPECT_EQ(p.rendering.placement, Placement::eye);
  EXPECT_EQ(p.rendering.sampling, Sampling::footprint);
  EXPECT_EQ(p.rendering.s_k, 0.5);
  EXPECT_TRUE(p.rendering.adaptive);
  EXPECT_FALSE(p.rendering.skipping);
  EXPECT_EQ(p.rendering.filter, Filter::bspline);
  EXPECT_EQ(p.rendering.root_filter, Filter::bc);
  EXPECT_EQ(p.rendering.bc_b, 1);
  EXPECT_EQ(p.rendering.bc_c, -0.25);
  EXPECT_EQ(p.rendering.gradient, Gradient::filter);
  EXPECT_EQ(p.rendering.clip_box, (ClipBox{{-1, 0, 0.5}, {1, 2, 3}, ""}));
  EXPECT_EQ(p.rendering.max_peaks, 2);
  EXPECT_EQ(p.rendering.peak_bins, 64);
  EXPECT_EQ(p.rendering.shading, Shading::gradient);
  EXPECT_EQ(p.rendering.early_termination, 0.001);
  EXPECT_EQ(p.rendering.background, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(p.camera->eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(p.camera->fov_y_degrees, 45);
}

TEST(ParsePreset, NeedsOnlyThePoints) {
  const Preset p =
      parse_preset(R"({"transfer_function": {"points": [{"value": 1, "opacity": 0.5}]}})", "FILE");
  EXPECT_EQ(p.rendering, Rendering{});
  EXPECT_FALSE(p.camera);
  TransferFunction expected;
  expected.points.resize(1);
  expected.points[0].value = 1;
  expected.points[0].opacity = 0.5;
  EXPECT_EQ(p.transfer_function, expected);
}

TEST(WritePreset, RoundTripsExactly) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Preset preset = random_preset(random);
    const std::string text = write_preset(preset);
    ASSERT_EQ(parse_preset(text, "FILE"), preset) << text;
    EXPECT_EQ(write_preset(parse_preset(text, "FILE")), text);
  }
}

TEST(WritePreset, IsMadeToBeReadByPeople) {
  Preset preset;
  preset.name = "Shell";
  preset.transfer_function.points.resize(2);
  preset.transfer_function.points[1].value = 120.5;
  preset.transfer_function.points[1].surface.opacity = 0.25;
  preset.rendering.step = 0.25;
  preset.camera.emplace();
  EXPECT_EQ(write_preset(preset), R"({
  "format": "crest-preset",
  "version": 1,
  "name": "Shell",
  "notes": "",
  "transfer_function": {
    "domain": "data",
    "unit_distance": 1,
    "unit": "world",
    "points": [
      {"value": 0, "color": [1, 1, 1], "opacity": 0},
      {"value": 120.5, "color": [1, 1, 1], "opacity": 0, "surface": {"opacity": 0.25}}
    ]
  },
  "rendering": {
    "mode": "both",
    "engine": "raycaster",
    "step": 0.25
  },
  "camera": {
    "eye": [0, 0, 0],
    "target": [0, 0, 1],
    "up": [0, 1, 0],
    "fov_y_degrees": 30
  }
}
)");
}

TEST(WritePreset, KeepsUnknownKeysWhereTheyWere) {
  json with_unknown = sample();
  for (const char* place : {"", "/transfer_function", "/transfer_function/points/0",
                            "/transfer_function/points/1/surface", "/rendering", "/camera"})
    with_unknown[json::json_pointer(place)]["later"] = {{"deep", {1, 2.5, nullptr, "text"}},
                                                        {"big", 123456789012}};
  const Preset preset = parse_preset(with_unknown.dump(), "FILE");
  const json written = test::parse_json(write_preset(preset));
  for (const char* place : {"", "/transfer_function", "/transfer_function/points/0",
                            "/transfer_function/points/1/surface", "/rendering", "/camera"})
    EXPECT_EQ(written[json::json_pointer(place)].value("later", json()), with_unknown["later"]) << place;
  EXPECT_EQ(written["transfer_function"]["points"][1]["surface"]["opacity"], 0.75);
  EXPECT_EQ(parse_preset(write_preset(preset), "FILE"), preset);
}

struct Spoiled {
  const char* place;
  const char* value;
  const char* error;
};

TEST(ParsePreset, RefusesWrongFieldsWithTheirPath) {
  const Spoiled cases[] = {
      {"/transfer_function/points/1/opacity", "1.2",
       "transfer_function.points[1].opacity: 1.2 is not in [0, 1]"},
      {"/transfer_function/points/1/opacity", "-0.1",
       "transfer_function.points[1].opacity: -0.1 is not in [0, 1]"},
      {"/transfer_function/points/1/opacity", "\"x\"",
       "transfer_function.points[1].opacity: \"x\" is not a number"},
      {"/transfer_function/points/1/opacity", "null",
       "transfer_function.points[1].opacity: null is not a number"},
      {"/transfer_function/points/1/value", "-3",
       "transfer_function.points[1].value: -3 is less than the value before it, 0; values must not decrease"},
      {"/transfer_function/points/2/value", "1e305",
       "transfer_function.points[2].value: 1e+305 is not in [-1e+300, 1e+300]"},
      {"/transfer_function/points/0/color", "[1, 0]",
       "transfer_function.points[0].color: [1,0] is not an array of 3 numbers"},
      {"/transfer_function/points/0/color", "[0, 0, 256]",
       "transfer_function.points[0].color[2]: 256 is not in [0, 1]"},
      {"/transfer_function/points/1/surface", "true",
       "transfer_function.points[1].surface: true is not an object"},
      {"/transfer_function/points/1/surface/mode", "\"ON\"",
       "transfer_function.points[1].surface.mode: \"ON\" is not one of: auto, on, off; did you mean on?"},
      {"/transfer_function/points/1/surface/opacity", "2",
       "transfer_function.points[1].surface.opacity: 2 is not in [0, 1]"},
      {"/transfer_function/points/1", "7", "transfer_function.points[1]: 7 is not an object"},
      {"/transfer_function/points", "[]",
       "transfer_function.points: holds no point: a transfer function needs at least one"},
      {"/transfer_function/points", "{}", "transfer_function.points: {} is not an array of points"},
      {"/transfer_function", "[1,2,3,4,5]", "transfer_function: an array of 5 is not an object"},
      {"/transfer_function/unit_distance", "0", "transfer_function.unit_distance: 0 is not greater than 0"},
      {"/transfer_function/plateau_width", "-1", "transfer_function.plateau_width: -1 is not at least 0"},
      {"/transfer_function/domain", "\"date\"",
       "transfer_function.domain: \"date\" is not one of: data, normalized; did you mean data?"},
      {"/rendering/mode", "\"XOR\"",
       "rendering.mode: \"XOR\" is not one of: both, PEAK_XOR_DVR, PEAK_ONLY, DVR_ONLY"},
      {"/rendering/step", "-0.5", "rendering.step: -0.5 is not at least 0.001"},
      {"/rendering/placement", "\"corner\"",
       "rendering.placement: \"corner\" is not one of: eye, entry, entry_exit, entry_exit_corner"},
      {"/rendering/clip_box", R"({"min": [0, 0, 5], "max": [1, 1, 5]})",
       "rendering.clip_box: min 5 is not less than max 5 on axis z"},
      {"/rendering/clip_box", R"({"max": [1, 1, 5]})", "rendering.clip_box.min: is missing"},
      {"/rendering/clip_box", R"({"min": [0, 0], "max": [1, 1, 5]})",
       "rendering.clip_box.min: [0,0] is not an array of 3 numbers"},
      {"/rendering/max_peaks", "2.5", "rendering.max_peaks: 2.5 is not a whole number"},
      {"/rendering/max_peaks", "65", "rendering.max_peaks: 65 is not in [1, 64]"},
      {"/rendering/adaptive", "1", "rendering.adaptive: 1 is not true or false"},
      {"/rendering/root_filter", "\"cubic\"",
       "rendering.root_filter: \"cubic\" is not one of: linear, linear_exact, bspline, bc"},
      {"/rendering/peak_bins", "1e200", "rendering.peak_bins: 1e+200 is not in [1, 4096]"},
      {"/camera/fov_y_degrees", "180", "camera.fov_y_degrees: 180 is not in (0, 180)"},
      {"/tags", "\"CT\"", "tags: \"CT\" is not an array of texts"},
      {"/tags", "[\"CT\", 3]", "tags[1]: 3 is not a text in quotes"},
      {"/camera/eye", "\"0,0,0\"", "camera.eye: \"0,0,0\" is not an array of 3 numbers"},
      {"/name", "5", "name: 5 is not a text in quotes"},
      {"/format", "\"other\"", "format: \"other\" is not \"crest-preset\""},
      {"/version", "2", "version: 2 is of a newer Crest: this one reads up to 1"},
  };
  for (const auto& [place, value, error] : cases) {
    json spoiled = sample();
    spoiled[json::json_pointer(place)] = test::parse_json(value);
    EXPECT_EQ(error_of(spoiled.dump()), std::string("FILE: ") + error);
  }
}

// Each of these fields is right by itself. Set one by one, they only have to fit in the end.
TEST(ParsePreset, RefusesSettingsThatDoNotGoTogether) {
  json spoiled = sample();
  spoiled["rendering"] = {{"classification", "analytic"}, {"root_filter", "bspline"}};
  EXPECT_EQ(error_of(spoiled.dump()),
            "FILE: rendering.root_filter: classification analytic solves trilinear fields, of the filters "
            "linear and "
            "linear_exact; bspline is sampled, by classification preintegrated or post");
  spoiled["rendering"]["root_filter"] = "linear_exact";
  EXPECT_EQ(why_inconsistent(parse_preset(spoiled.dump(), "FILE").rendering), "");
  spoiled["rendering"] = {{"classification", "preintegrated_table"}};
  EXPECT_EQ(
      error_of(spoiled.dump()),
      "FILE: rendering.placement: the pre-integrated table holds steps of one length, which takes placement "
      "entry, not entry_exit_corner (classification preintegrated has no such limit)");
  spoiled["rendering"]["placement"] = "entry";
  EXPECT_EQ(why_inconsistent(parse_preset(spoiled.dump(), "FILE").rendering), "");
  spoiled["rendering"]["sampling"] = "footprint";
  EXPECT_TRUE(error_of(spoiled.dump()).starts_with("FILE: rendering.sampling: "));
  spoiled["rendering"]["sampling"] = "uniform";
  spoiled["rendering"]["adaptive"] = true;
  EXPECT_TRUE(error_of(spoiled.dump()).starts_with("FILE: rendering.adaptive: "));
}

TEST(ParsePreset, RefusesMissingFields) {
  EXPECT_EQ(error_of("{}"), "FILE: transfer_function: is missing");
  EXPECT_EQ(error_of(R"({"transfer_function": {}})"), "FILE: transfer_function.points: is missing");
  EXPECT_EQ(error_of(R"({"transfer_function": {"points": [{"value": 0, "opacity": 0}, {"opacity": 0}]}})"),
            "FILE: transfer_function.points[1].value: is missing");
  EXPECT_EQ(error_of(R"({"transfer_function": {"points": [{"value": 0}]}})"),
            "FILE: transfer_function.points[0].opacity: is missing");
}

TEST(ParsePreset, RefusesWhatIsNotJSON) {
  EXPECT_EQ(error_of("{\n  \"name\": NaN}").substr(0, 44), "FILE: parse error at line 2, column 11: synt");
  EXPECT_EQ(error_of("").find("FILE: parse error at line 1, column 1"), 0u);
  EXPECT_EQ(error_of("[]"), "FILE: [] is not an object");
  EXPECT_EQ(error_of(R"({"transfer_function": {"points": [{"value": 0, "opacity": 0}, {"value": 1e999}]}})"),
            "FILE: transfer_function.points[1].value: number overflow parsing '1e999'");
  EXPECT_EQ(error_of(R"({"rendering": {"step": 1, "mode": "both", "step": 2}})"),
            "FILE: rendering.step: appears twice");
  EXPECT_NE(error_of("{\"name\": \"\xff\"}").find("invalid"), std::string::npos);
  EXPECT_NE(error_of(std::string("{\"name\": \"a\0b\"}", 15)).find("parse error"), std::string::npos);
  EXPECT_NE(error_of(sample().dump() + std::string("\0garbage", 8)).find("parse error"), std::string::npos);
}

TEST(ParsePreset, SurvivesHostileTexts) {
  EXPECT_EQ(error_of(std::string(4 << 20, '[')), "FILE: nested more than 64 levels deep");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(error_of(objects), "FILE: nested more than 64 levels deep");
  std::string keys = "{";
  for (int i = 0; i < 300000; ++i) keys += fmt::format("\"k{}\":0,", i);
  EXPECT_EQ(error_of(keys + "\"name\":0}"), "FILE: k1000: one object has more than 1000 keys");
  std::string elements = "[";
  for (int i = 0; i < 5000000; ++i) elements += "{},";
  EXPECT_EQ(error_of(elements + "0]"), "FILE: an array of 5000001 is not an object");
  EXPECT_NE(error_of(std::string(17 << 20, ' ')).find("more than a preset may have"), std::string::npos);
  const std::string text = sample().dump();
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_NE(error_of(text.substr(0, length)), "no error") << length;
}

TEST(ParsePreset, ReadsManyPoints) {
  Preset preset;
  preset.transfer_function.points.resize(50000);
  for (std::size_t i = 0; i < 50000; ++i) preset.transfer_function.points[i].value = double(i) / 7;
  EXPECT_EQ(parse_preset(write_preset(preset), "FILE"), preset);
}

TEST(Names, ReadBackAndListAll) {
  for (const auto& [value, name] : names_of<Mode>()) {
    EXPECT_EQ(value_named<Mode>(name), value);
    EXPECT_EQ(name_of(value), name);
  }
  EXPECT_EQ(name_list<Mode>(), "both, PEAK_XOR_DVR, PEAK_ONLY, DVR_ONLY");
  EXPECT_FALSE(value_named<Mode>("dvr_only"));
}

}  // namespace
}  // namespace crest
