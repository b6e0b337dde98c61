#include "presets/exchange/exporters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "presets/error.h"
#include "presets/exchange/steps.h"
#include "presets/peaks.h"
#include "presets/preset_file.h"
#include "tests/json.h"
#include "tests/presets/export_inputs.h"
#include "tests/presets/random_tf.h"

namespace crest {
namespace {

TEST(Exporters, AreFoundByName) {
  for (const Exporter& exporter : exporters()) {
    EXPECT_EQ(find_exporter(exporter.name).name, exporter.name);
    EXPECT_EQ(exporter.extension[0], '.');
  }
  try {
    find_exporter("word");
    FAIL();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what())
                    .starts_with("word: no such export format; there are: paraview, paraview-script"));
  }
}

TEST(Exporters, NormalizedPresetsAskForAVolume) {
  const Preset preset = load_preset("onion");
  EXPECT_THROW(ready_for_export(preset, {}), Error);
  ExportVolume volume;
  volume.range = {-100, 300};
  volume.spacing = {2, 1, 3};
  const TransferFunction tf = ready_for_export(preset, volume).transfer_function;
  EXPECT_EQ(tf.domain, Domain::data);
  EXPECT_EQ(tf.unit, LengthUnit::world);
  EXPECT_GE(tf.range().min, -100);
  Preset in_voxels;
  in_voxels.transfer_function = spike();
  EXPECT_NO_THROW(ready_for_export(in_voxels, {}));
  in_voxels.transfer_function.unit = LengthUnit::voxel;
  EXPECT_THROW(ready_for_export(in_voxels, {}), Error);
  EXPECT_THROW(ready_for_export(Preset{}, {}), Error) << "no points";
}

// What any TF makes of any exporter: a file that is not empty, no word about it that is not finite.
TEST(Exporters, TakeEveryTransferFunction) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 30; ++trial) {
    ExportInput input = input_of(random_tf(random, 100));
    if (trial % 3 == 0) input.preset.transfer_function.points.resize(1);
    input.preset.rendering.mode = Mode(trial % 4);
    if (trial % 2)
      input.volume = ExportVolume{.file = "/data/volume.nrrd", .name = "volume", .range = {-1, 1}, .raw = {}};
    for (const Exporter& exporter : exporters()) {
      const Exported result = exporter.write(input);
      ASSERT_FALSE(result.files.empty());
      for (const ExportFile& file : result.files) EXPECT_FALSE(file.content.empty());
      for (const std::string& sentence : result.losses)
        EXPECT_EQ(sentence.find("nan"), sentence.npos) << sentence;
      const Preset drawn = exporter.as_drawn(input);
      EXPECT_GT(drawn.transfer_function.points.size(), 0u) << exporter.name;
      EXPECT_EQ(why_inconsistent(drawn.rendering), "") << exporter.name;
      for (std::size_t i = 1; i < drawn.transfer_function.points.size(); ++i)
        ASSERT_LE(drawn.transfer_function.points[i - 1].value, drawn.transfer_function.points[i].value)
            << exporter.name;
    }
  }
}

TEST(Exporters, SayWhatTheirTargetCannotHold) {
  ExportInput input = input_of(spike());
  input.preset.rendering.filter = Filter::bspline;
  const auto losses = [&](const char* format) { return exported(format, input).losses; };
  for (const char* format :
       {"paraview", "slicer", "slicer-vp", "vtkjs", "inviwo", "csv", "npy", "png", "1dt", "f3d"}) {
    EXPECT_TRUE(any_says(losses(format), "peak is not drawn as a surface")) << format;
    EXPECT_TRUE(any_says(losses(format), "cubic filter")) << format;
  }
  for (const char* format : {"paraview", "slicer-vp", "vtkjs", "npy", "png", "1dt"})
    EXPECT_TRUE(any_says(losses(format), "unit distance is not in the file")) << format;
  for (const char* format : {"paraview", "slicer", "vtkjs", "inviwo"})
    EXPECT_TRUE(any_says(losses(format), "points are moved by up to")) << format;
  for (const char* format : {"slicer", "vtk-python", "paraview-script", "glsl"})
    EXPECT_FALSE(any_says(losses(format), "unit distance is not")) << format;
  EXPECT_TRUE(any_says(losses("vtk-python"), "isosurfaces of triangles"));
  input.preset.rendering.mode = Mode::dvr_only;
  EXPECT_FALSE(any_says(losses("slicer"), "peak")) << "none is drawn here either";
}

TEST(ParaView, HoldsColoursAndOpacitiesWithNamesOfTheirOwn) {
  std::mt19937 random(2);
  std::set<std::string> names;
  for (int trial = 0; trial < 100; ++trial) {
    const TransferFunction tf = random_tf(random, 200);
    const auto root = test::parse_json(text_of("paraview", input_of(tf)));
    ASSERT_TRUE(root.is_array() && root.size() == 1);
    const auto& map = root[0];
    names.insert(map["Name"].get<std::string>());
    EXPECT_EQ(map["ColorSpace"], "RGB");
    const std::vector<double> colors = map["RGBPoints"], opacities = map["Points"];
    ASSERT_EQ(colors.size(), 4 * tf.points.size());
    ASSERT_EQ(opacities.size(), 4 * tf.points.size());
    for (std::size_t i = 0; i < tf.points.size(); ++i) {
      EXPECT_EQ(colors[4 * i], opacities[4 * i]);
      EXPECT_EQ(glm::dvec3(colors[4 * i + 1], colors[4 * i + 2], colors[4 * i + 3]), tf.points[i].color);
      EXPECT_EQ(opacities[4 * i + 1], tf.points[i].opacity);
      if (i > 0) {
        EXPECT_GT(opacities[4 * i], opacities[4 * i - 4]);
      }
    }
  }
  EXPECT_EQ(names.size(), 100u) << "ParaView drops the name of a preset whose name it knows";
}

// Values in 32-bit float after a rescale to another range, as ParaView applies a preset.
TEST(ParaView, StepsSurviveARescaleAndFloat) {
  TransferFunction tf;
  for (const auto& [value, opacity] : {std::pair(0.0, 0.5), {0.0, 0.0}, {255.0, 0.0}, {255.0, 0.9}})
    tf.points.push_back(point(value, opacity));
  const auto values = separated_values(tf, drawn_apart);
  EXPECT_EQ(values[1], 0) << "a step holds at its value";
  EXPECT_EQ(values[3], 255);
  for (const ValueRange range : {ValueRange{0, 1}, {-1000, 3000}, {1000, 1500}})
    for (std::size_t i = 1; i < values.size(); ++i) {
      const auto rescaled = [&](double value) {
        return float(
            std::lerp(range.min, range.max, (value - values.front()) / (values.back() - values.front())));
      };
      EXPECT_LT(rescaled(values[i - 1]), rescaled(values[i])) << range.min << ' ' << i;
    }
}

TEST(Slicer, WritesWhatItsReaderLeavesAlone) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const TransferFunction tf = random_tf(random, 300);
    const auto root = test::parse_json(text_of("slicer", input_of(tf)));
    const auto& component = root["volumeProperties"][0]["components"][0];
    EXPECT_EQ(component["scalarOpacityUnitDistance"], tf.unit_distance);
    EXPECT_EQ(component["scalarOpacity"]["type"], "piecewiseLinearFunction");
    EXPECT_EQ(component["rgbTransferFunction"]["type"], "colorTransferFunction");
    for (const char* number : {"diffuse", "ambient", "specular", "specularPower"})
      EXPECT_TRUE(component["lighting"][number].is_number()) << "the schema wants all four";
    for (const char* function : {"scalarOpacity", "gradientOpacity", "rgbTransferFunction"})
      for (const auto& p : component[function]["points"]) {
        EXPECT_EQ(p["midpoint"], 0.5) << "the schema wants both";
        EXPECT_EQ(p["sharpness"], 0);
      }
    EXPECT_EQ(root["volumeProperties"][0]["isoSurfaceValues"].size(), shown_peaks(find_peaks(tf)).size());
    const auto& points = component["scalarOpacity"]["points"];
    ASSERT_EQ(points.size(), tf.points.size());
    // Slicer 5.12 moves a point up that is not 10 units in the last place of float above the one before
    float before = -INFINITY;
    for (const auto& p : points) {
      float least = before;
      for (int unit = 0; unit < 10; ++unit) least = std::nextafter(least, INFINITY);
      EXPECT_GE(float(p["x"].get<double>()), before == -INFINITY ? before : least);
      before = float(p["x"].get<double>());
    }
  }
}

TEST(SlicerVp, WritesOpacitiesForOneWorldUnit) {
  std::istringstream lines(text_of("slicer-vp", input_of(spike())));
  std::string line;
  for (int i = 0; i < 7; ++i) std::getline(lines, line);
  std::istringstream numbers(line);
  double count = 0, x = 0, opacity = 0;
  numbers >> count >> x >> opacity >> x >> opacity >> x >> opacity;
  EXPECT_EQ(count, 10);
  EXPECT_EQ(x, 0.5);
  EXPECT_NEAR(opacity, 1 - std::pow(0.1, 0.25), 1e-12);
}

TEST(Inviwo, WritesOpacitiesForOne150thOfTheSide) {
  ExportInput input = input_of(spike());
  input.volume = ExportVolume{
      .file = {}, .name = "v", .range = {0, 1}, .dims = {300, 300, 300}, .spacing = glm::dvec3(2), .raw = {}};
  const std::string text = text_of("inviwo", input);  // 600 / 150 = 4 world units: what the opacities are for
  EXPECT_NE(text.find("<pos content=\"0.5\" />\n            <rgba x=\"1\" y=\"0\" z=\"0\" w=\"0.9\" />"),
            text.npos)
      << text;
  EXPECT_NE(text.find("<InviwoWorkspace version=\"3\">"), text.npos);
}

// As the target draws it: with contours where it has them, and the table that is written.
TEST(Exporters, AreDrawnAsTheTargetDraws) {
  ExportInput input = input_of(spike());
  input.volume = ExportVolume{.file = {}, .name = "v", .range = {-10, 10}, .raw = {}};
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only}) {
    input.preset.rendering.mode = mode;
    for (const char* format : {"paraview-script", "vtk-python"}) {
      const Preset drawn = find_exporter(format).as_drawn(input);
      const auto surfaces = shown_peaks(find_peaks(drawn.transfer_function));
      ASSERT_EQ(surfaces.size(), 1u) << format;
      EXPECT_EQ(surfaces[0].value, 0.5);
      EXPECT_EQ(surfaces[0].opacity, 0.9);
      EXPECT_EQ(surfaces[0].color, glm::dvec3(1, 0, 0));
      EXPECT_EQ(drawn.rendering.mode, mode == Mode::peak_only ? Mode::peak_only : Mode::both);
    }
  }
  input.rows = 11;
  EXPECT_EQ(find_exporter("csv").as_drawn(input).transfer_function.range(), (ValueRange{0, 1}));
  EXPECT_EQ(find_exporter("1dt").as_drawn(input).transfer_function.range(), (ValueRange{-10, 10}));
}

TEST(ParaViewScript, HasWhatTheModeShows) {
  ExportInput input = input_of(spike());
  input.volume = ExportVolume{.file = "/data/v_4x5x6_uint16.raw",
                              .name = "v",
                              .range = {0, 1},
                              .dims = {4, 5, 6},
                              .raw = ExportVolume::Raw{"uint16", true, 0}};
  const auto text = [&](Mode mode) {
    input.preset.rendering.mode = mode;
    return text_of("paraview-script", input);
  };
  const std::string both = text(Mode::both);
  EXPECT_NE(both.find("ScalarOpacityUnitDistance"), both.npos);
  EXPECT_NE(both.find("Contour("), both.npos);
  EXPECT_NE(both.find("(0.5, 1, 0, 0, 0.9)"), both.npos);
  EXPECT_NE(both.find("DataScalarType=\"unsigned short\", DataByteOrder=\"BigEndian\""), both.npos);
  EXPECT_NE(both.find("DataExtent=[0, 3, 0, 4, 0, 5]"), both.npos);
  EXPECT_EQ(text(Mode::dvr_only).find("Contour("), std::string::npos);
  EXPECT_EQ(text(Mode::peak_only).find("ScalarOpacityUnitDistance"), std::string::npos);
  const std::string base = text(Mode::peak_xor_dvr);
  EXPECT_EQ(base.find("0.9),", base.find("POINTS = ")) < base.find("PEAKS = "), false)
      << "the spike is the peak's alone";
}

// Half the height of the view at the target, which is what VTK calls the parallel scale.
TEST(ParaViewScript, KeepsTheProjection) {
  ExportInput input = input_of(spike());
  Camera& camera = input.preset.camera.emplace();
  camera.eye = {0, 0, 10};
  camera.target = {0, 0, 0};
  camera.fov_y_degrees = 90;
  EXPECT_EQ(text_of("paraview-script", input).find("Parallel"), std::string::npos);
  camera.projection = Projection::parallel;
  const std::string text = text_of("paraview-script", input);
  EXPECT_NE(text.find("view.CameraParallelProjection = 1\n"), text.npos);
  const std::size_t at = text.find("view.CameraParallelScale = ");
  ASSERT_NE(at, text.npos);
  EXPECT_NEAR(std::stod(text.substr(at + 27)), 10, 1e-12);
}

// A name may hold anything.
TEST(ParaViewScript, NamesDoNotBreakIt) {
  ExportInput input = input_of(spike());
  input.name = "a\"\nimport os\n{}";
  input.volume = ExportVolume{.file = "/data/\"quoted\"\\\n.nrrd", .name = "v", .range = {}, .raw = {}};
  const std::string text = text_of("paraview-script", input);
  EXPECT_EQ(text.find("\nimport os"), text.npos);
  EXPECT_NE(text.find("\"/data/\\\"quoted\\\"\\\\\\x0a.nrrd\""), text.npos) << text;
}

}  // namespace
}  // namespace crest
