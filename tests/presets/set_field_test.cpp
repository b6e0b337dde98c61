#include <gtest/gtest.h>

#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

Preset plain() {
  Preset preset;
  preset.transfer_function = default_transfer_function();
  preset.transfer_function.unknown = R"({"later":1})";
  return preset;
}

std::string error_of(std::string_view assignment) {
  try {
    set_field(plain(), assignment);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(SetField, SetsOneFieldAndNoOther) {
  Preset expected = plain();
  expected.rendering.step = 0.25;
  EXPECT_EQ(set_field(plain(), "rendering.step=0.25"), expected);
  expected = plain();
  expected.transfer_function.points[1].value = 3;
  EXPECT_EQ(set_field(plain(), "transfer_function.points[1].value=3"), expected);
  expected = plain();
  expected.rendering.mode = Mode::peak_only;
  EXPECT_EQ(set_field(plain(), "rendering.mode=PEAK_ONLY"), expected);
  EXPECT_EQ(set_field(plain(), "rendering.mode=\"PEAK_ONLY\""), expected);
  expected = plain();
  expected.transfer_function.points[0].surface.opacity = 0.5;
  EXPECT_EQ(set_field(plain(), "transfer_function.points[0].surface.opacity=0.5"), expected);
  expected = plain();
  expected.name = "a = b, with spaces";
  EXPECT_EQ(set_field(plain(), "name=a = b, with spaces"), expected);
  expected = plain();
  expected.transfer_function.points[1].color.g = 0.125;
  EXPECT_EQ(set_field(plain(), "transfer_function.points[1].color[1]=0.125"), expected);
}

TEST(SetField, TakesNumbersAsPeopleWriteThem) {
  for (const char* text : {".25", "1/4", "0,25", "+0.25"})
    EXPECT_EQ(set_field(plain(), std::string("rendering.step=") + text).rendering.step, 0.25) << text;
  EXPECT_EQ(set_field(plain(), "transfer_function.points[0].surface.opacity=1/4")
                .transfer_function.points[0]
                .surface.opacity,
            0.25);
  EXPECT_EQ(set_field(plain(), "name=1/4").name, "1/4") << "a text stays one";
  EXPECT_EQ(error_of("rendering.step=1/0"), "rendering.step: \"1/0\" divides by zero");
  EXPECT_EQ(error_of("rendering.step=-,5"), "rendering.step: -0.5 is not at least 0.001");
}

TEST(SetField, MakesACameraAndTakesItAway) {
  const Preset parallel = set_field(plain(), "camera.projection=parallel");
  EXPECT_EQ(parallel.camera->projection, Projection::parallel);
  const Preset with = set_field(plain(), "camera.eye=[0,0,5]");
  EXPECT_EQ(with.camera, (Camera{{0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 30, Projection::perspective, ""}));
  EXPECT_EQ(set_field(with, "camera=null"), plain());
}

TEST(SetField, MakesAClipBoxAndTakesItAway) {
  const Preset with = set_field(plain(), R"(rendering.clip_box={"min":[0,0.5,-1],"max":[1,2,3]})");
  EXPECT_EQ(with.rendering.clip_box, (ClipBox{{0, 0.5, -1}, {1, 2, 3}, ""}));
  EXPECT_EQ(set_field(with, "rendering.clip_box.min=[0,1,-1]").rendering.clip_box->min, glm::dvec3(0, 1, -1));
  EXPECT_EQ(set_field(with, "rendering.clip_box.max[2]=9").rendering.clip_box->max, glm::dvec3(1, 2, 9));
  EXPECT_EQ(set_field(with, "rendering.clip_box=null"), plain());
  EXPECT_EQ(error_of("rendering.clip_box.min=[0,0,0]"),
            "rendering.clip_box.min: there is no clip box yet; set it whole, as in "
            R"(rendering.clip_box={"min":[0,0,0],"max":[1,1,1]})");
  EXPECT_EQ(error_of(R"(rendering.clip_box={"min":[2,0,0],"max":[1,1,1]})"),
            "rendering.clip_box: min 2 is not less than max 1 on axis x");
  EXPECT_EQ(error_of(R"(rendering.clip_box={"min":[0,0,0]})"), "rendering.clip_box.max: is missing");
}

TEST(SetField, SetsHowVdlsWorks) {
  const Preset preset = set_field(plain(), "rendering.vdls.layers_per_pass=2");
  EXPECT_EQ(preset.rendering.vdls.layers_per_pass, 2);
  EXPECT_EQ(set_field(preset, "rendering.vdls.leaves=64").rendering.vdls.layers_per_pass, 2);
  EXPECT_EQ(error_of("rendering.vdls.leaves=48"),
            "rendering.vdls.leaves: 48 is neither a power of two nor 0");
  EXPECT_EQ(error_of("rendering.vdls.layers_per_pass=0"),
            "rendering.vdls.layers_per_pass: 0 is not in [1, 64]");
}

TEST(SetField, ReplacesAllPoints) {
  const Preset preset = set_field(plain(), R"(transfer_function.points=[{"value": 5, "opacity": 1}])");
  ASSERT_EQ(preset.transfer_function.points.size(), 1u);
  EXPECT_EQ(preset.transfer_function.points[0].value, 5);
}

TEST(SetField, RefusesWhatIsNotThere) {
  EXPECT_EQ(error_of("rendering.stp=1"),
            "rendering.stp: no field \"stp\"; rendering has: mode, peak_form, engine, vdls, classification, "
            "preintegration_bins, step, placement, sampling, s_k, adaptive, skipping, filter, root_filter, "
            "bc_b, bc_c, max_peaks, peak_bins, shading, gradient, illumination, early_termination, clip_box, "
            "background; did you mean step?");
  EXPECT_EQ(error_of("render.step=1"),
            "render.step: no field \"render\"; a preset has: format, version, name, notes, tags, "
            "transfer_function, "
            "rendering, camera; did you mean rendering?");
  EXPECT_EQ(error_of("transfer_function.points[2].value=1"),
            "transfer_function.points[2].value: transfer_function.points has 2 elements, counted from 0");
  EXPECT_EQ(error_of("rendering[0]=1"), "rendering[0]: rendering is not an array");
  EXPECT_EQ(error_of("name.first=1"), "name.first: name has no fields");
  EXPECT_EQ(error_of("transfer_function.points[x]=1"),
            "transfer_function.points[x]: an index is written like [0]");
  EXPECT_EQ(error_of("transfer_function.points[-1]=1"),
            "transfer_function.points[-1]: an index is written like [0]");
  EXPECT_EQ(error_of("transfer_function.points[0"),
            "transfer_function.points[0: a field is set by PATH=VALUE, as in "
            "rendering.step=0.5");
  for (const char* odd :
       {"rendering.step.=1", ".=1", "..=1", "[0]=1", "rendering..step=1", "transfer_function.points[=1",
        "transfer_function.points[0]]=1", "transfer_function.points[99999999999999999999]=1"})
    EXPECT_NE(error_of(odd), "no error") << odd;
}

TEST(SetField, RefusesWrongValues) {
  EXPECT_EQ(error_of("rendering.step=0"), "rendering.step: 0 is not at least 0.001");
  EXPECT_EQ(error_of("rendering.step=fast"), "rendering.step: \"fast\" is not a number");
  EXPECT_EQ(error_of("rendering.step="), "rendering.step: \"\" is not a number");
  EXPECT_EQ(error_of("transfer_function.points=[]"),
            "transfer_function.points: holds no point: a transfer function needs at least one");
  EXPECT_EQ(error_of("version=2"), "version: 2 is of a newer Crest: this one reads up to 1");
}

// A file could not hold it: it would be another one when it is read again.
TEST(SetField, RefusesTextThatIsNoUtf8) {
  EXPECT_NE(error_of("name=a\xd7").find("name: \"a\\xd7\" is no UTF-8"), std::string::npos)
      << error_of("name=a\xd7");
  EXPECT_EQ(set_field(plain(), "name=\u00e4\u2603").name, "\u00e4\u2603");
}

TEST(AssignmentsBetween, MakeOneRenderingOfAnother) {
  Rendering other;
  other.mode = Mode::peak_only;
  other.step = 0.1;
  other.background = {0, 0.5, 1};
  other.clip_box = ClipBox{{0, 0, 0}, {1, 2, 3}, ""};
  EXPECT_TRUE(assignments_between(other, other).empty());
  for (const auto& [from, to] : {std::pair(Rendering{}, other), {other, Rendering{}}}) {
    Preset preset = plain();
    preset.rendering = from;
    const auto assignments = assignments_between(from, to);
    EXPECT_EQ(assignments.size(), 4u);
    for (const std::string& assignment : assignments) preset = set_field(preset, assignment);
    EXPECT_EQ(preset.rendering, to);
  }
}

}  // namespace
}  // namespace crest
