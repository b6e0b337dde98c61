#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "presets/json.h"
#include "program.h"
#include "render/files/image.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
const Words modes = {"both", "DVR_ONLY", "PEAK_ONLY", "PEAK_XOR_DVR"};

/// One material everywhere, and one sphere of radius 0.5 that absorbs a half at each crossing.
const std::string flat = R"(transfer_function.points=[{"value": 0, "opacity": 0.5}])";
const std::string spike =
    R"(transfer_function.points=[{"value": -2, "opacity": 0}, {"value": 0.5, "opacity": 0},
    {"value": 0.5, "opacity": 0.5}, {"value": 0.5, "opacity": 0}, {"value": 2, "opacity": 0}])";
const Words data_values = {"--set", "transfer_function.domain=data",
                           "--set", "transfer_function.unit=world",
                           "--set", "transfer_function.unit_distance=1"};

class Picture : public ProgramTest {
 protected:
  Words render(const std::string& output, const Words& options = {}) const {
    return Words{"render", "builtin:sphere?n=17", "--size", "24x16", "-o", path(output)} + options;
  }
  Image image_of(const Words& options) const {
    output_of(render("image.exr", options));
    return read_image(path("image.exr"));
  }
  /// Rays along z that are parallel in effect, and all through the middle of the cube [-1, 1]^3.
  Words along_z = {"--eye", "0,0,-1000", "--target", "0,0,0", "--up", "0,1,0", "--fov", "0.02"};
};

TEST_F(Picture, PngAndExrHoldTheSame) {
  const Words preset = {"--preset", "onion", "--set", "rendering.background=[0.25,0.5,1]"};
  output_of(render("a.png", preset));
  const Image png = read_image(path("a.png")), exr = image_of(preset);
  ASSERT_EQ(png.size, glm::ivec2(24, 16));
  ASSERT_EQ(exr.size, glm::ivec2(24, 16));
  const Image expected = over_background(exr, {0.25F, 0.5F, 1});
  int partly = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel)
      ASSERT_NEAR(png.pixels[i][channel], expected.pixels[i][channel], 0.51 / 255);
    partly += exr.pixels[i].a > 0.01F && exr.pixels[i].a < 0.99F;
  }
  EXPECT_GT(partly, 100);
}

TEST_F(Picture, ASlabByHand) {
  // Two units of a material of which one absorbs a half.
  const Image image = image_of(data_values + along_z + Words{"--set", flat, "--mode", "DVR_ONLY"});
  for (const glm::vec4& pixel : image.pixels)
    for (int channel = 0; channel < 4; ++channel) ASSERT_NEAR(pixel[channel], 0.75, 1e-5);
}

// The exact answer of each, too. Each step holds more of the material than the one before.
TEST_F(Picture, OfEachStepHasTheStepsNumber) {
  for (int i = 0; i < 3; ++i) {
    std::string voxels(64, char(50 * (i + 1)));
    for (std::size_t at = 0; at < voxels.size(); at += 2) ++voxels[at];
    std::ofstream(path("film_" + std::to_string(i) + ".raw")) << voxels;
  }
  const std::string film = path("film_*.raw") + "?size=4x4x4&type=uint8";
  const std::string ramp =
      R"(transfer_function.points=[{"value": 0, "opacity": 0}, {"value": 200, "opacity": 1}])";
  const Words settings = data_values + Words{"--size", "6x4", "--mode", "DVR_ONLY", "--set", ramp};
  for (const std::string engine : {"raycaster", "reference"}) {
    float before = 0;
    const std::string name = path(engine + ".exr");
    output_of(Words{"render", film, "--frame", "all", "--engine", engine, "-o", name} + settings);
    for (int i = 0; i < 3; ++i) {
      const Image one = read_image(path(engine + "-00" + std::to_string(i) + ".exr"));
      const std::string alone = path("alone.exr");
      output_of(Words{"render", film, "--frame", std::to_string(i), "--engine", engine, "-o", alone} +
                settings);
      const Image same = read_image(alone);
      for (std::size_t at = 0; at < one.pixels.size(); ++at)
        ASSERT_NEAR(one.pixels[at].a, same.pixels[at].a, 1e-4) << "names and --frame agree";
      EXPECT_GT(one.at(3, 2).a, before);
      before = one.at(3, 2).a;
    }
    EXPECT_FALSE(std::filesystem::exists(path(engine + "-003.exr")));
  }
}

// All rays of a parallel picture are as long, from wherever it is seen, and the height is that at the target.
TEST_F(Picture, ASlabInParallelProjection) {
  const Words beside = {"--eye", "0,0,-3", "--target", "0,0,0",
                        "--up",  "0,1,0",  "--fov",    "36.86989764584402"};
  const Words slab = data_values + beside + Words{"--set", flat, "--mode", "DVR_ONLY"};
  const Image image = image_of(slab + Words{"--projection", "parallel"});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)  // a pixel is an eighth; the cube goes from -1 to 1
      ASSERT_NEAR(image.at(x, y).a, x >= 4 && x < 20 ? 0.75 : 0, 1e-5) << x << ", " << y;
  const Image cut = image_of(slab + Words{"--projection", "perspective"});
  EXPECT_GT(cut.at(8, 8).a, 0.751) << "aslant the way is longer";
  const Image whole = image_of(Words{"--projection", "parallel", "--preset", "onion"});
  EXPECT_EQ(whole.at(0, 8).a, 0) << "the whole volume is in view";
  EXPECT_GT(whole.at(12, 8).a, 0);
}

TEST_F(Picture, SamplesOfASlabByHand) {
  // 2 units of way in steps of 0.3 * 0.125: 53.3, so 54 segments, whose midpoints DVR evaluates.
  const Words slab = data_values + along_z + Words{"--step", "0.3", "--json"};
  const auto dvr = json_of(render("a.png", slab + Words{"--set", flat, "--mode", "DVR_ONLY"}));
  EXPECT_EQ(dvr["samples_per_ray"], 54);
  EXPECT_EQ(dvr["dvr_samples_per_ray"], 54);
  EXPECT_EQ(dvr["samples_per_hit_ray"], 54);
  EXPECT_EQ(dvr["crossings_per_ray"], 0);
  EXPECT_EQ(dvr["hit_rays"], 24 * 16);
  // The rays pass the sphere of radius 0.5 twice. Roots are sought between entry, midpoints and exit.
  const auto peaks = json_of(render("a.png", slab + Words{"--set", spike, "--mode", "PEAK_ONLY"}));
  EXPECT_EQ(peaks["crossings_per_ray"], 2);
  EXPECT_EQ(peaks["dvr_samples_per_ray"], 0);
  EXPECT_GE(peaks["samples_per_ray"], 56);
  EXPECT_LE(peaks["samples_per_ray"], 56 + 2 * 3);
  const Image image = image_of(data_values + along_z + Words{"--set", spike, "--mode", "PEAK_ONLY"});
  for (const glm::vec4& pixel : image.pixels) ASSERT_NEAR(pixel.a, 0.75, 1e-6);
}

// Whatever the preset's step: the exact march, and how far each pixel may be off.
TEST_F(Picture, Exact) {
  const Words spiky = {
      "--preset", "dirac-shell", "--mode",  "DVR_ONLY",      "--set",          "rendering.shading=none",
      "--step",   "4",           "--exact", "--error-bound", path("bound.exr")};
  const auto json = json_of(render("exact.exr", spiky + Words{"--json"}));
  output_of(render("cpu.exr", {"--preset", "dirac-shell", "--mode", "DVR_ONLY", "--engine", "reference"}));
  const Image exact = read_image(path("exact.exr")), cpu = read_image(path("cpu.exr")),
              bound = read_image(path("bound.exr"));
  ASSERT_EQ(bound.size, exact.size);
  double greatest = 0;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    greatest = std::max(greatest, double(bound.pixels[i].r));
    for (int channel = 0; channel < 4; ++channel)
      ASSERT_NEAR(exact.pixels[i][channel], cpu.pixels[i][channel], bound.pixels[i].r);
  }
  EXPECT_GT(greatest, 0);
  EXPECT_EQ(json["error_at_most"]["greatest"].get<double>(), greatest);
  EXPECT_GT(json["error_at_most"]["share_within_1_255"].get<double>(), 0.95);
  expect_error(2, render("a.png", {"--exact", "--set", "rendering.filter=bspline"}), {"--exact", "bspline"});
  expect_error(2, render("a.png", {"--exact", "--engine", "reference"}), {"--exact", "reference"});
  expect_error(2, render("a.png", {"--error-bound", path("b.png")}), {"--error-bound", "--exact"});
}

TEST_F(Picture, StatisticsHaveTheDocumentedKeys) {
  const auto json = json_of(
      render("a.png", {"--preset", "four-peaks", "--frames", "3", "--json", "--mode", "PEAK_XOR_DVR"}));
  EXPECT_EQ(json["mode"], "PEAK_XOR_DVR");
  ASSERT_EQ(json["frame_ms_all"].size(), 2u);  // and the first, which is told apart
  const double a = json["frame_ms_all"][0], b = json["frame_ms_all"][1];
  EXPECT_GT(std::min(a, b), 0);
  EXPECT_LT(std::max(a, b), 10000);
  EXPECT_DOUBLE_EQ(json["frame_ms"], (a + b) / 2);
  EXPECT_GT(json["first_frame_ms"], 0);
  for (const char* key :
       {"samples_per_ray", "dvr_samples_per_ray", "samples_per_hit_ray", "dvr_samples_per_hit_ray"}) {
    EXPECT_GT(json[key], 1) << key;
    EXPECT_LT(json[key], 1000) << key;
  }
  EXPECT_LT(json["samples_per_ray"], json["samples_per_hit_ray"]);
  EXPECT_LE(json["dvr_samples_per_ray"], json["samples_per_ray"]);
  ASSERT_EQ(json["peaks"].size(), 4u);
  EXPECT_TRUE(json["peaks"][0].contains("value") && json["peaks"][0].contains("opacity"));
  std::set<std::string> features = json["features"];
  EXPECT_TRUE(features.contains("dvr") && features.contains("peaks"));
  for (const auto& [feature, why] : json["left_out"].items()) {
    EXPECT_FALSE(features.contains(feature)) << feature;
    EXPECT_GT(why.get<std::string>().size(), 5u) << feature;
  }
  EXPECT_NE(json["renderer"].get<std::string>().find("OpenGL"), std::string::npos);
  const auto& tables = json["tables"];
  EXPECT_EQ(tables["surfaces"]["bytes"], 4 * 32);
  EXPECT_EQ(tables["transfer_function"]["size"],
            std::to_string(tables["transfer_function"]["bytes"].get<int>() / 16) + " entries");
  EXPECT_LE(tables["transfer_function"]["error"], 1e-4);
  EXPECT_FALSE(tables.contains("peak_table"));
}

TEST_F(Picture, EachModeShowsItsOwn) {
  std::map<std::string, Image> images;
  for (const std::string& mode : modes) {
    const auto json = json_of(render(mode + ".exr", {"--preset", "four-peaks", "--mode", mode, "--json"}));
    EXPECT_EQ(json["mode"], mode);
    EXPECT_EQ(json["dvr_samples_per_ray"] == 0, mode == "PEAK_ONLY");
    EXPECT_EQ(json["crossings_per_ray"] == 0, mode == "DVR_ONLY");
    images[mode] = read_image(path(mode + ".exr"));
  }
  for (const std::string& a : modes)
    for (const std::string& b : modes)
      if (a < b) {
        EXPECT_FALSE(images[a].pixels == images[b].pixels) << a << ' ' << b;
      }
}

TEST_F(Picture, AFieldSetIsTheOptionThatSetsIt) {
  output_of(render("a.exr", {"--preset", "onion", "--mode", "PEAK_ONLY", "--step", "0.25"}));
  output_of(render(
      "b.exr", {"--preset", "onion", "--set", "rendering.mode=PEAK_ONLY", "--set", "rendering.step=0.25"}));
  EXPECT_TRUE(read_image(path("a.exr")).pixels == read_image(path("b.exr")).pixels);
}

TEST_F(Picture, FitRangeSpansTheVolume) {
  // A ramp over values that the volume has none of, and the same over its range.
  const std::string ramp = R"(transfer_function.points=[{"value": 1000, "opacity": 0},
      {"value": 2000, "opacity": 0.9}])";
  const Words scene = {"--set", "transfer_function.domain=data", "--set", ramp};
  const Outcome beside = run(render("beside.exr", scene));
  EXPECT_EQ(beside.exit_code, 0);
  EXPECT_NE(beside.err.find("--fit-range"), std::string::npos) << beside.err;
  for (const glm::vec4& pixel : read_image(path("beside.exr")).pixels) ASSERT_EQ(pixel.a, 0);
  const Image fitted = image_of(scene + Words{"--fit-range"});
  const std::string normalized = R"(transfer_function.points=[{"value": 0, "opacity": 0},
      {"value": 1, "opacity": 0.9}])";
  const Image expected = image_of({"--set", "transfer_function.domain=normalized", "--set", normalized});
  float most = 0;
  for (std::size_t i = 0; i < fitted.pixels.size(); ++i) {
    ASSERT_NEAR(fitted.pixels[i].a, expected.pixels[i].a, 1e-5);
    most = std::max(most, fitted.pixels[i].a);
  }
  EXPECT_GT(most, 0.5F);
}

TEST_F(Picture, TheCameraOfTheCommandLineWins) {
  const Words far = {"--eye", "0,0,-40", "--target", "0,0,0", "--up", "0,1,0"};
  const auto covered = [](const Image& image) {
    return std::ranges::count_if(image.pixels, [](const glm::vec4& pixel) { return pixel.a > 0; });
  };
  const Words preset_camera = {
      "--preset", "onion", "--set", "camera.eye=[0,0,-4]", "--set", "camera.target=[0,0,0]"};
  EXPECT_GT(covered(image_of(preset_camera)), 100);
  EXPECT_LT(covered(image_of(preset_camera + far)), 20);
}

TEST_F(Picture, CompareShowsTheFourModesInAGrid) {
  const Words scene = {"builtin:sphere?n=17", "--preset", "onion", "--size", "40x30"};
  const auto json = json_of(Words{"compare"} + scene + Words{"-o", path("c.exr"), "--json"});
  const Image grid = read_image(path("c.exr"));
  ASSERT_EQ(grid.size, glm::ivec2(2 * 40 + 2, 2 * 30 + 2));
  std::set<std::string> names;
  for (const auto& mode : json["modes"]) names.insert(mode["mode"].get<std::string>());
  EXPECT_EQ(names, std::set<std::string>(modes.begin(), modes.end()));
  EXPECT_TRUE(json.contains("renderer"));
  // Below the labels, each quarter is the picture that `render` makes.
  for (std::size_t i = 0; i < 4; ++i) {
    output_of(Words{"render"} + scene + Words{"--mode", json["modes"][i]["mode"], "-o", path("one.exr")});
    const Image one = over_background(read_image(path("one.exr")), glm::vec3(0));
    for (int y = 20; y < 30; ++y)
      for (int x = 0; x < 40; ++x)
        ASSERT_EQ(grid.at(x + int(i % 2) * 42, y + int(i / 2) * 32), one.at(x, y))
            << i << ' ' << x << ' ' << y;
  }
}

}  // namespace
}  // namespace crest::test
