#include "presets/exchange/exporters.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "presets/error.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/table.h"
#include "presets/peaks.h"
#include "presets/preset_file.h"
#include "tests/json.h"
#include "tests/presets/random_tf.h"

namespace crest {
namespace {

ControlPoint point(double value, double opacity) {
  return {.value = value, .color = glm::dvec3(1), .opacity = opacity, .surface = {}, .unknown = {}};
}

TransferFunction spike() {
  TransferFunction tf;
  tf.unit_distance = 4;
  for (const double value : {0.0, 0.5, 0.5, 0.5, 1.0}) tf.points.push_back(point(value, 0));
  tf.points[2].opacity = 0.9;
  tf.points[2].color = {1, 0, 0};
  return tf;
}

ExportInput input_of(TransferFunction tf) {
  ExportInput input;
  input.name = "Name";
  input.stem = "file";
  input.preset.transfer_function = std::move(tf);
  return input;
}

Exported exported(std::string_view format, const ExportInput& input) {
  return find_exporter(format).write(input);
}
std::string text_of(std::string_view format, const ExportInput& input) {
  return exported(format, input).files.at(0).content;
}

bool any_says(const std::vector<std::string>& sentences, std::string_view words) {
  return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(words) != s.npos; });
}

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

TEST(Steps, AreMovedNoFurtherThanTheirGaps) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const TransferFunction tf = random_tf(random, 300);
    const double size = std::max(std::abs(tf.range().min), std::abs(tf.range().max));
    for (const Separation& separation : {drawn_apart, slicer_apart}) {
      const auto values = separated_values(tf, separation);
      const double gap =
          separation.units * 0x1p-23 * std::max(size, separation.least_size * tf.range().width());
      for (std::size_t i = 1; i < values.size(); ++i) ASSERT_LT(values[i - 1], values[i]);
      // In the worst case all points are in one group
      std::size_t largest_group = 1, group = 1;
      for (std::size_t i = 1; i < values.size(); ++i) {
        group = tf.points[i].value - tf.points[i - 1].value < 2 * gap ? group + 1 : 1;
        largest_group = std::max(largest_group, group);
      }
      EXPECT_LE(farthest_move(tf, values), 1.01 * gap * double(largest_group));
    }
  }
}

// A spike keeps the value of its tip, and points that are apart stay.
TEST(Steps, LeaveWhatIsApart) {
  TransferFunction tf = spike();
  auto values = separated_values(tf, drawn_apart);
  EXPECT_EQ(values[0], 0);
  EXPECT_LT(values[1], 0.5);
  EXPECT_EQ(values[2], 0.5);
  EXPECT_GT(values[3], 0.5);
  EXPECT_EQ(values[4], 1);
  tf.points[1].value = 0.5 - 1e-7;
  tf.points[3].value = 0.5 + 1e-7;
  values = separated_values(tf, drawn_apart);
  EXPECT_EQ(values[1], 0.5 - 1e-7) << "no step";
  values = separated_values(tf, slicer_apart);
  EXPECT_EQ(values[2], 0.5);
  EXPECT_LT(values[1], 0.5 - 5e-7);
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

TEST(Table, KeepsEachPeakInItsHeight) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 100; ++trial) {
    TransferFunction tf;
    const int peaks = 1 + int(random() % 5);
    std::uniform_real_distribution<double> unit(0, 1);
    tf.points.push_back(point(0, 0));
    for (int i = 0; i < peaks; ++i) {
      const double value = (i + 0.2 + 0.6 * unit(random)) / peaks, opacity = 0.2 + 0.8 * unit(random);
      for (const double o : {0.0, opacity, 0.0})
        tf.points.push_back(point(value + (tf.points.size() % 3 == 1   ? -1e-6
                                           : tf.points.size() % 3 == 0 ? 1e-6
                                                                       : 0),
                                  o));
    }
    tf.points.push_back(point(1, 0));
    std::ranges::stable_sort(tf.points, {}, &ControlPoint::value);
    for (const int count : {64, 256, 1001}) {
      const TfTable1d table = make_table(tf, {0, 1}, count);
      ASSERT_EQ(int(table.rows.size()), count);
      EXPECT_EQ(table.lost, 0);
      for (const ControlPoint& p : tf.points) {
        if (p.opacity == 0) continue;
        const auto row = std::size_t(std::lround(p.value * (count - 1)));
        EXPECT_EQ(table.rows[row].a, p.opacity) << "one entry, in full height";
        EXPECT_EQ(table.rows[row - 1].a, 0);
        EXPECT_EQ(table.rows[row + 1].a, 0);
      }
    }
  }
}

TEST(Table, SaysWhatIsLostInOneRow) {
  TransferFunction tf;
  for (const auto& [value, opacity] :
       {std::pair(0.0, 0.0), {0.5, 0.4}, {0.501, 0.0}, {0.502, 0.9}, {0.51, 0.0}, {1.0, 0.0}})
    tf.points.push_back(point(value, opacity));
  const TfTable1d table = make_table(tf, {0, 1}, 101);
  EXPECT_EQ(table.lost, 1);
  EXPECT_EQ(table.rows[50].a, 0.9) << "the higher one";
  ExportInput input = input_of(tf);
  input.rows = 101;
  EXPECT_TRUE(any_says(exported("1dt", input).losses, "1 peak is lost in the row of a higher one"));
}

TEST(Table, AutomaticRowsAreTheFewestThatHoldAllPoints) {
  TransferFunction tf;
  for (const auto& [value, opacity] : {std::pair(0.0, 0.0), {0.25, 0.8}, {0.75, 0.1}, {1.0, 0.3}})
    tf.points.push_back(point(value, opacity));
  EXPECT_EQ(fewest_rows(tf, {0, 1}), 5) << "its points lie on fourths";
  tf.points[1].value = 0.26;
  const int rows = fewest_rows(tf, {0, 1});
  EXPECT_LE(make_table(tf, {0, 1}, rows).largest_error, 1.0 / 255);
  EXPECT_GT(make_table(tf, {0, 1}, rows - 1).largest_error, 1.0 / 255);
  // What no table can hold - a step, a spike - is held by the row beside it
  EXPECT_LT(fewest_rows(spike(), {0, 1}), 100);
}

TEST(Csv, HoldsTheFunctionAtItsRows) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const TransferFunction tf = random_tf(random, 30);
    const double width = tf.range().width() > 0 ? tf.range().width() : 1;
    ExportInput input = input_of(tf);
    input.rows = 2 + int(random() % 50);
    std::istringstream lines(text_of("csv", input));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "value,red,green,blue,opacity,extinction");
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
      for (char& c : line)
        if (c == ',') c = ' ';
      std::istringstream text(line);
      double numbers[6];
      for (double& number : numbers) text >> number;
      const double value = tf.range().min + width * rows / (input.rows - 1);
      EXPECT_NEAR(numbers[0], value, 1e-14 * (std::abs(value) + width));
      EXPECT_NEAR(numbers[5], extinction(numbers[4], tf.unit_distance), 1e-12 * std::abs(numbers[5]));
      const bool has_peak = std::ranges::any_of(tf.points, [&](const ControlPoint& p) {
        return p.opacity == numbers[4] && std::abs(p.value - value) <= width / (input.rows - 1);
      });
      if (!has_peak) {
        EXPECT_NEAR(numbers[4], evaluate(tf, numbers[0]).opacity, 1e-9);
      }
    }
    EXPECT_EQ(rows, input.rows);
  }
}

TEST(Npy, HasAHeaderThatNumPyReads) {
  ExportInput input = input_of(spike());
  input.rows = 101;
  const std::string bytes = text_of("npy", input);
  ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      std::size_t(static_cast<unsigned char>(bytes[8])) + 256 * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  EXPECT_EQ(bytes[10 + length - 1], '\n');
  EXPECT_EQ(bytes.substr(10, 52), "{'descr': '<f8', 'fortran_order': False, 'shape': (1");
  EXPECT_EQ(bytes.size(), 10 + length + 101 * 5 * sizeof(double));
  double middle[5];
  std::memcpy(middle, bytes.data() + 10 + length + 50 * sizeof middle, sizeof middle);
  EXPECT_EQ(middle[0], 0.5);
  EXPECT_EQ(middle[1], 1);
  EXPECT_EQ(middle[4], 0.9);
}

TEST(Png, IsARowOfSixteenBits) {
  ExportInput input = input_of(spike());
  input.rows = 101;
  const std::string file = text_of("png", input);
  ASSERT_EQ(file.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(file[at + i]);
    return value;
  };
  EXPECT_EQ(number(16), 101u);
  EXPECT_EQ(number(20), 1u);
  std::string pixels(1 + 101 * 8, '\0');
  for (std::size_t at = 8; at < file.size(); at += 12 + number(at)) {
    const std::uint32_t size = number(at);
    EXPECT_EQ(number(at + 8 + size), crc32(0, reinterpret_cast<const Bytef*>(&file[at + 4]), size + 4));
    if (file.substr(at + 4, 4) != "IDAT") continue;
    uLongf length = uLongf(pixels.size());
    ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(pixels.data()), &length,
                         reinterpret_cast<const Bytef*>(&file[at + 8]), size),
              Z_OK);
    EXPECT_EQ(length, pixels.size());
  }
  const std::size_t middle = 1 + 50 * 8;
  const auto channel = [&](std::size_t c) {
    return 256 * static_cast<unsigned char>(pixels[middle + 2 * c]) +
           static_cast<unsigned char>(pixels[middle + 2 * c + 1]);
  };
  EXPECT_EQ(channel(0), 65535);
  EXPECT_EQ(channel(1), 0);
  EXPECT_EQ(channel(3), std::lround(0.9 * 65535));
}

TEST(F3d, WritesTwoStripsAndTheCommandLine) {
  ExportInput input = input_of(spike());
  input.volume = ExportVolume{.file = "/data/a b.nrrd", .name = "v", .range = {-1, 1}, .raw = {}};
  const Exported result = exported("f3d", input);
  ASSERT_EQ(result.files.size(), 3u);
  EXPECT_NE(result.files[0].content.find("--coloring-range=-1,1"), std::string::npos);
  EXPECT_NE(result.files[0].content.find("\"$here\"/'file-opacity.png'"), std::string::npos);
  EXPECT_EQ(result.files[1].suffix, "-colors.png");
  EXPECT_TRUE(any_says(result.losses, "1 world unit in place of 4"));
}

// Names and paths hold what they like; none of it is run.
TEST(F3d, NamesAndPathsAreNoCode) {
  ExportInput input = input_of(spike());
  input.name = "x\ntouch /tmp/owned #";
  input.stem = "$(touch stem)'";
  input.volume = ExportVolume{.file = "/data/`touch path`}\"", .name = "v", .range = {0, 1}, .raw = {}};
  const std::string text = text_of("f3d", input);
  EXPECT_EQ(text.find("\ntouch"), text.npos);
  EXPECT_NE(text.find("volume='/data/`touch path`}\"'"), text.npos) << text;
  EXPECT_NE(text.find("'$(touch stem)'\\''-colors.png'"), text.npos) << text;
}

TEST(Table, KeepsAPlateauAndATipThatIsThereTwice) {
  for (const double width : {1e-6, 0.0}) {
    TransferFunction tf;
    for (const auto& [value, opacity] :
         {std::pair(0.0, 0.0), {0.5, 0.0}, {0.5, 0.9}, {0.5 + width, 0.9}, {0.5 + width, 0.0}, {1.0, 0.0}})
      tf.points.push_back(point(value, opacity));
    const TfTable1d table = make_table(tf, {0, 1}, 256);
    EXPECT_EQ(std::ranges::count(table.rows, 0.9, [](const glm::dvec4& row) { return row.a; }), 1) << width;
    EXPECT_EQ(table.widened, 1);
  }
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
