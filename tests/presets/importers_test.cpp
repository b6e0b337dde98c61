#include "presets/exchange/importers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "presets/error.h"
#include "presets/exchange/curves.h"
#include "presets/exchange/exporters.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/table.h"
#include "presets/exchange/words.h"
#include "presets/preset_file.h"
#include "tests/presets/export_inputs.h"
#include "tests/presets/random_tf.h"

namespace crest {
namespace {

std::vector<Imported> read(std::string_view content, const char* name) {
  const Importer* importer = find_importer(content, name);
  if (!importer) throw Error("no importer");
  return importer->read(content);
}
TransferFunction read_tf(std::string_view content, const char* name) {
  return read(content, name).at(0).preset.transfer_function;
}
std::string error_of(std::string_view content, const char* name) {
  try {
    read(content, name);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
#ifdef __SANITIZE_ADDRESS__
constexpr int round_trips = 100;
#else
constexpr int round_trips = 1000;
#endif

struct RoundTrip {
  const char* format;
  const char* file;
  Separation separation;
  double off;           ///< of opacities and colours
  bool keeps_unit;      ///< distance; the others take opacities for another one
  double unit_of_file;  ///< 0: opacities as they are
};

class RoundTrips : public ::testing::TestWithParam<RoundTrip> {};

// What is read back is the same function, but for how far the format must draw points apart.
TEST_P(RoundTrips, GiveTheSameFunction) {
  const RoundTrip& trip = GetParam();
  std::mt19937 random(13);
  for (int trial = 0; trial < round_trips; ++trial) {
    ExportInput input;
    input.name = "Name";
    input.preset.transfer_function = random_tf(random);
    const TransferFunction tf = trip.unit_of_file > 0
                                    ? with_unit_distance(input.preset.transfer_function, trip.unit_of_file)
                                    : input.preset.transfer_function;
    const Imported imported = read(find_exporter(trip.format).write(input).files[0].content, trip.file).at(0);
    const TransferFunction& back = imported.preset.transfer_function;
    ASSERT_EQ(back.points.size(), tf.points.size());
    const double moved = farthest_move(tf, separated_values(tf, trip.separation));
    ASSERT_EQ(why_different(tf, back, 1.01 * moved, trip.off), "")
        << "trial " << trial << ", moved " << moved;
    if (trip.keeps_unit) {
      EXPECT_EQ(back.unit_distance, tf.unit_distance);
    }
    EXPECT_EQ(back.domain, Domain::data);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrips,
                         ::testing::Values(RoundTrip{"paraview", "a.json", drawn_apart, 0, false, 0},
                                           RoundTrip{"slicer", "a.vp.json", slicer_apart, 0, true, 0},
                                           RoundTrip{"slicer-vp", "a.vp", slicer_apart, 1e-15, false, 1},
                                           RoundTrip{"vtkjs", "a.json", drawn_apart, 0, false, 0},
                                           RoundTrip{"inviwo", "a.itf", drawn_apart, 0, false, 0}),
                         [](const auto& trip) {
                           std::string name = trip.param.format;
                           std::erase(name, '-');
                           return name;
                         });

// Of tables the same rows come back.
TEST(Tables, GiveTheSameRows) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 100; ++trial) {
    ExportInput input;
    input.preset.transfer_function = random_tf(random, 100);
    input.rows = 2 + int(random() % 300);
    const TransferFunction& tf = input.preset.transfer_function;
    ValueRange range = tf.range();
    if (!(range.width() > 0)) range.max = range.min + 1;
    const TfTable1d table = make_table(tf, range, input.rows);
    for (const auto& [format, file] : {std::pair("csv", "a.csv"), {"1dt", "a.1dt"}}) {
      const Imported imported = read(find_exporter(format).write(input).files[0].content, file).at(0);
      TransferFunction back = imported.preset.transfer_function;
      if (back.domain == Domain::normalized) back = remap_values(back, {0, 1}, range);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        // The values of .1dt are shares of a range, and a step may be on either side of where it was
        const double place = std::clamp(table.value(row), back.range().min, back.range().max);
        const Classified found = evaluate(back, place);
        EXPECT_NEAR(found.opacity, table.rows[row].a, 1e-5) << format << ' ' << row;
        EXPECT_NEAR(found.color.r, table.rows[row].r, 1e-5) << format << ' ' << row;
      }
      const bool tells_unit = std::ranges::any_of(
          table.rows, [](const glm::dvec4& row) { return row.a > 1e-3 && row.a < 0.999; });
      if (format == std::string("csv") && tells_unit) {
        EXPECT_NEAR(imported.preset.transfer_function.unit_distance, tf.unit_distance,
                    1e-6 * tf.unit_distance);
      }
    }
  }
}

TEST(ColorMapJson, QuadsPairsAndVtkjs) {
  const std::string colors = R"("RGBPoints": [0, 0, 0, 1, 100, 1, 0, 0, 255, 1, 1, 1])";
  const auto quads = read(
      "[{\"Name\": \"mine\", " + colors + R"(, "Points": [0, 0, 0.5, 0, 100, 0.8, 0.5, 0, 255, 0, 0.5, 0]}])",
      "a.json");
  EXPECT_EQ(quads[0].preset.name, "mine");
  EXPECT_EQ(quads[0].preset.transfer_function.unit, LengthUnit::voxel);
  const auto pairs = read("[{" + colors + R"(, "Points": [0, 0, 100, 0.8, 255, 0]}])", "a.json");
  EXPECT_TRUE(any_says(pairs[0].notes, "pairs"));
  const auto vtkjs = read("{" + colors + R"(, "OpacityPoints": [0, 0, 100, 0.8, 255, 0]})", "a.json");
  for (const auto* all : {&quads, &pairs, &vtkjs}) {
    const TransferFunction& tf = all->at(0).preset.transfer_function;
    ASSERT_EQ(tf.points.size(), 3u);
    EXPECT_EQ(tf.points[1].value, 100);
    EXPECT_EQ(tf.points[1].opacity, 0.8);
    EXPECT_EQ(tf.points[1].color, glm::dvec3(1, 0, 0));
  }
  const auto doubled = read("[{\"RGBPoints\": [0,, 0, 0, 1,, 1, 1, 0, 0], \"Name\": \"a,,b\"}]", "a.json");
  EXPECT_TRUE(any_says(doubled[0].notes, "twice"));
  EXPECT_EQ(doubled[0].preset.name, "a,,b");
  EXPECT_FALSE(doubled[0].has_opacities);
  EXPECT_EQ(evaluate(doubled[0].preset.transfer_function, 0.5).opacity, 0.5) << "ParaView's ramp";
}

TEST(ColorMapJson, AFileWithSeveral) {
  const auto all =
      read(R"([{"Name": "a", "RGBPoints": [0,0,0,0, 1,1,1,1]}, {"Name": "c", "IndexedColors": [1,0,0]},
                            {"Name": "b", "RGBPoints": [0,1,1,1, 1,0,0,0]}])",
           "maps.json");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(choose(all, "b", "maps.json").preset.name, "b");
  for (const char* name : {"", "c"}) EXPECT_THROW(choose(all, name, "maps.json"), Error);
}

TEST(ColorMapJson, ErrorsSayWhatAndWhere) {
  EXPECT_EQ(error_of(R"([{"RGBPoints": [0, 0, 0]}])", "a.json"),
            "colour map 0: RGBPoints has 3 numbers, which are not x, r, g, b each");
  EXPECT_EQ(error_of(R"([{"RGBPoints": [0, 0, 0, 2]}])", "a.json"),
            "colour map 0: RGBPoints[3]: 2 is not in [0, 1]");
  EXPECT_EQ(error_of(R"([{"RGBPoints": [0, 0, 0, "x"]}])", "a.json"),
            "colour map 0: RGBPoints[3] is not a number");
  EXPECT_EQ(error_of(R"([{"Name": "c", "IndexedColors": [1,0,0]}])", "a.json"),
            "colour map 0: its colours are for categories (IndexedColors), not for values");
  EXPECT_EQ(find_importer("{}", "a.json"), nullptr);
  EXPECT_EQ(find_importer("", "a.txt"), nullptr);
}

// From VTK's own test, Testing/Cxx/TestColorTransferFunction.cxx (to the nearest of 255), and from Moreland's
// paper.
TEST(ColorSpaces, BetweenTwoColours) {
  const glm::dvec3 red(1, 0, 0), blue(0, 0, 1);
  EXPECT_EQ(interpolate(red, blue, 0.5, ColorSpace::rgb), glm::dvec3(0.5, 0, 0.5));
  EXPECT_EQ(interpolate(red, blue, 0.5, ColorSpace::step), blue);
  const glm::dvec3 magenta = interpolate(red, blue, 0.5, ColorSpace::hsv);
  EXPECT_NEAR(magenta.r, 1, 1e-12) << "by the shorter way";
  EXPECT_NEAR(magenta.g, 0, 1e-12);
  EXPECT_NEAR(magenta.b, 1, 1e-12);
  const glm::dvec3 cool(0.231373, 0.298039, 0.752941), warm(0.705882, 0.0156863, 0.14902);
  const glm::dvec3 middle = interpolate(cool, warm, 0.5, ColorSpace::diverging);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(middle[i], 0.8654, 2e-3) << "grey, as in ParaView's Cool to Warm";
  for (const ColorSpace space : {ColorSpace::rgb, ColorSpace::hsv, ColorSpace::lab, ColorSpace::diverging})
    for (const glm::dvec3& a : {red, cool, glm::dvec3(0.5), glm::dvec3(0), glm::dvec3(1)})
      for (const double s : {0.0, 1.0})
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(interpolate(a, warm, s, space)[i], (s == 0 ? a : warm)[i], 1e-3)
              << int(space) << ' ' << s;
}

// Straight lines between enough points are within 1/255 of the space's own curve.
TEST(ColorSpaces, BecomePointsEnough) {
  for (const ColorSpace space : {ColorSpace::hsv, ColorSpace::lab, ColorSpace::diverging}) {
    const glm::dvec3 a(0.231373, 0.298039, 0.752941), b(0.705882, 0.0156863, 0.14902);
    const TransferFunction tf = straightened({{0, a}, {10, b}}, {{0, 0.25}, {10, 0.75}}, space);
    EXPECT_LT(tf.points.size(), 100u);
    double largest = 0;
    for (int i = 0; i <= 1000; ++i) {
      const Classified found = evaluate(tf, i / 100.0);
      const glm::dvec3 off = glm::abs(found.color - interpolate(a, b, i / 1000.0, space));
      largest = std::max({largest, off.r, off.g, off.b});
      EXPECT_NEAR(found.opacity, 0.25 + i / 2000.0, 1e-12);
    }
    EXPECT_LT(largest, 1.0 / 255) << int(space);
    EXPECT_GT(largest, 0);
  }
}

TEST(MidpointAndSharpness, AsVtkHasThem) {
  // sharpness 1: a step at the midpoint; midpoint alone: a bend there
  TransferFunction tf = straightened({}, {{0, 0.2, 0.25, 1}, {1, 0.8}}, ColorSpace::rgb);
  EXPECT_EQ(evaluate(tf, 0.2499).opacity, 0.2);
  EXPECT_EQ(evaluate(tf, 0.25).opacity, 0.8);
  tf = straightened({}, {{0, 0, 0.25, 0}, {1, 1}}, ColorSpace::rgb);
  EXPECT_NEAR(evaluate(tf, 0.25).opacity, 0.5, 1e-12);
  EXPECT_NEAR(evaluate(tf, 0.125).opacity, 0.25, 1e-12);
  // vtkPiecewiseFunction::GetTable's own formula at sharpness 0.5, midpoint 0.5, s = 0.25
  tf = straightened({}, {{0, 0, 0.5, 0.5}, {1, 1}}, ColorSpace::rgb);
  const double s = 0.5 * std::pow(0.5, 6), ss = s * s, sss = ss * s;
  EXPECT_NEAR(evaluate(tf, 0.25).opacity, -2 * sss + 3 * ss + 0.5 * (sss - 2 * ss + s) + 0.5 * (sss - ss),
              1.0 / 255);
  EXPECT_NEAR(evaluate(tf, 0.5).opacity, 0.5, 1.0 / 255);
}

TEST(ParaViewXml, PointsWithOpacities) {
  const auto all = read(R"(<ColorMaps><ColorMap name="one" space="RGB"><Point x="-1" o="0" r="0" g="0" b="1"/>
    <Point x="2" o="0.5" r="1" g="1" b="0"/><NaN r="1" g="0" b="0"/></ColorMap>
    <ColorMap name="two" space="Diverging"><Point x="0" o="1" r="0.2" g="0.3" b="0.8"/><Point x="1" o="1" r="0.7" g="0" b="0.1"/></ColorMap></ColorMaps>)",
                        "a.xml");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].preset.transfer_function.points.size(), 2u);
  EXPECT_EQ(all[0].preset.transfer_function.points[1].opacity, 0.5);
  EXPECT_FALSE(all[1].has_opacities);
  EXPECT_GT(all[1].preset.transfer_function.points.size(), 4u);
  EXPECT_TRUE(error_of("<ColorMap><Point x=\"0,5\"/></ColorMap>", "a.xml").find("is not a number") !=
              std::string::npos);
  EXPECT_TRUE(error_of("<ColorMap><Point", "a.xml").starts_with("not XML"));
}

TEST(SlicerPresets, AreReadByName) {
  const auto all = read(R"(<MRML><VolumeProperty id="1" name="CT-Bone" interpolation="1" shade="1"
     colorTransfer="8 0 0.1 0.2 0.3 100 1 1 1" scalarOpacity="4 0 0 100 0.7" gradientOpacity="4 0 1 255 1"/>
     <VolumeProperty name="other" colorTransfer="4 0 1 1 1" scalarOpacity="4 0 0 1 1" gradientOpacity="4 0 0 90 1"/></MRML>)",
                        "presets.xml");
  ASSERT_EQ(all.size(), 2u);
  const Imported& bone = choose(all, "CT-Bone", "presets.xml");
  EXPECT_EQ(bone.preset.rendering.shading, Shading::gradient);
  EXPECT_EQ(bone.preset.transfer_function.points.size(), 2u);
  EXPECT_FALSE(any_says(bone.notes, "gradient"));
  EXPECT_TRUE(any_says(all[1].notes, "gradient"));
  EXPECT_NE(error_of(R"(<VolumeProperty name="x" scalarOpacity="5 0 0 1 1"/>)", "presets.xml")
                .find("says that it has 5"),
            std::string::npos);
}

TEST(Inviwo, RelativePositionsAreNormalized) {
  const auto all =
      read(R"(<?xml version="1.0" encoding="UTF-8" ?><InviwoWorkspace version="3"><type content="0" />
    <Points><Point><pos content="0.25" /><rgba x="1" y="0" z="0" w="0.5" /></Point>
    <Point><pos content="0.75" /><rgba x="0" y="0" z="1" w="1" /></Point></Points></InviwoWorkspace>)",
           "a.itf");
  EXPECT_EQ(all[0].preset.transfer_function.domain, Domain::normalized);
  EXPECT_EQ(all[0].preset.transfer_function.points[1].value, 0.75);
}

TEST(OneDt, WithAndWithoutItsCount) {
  EXPECT_EQ(read_tf("3\n0 0 0 0\n1 0 0 0.5\n1 1 1 1\n", "a.1dt").points.size(), 3u);
  EXPECT_EQ(read_tf("0 0 0 0\n0.5 0.5 0.5 0.5\n1 1 1 1\n", "a.1dt").points.size(), 2u) << "on a line";
  EXPECT_EQ(error_of("4\n0 0 0 0\n1 1 1 1\n", "a.1dt"), "says that it has 4 rows, and has 2");
  EXPECT_EQ(error_of("2\n0 0 0 0\n1 1 1\n", "a.1dt"), "line 3: 3 numbers, not red, green, blue, opacity");
  EXPECT_EQ(error_of("2\n0 0 0 0\n1 1 1 nan\n", "a.1dt"), "line 3: not numbers: 1 1 1 nan");
}

// Pairs and quads that could be either are told apart.
TEST(ColorMapJson, PairsOverTheUnitRange) {
  const std::string colors = R"({"RGBPoints": [0, 0, 0, 1, 1, 1, 0, 0], "Points": )";
  const auto opacity = [&](const std::string& points, double value) {
    return evaluate(read_tf(colors + points + "}", "a.json"), value).opacity;
  };
  EXPECT_EQ(opacity("[0, 0, 0.2, 0.1, 0.6, 0.4, 1, 0]", 0.6), 0.4);
  EXPECT_EQ(opacity("[0, 0.3, 1, 0.6]", 1), 0.6);
  EXPECT_EQ(opacity("[0, 0, 0.1, 0.1, 0.2, 0.5, 0.6, 0.4, 0.8, 0.3, 1, 0]", 0.2), 0.5);
  EXPECT_EQ(opacity("[0, 0, 0.5, 0, 0.5, 1, 0.5, 0, 1, 0.25, 0.5, 0]", 0.5), 1) << "quads";
  EXPECT_EQ(read_tf(R"([{"Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0]}])", "a.json").points.size(), 2u)
      << "opacities alone";
}

// What a preset may not hold is not let in.
TEST(Importers, RefuseWhatAPresetCannotHold) {
  const auto error = [](std::string_view content, const char* name) {
    try {
      import_presets(content, name);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string head =
      R"({"volumeProperties": [{"components": [{"scalarOpacity": {"points": [{"x": 0, "y": 0)";
  EXPECT_NE(error(head + R"(}, {"x": 1, "y": 1}]}, "scalarOpacityUnitDistance": 0}]}]})", "a.vp.json")
                .find("unit_distance"),
            std::string::npos);
  EXPECT_NE(error(head + R"(, "midpoint": 5, "sharpness": 1}, {"x": 1, "y": 1}]}}]}]})", "a.vp.json")
                .find("midpoint"),
            std::string::npos);
  EXPECT_NE(error("value,red,green,blue,opacity,extinction\n0,0,0,0,0.5,1e-320\n1,1,1,1,1,1\n", "a.csv"), "");
  EXPECT_NE(error("0.1,0,0,0,x\n1,1,1,1,1\n", "a.csv").find("line 1"), std::string::npos) << "no heading";
  std::string many = R"({"Points": [)";
  for (int i = 0; i < 40000; ++i) many += std::to_string(i) + (i % 2 ? ",0,0.4,0.9," : ",1,0.4,0.9,");
  many += "40000,0,0.5,0]}";
  EXPECT_NE(error(many, "a.json").find("more than 100000 points"), std::string::npos);
}

// XML that does not say that it is in Latin-1; what is kept has to be the same when it is read again.
TEST(Importers, TakeNamesThatAreNoUtf8) {
  const auto all = import_presets(
      "<MRML><VolumeProperty name=\"Sch\xe4"
      "del\" colorTransfer=\"4 0 1 1 1\" scalarOpacity=\"4 0 0 1 1\"/></MRML>",
      "presets.xml");
  EXPECT_EQ(all.at(0).preset.name, "Sch\\xe4del");
  EXPECT_EQ(parse_preset(write_preset(all.at(0).preset), "again"), all.at(0).preset);
}

TEST(Inviwo, PointsOfOnePositionStayWhole) {
  const auto all = read(R"(<InviwoWorkspace version="3"><type content="1" /><Points>
    <Point><pos content="5" /><rgba x="1" y="0" z="0" w="0.9" /></Point>
    <Point><pos content="5" /><rgba x="0" y="0" z="1" w="0.1" /></Point></Points></InviwoWorkspace>)",
                        "a.itf");
  const TransferFunction& tf = all[0].preset.transfer_function;
  EXPECT_EQ(tf.points[0].color, glm::dvec3(0, 0, 1)) << "the lesser opacity first";
  EXPECT_EQ(tf.points[1].opacity, 0.9);
  EXPECT_NEAR(for_volume(all[0], {300, 300, 300}).unit_distance, 2, 1e-12);
}

// A colour map given as a preset is told apart from a damaged preset.
TEST(Importers, AColourMapGivenAsAPresetSaysSo) {
  try {
    parse_preset(R"([{"Name": "mine", "RGBPoints": [0, 0, 0, 1, 255, 1, 1, 1]}])", "maps.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("crest import maps.json -o PRESET"), std::string::npos)
        << error.what();
  }
}

// Cut off anywhere, and with any byte changed: an error or a preset, and no crash.
TEST(Importers, DamagedFilesEndInAnError) {
  std::mt19937 random(23);
  ExportInput input;
  input.preset.transfer_function = random_tf(random, 12);
  int refused = 0;
  for (const auto& [format, file] : {std::pair("paraview", "a.json"),
                                     {"slicer", "a.vp.json"},
                                     {"slicer-vp", "a.vp"},
                                     {"vtkjs", "a.json"},
                                     {"inviwo", "a.itf"},
                                     {"csv", "a.csv"},
                                     {"1dt", "a.1dt"}}) {
    const std::string whole = find_exporter(format).write(input).files[0].content;
    for (int trial = 0; trial < 300; ++trial) {
      std::string damaged = whole.substr(0, trial % 2 ? whole.size() : random() % whole.size());
      if (trial % 2) damaged[random() % damaged.size()] = char(random());
      try {
        if (const Importer* importer = find_importer(damaged, file))
          for (const Imported& one : importer->read(damaged)) {
            EXPECT_FALSE(one.preset.transfer_function.points.empty());
            for (const ControlPoint& p : one.preset.transfer_function.points) {
              EXPECT_TRUE(std::isfinite(p.value) && p.opacity >= 0 && p.opacity <= 1);
            }
          }
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(Combined, TakesColoursOrOpacitiesAlone) {
  std::mt19937 random(29);
  const TransferFunction a = random_tf(random, 20);
  TransferFunction b = random_tf(random, 20);
  const TransferFunction colors = combined(a, b, TfParts::colors, false),
                         opacities = combined(a, b, TfParts::opacities, false);
  for (int i = 0; i <= 1000; ++i) {
    const double value = std::lerp(a.range().min - 1, a.range().max + 1, i / 1000.0);
    EXPECT_NEAR(evaluate(colors, value).opacity, evaluate(a, value).opacity, 1e-9);
    EXPECT_NEAR(evaluate(colors, value).color.r, evaluate(b, value).color.r, 1e-9);
    EXPECT_NEAR(evaluate(opacities, value).opacity, evaluate(b, value).opacity, 1e-9);
    EXPECT_NEAR(evaluate(opacities, value).color.g, evaluate(a, value).color.g, 1e-9);
  }
  EXPECT_EQ(colors.unit_distance, a.unit_distance);
  EXPECT_EQ(opacities.unit_distance, b.unit_distance);
}

}  // namespace
}  // namespace crest
