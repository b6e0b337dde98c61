#include <cmath>
#include <numeric>
#include <sstream>

#include "presets/preset_file.h"
#include "presets/transfer_function.h"
#include "program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
class Data : public ProgramTest {};

TEST_F(Data, InfoOfAVolumeFromAFormula) {
  // x + y/2 + z/4 over [-1, 1]^3
  const auto info = json_of({"info", "builtin:linear?n=5", "--bins", "7"});
  EXPECT_EQ(info["name"], "linear");
  EXPECT_EQ(info["dims"], nlohmann::json({5, 5, 5}));
  EXPECT_EQ(info["type"], "float32");
  EXPECT_EQ(info["spacing"], nlohmann::json({0.5, 0.5, 0.5}));
  EXPECT_EQ(info["origin"], nlohmann::json({-1.0, -1.0, -1.0}));
  EXPECT_EQ(info["direction"], nlohmann::json({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}));
  EXPECT_EQ(info["range"], nlohmann::json({-1.75, 1.75}));
  EXPECT_NEAR(info["mean"], 0, 1e-12);
  // Each axis has points -1, -.5, 0, .5, 1 of variance 1/2.
  EXPECT_NEAR(info["standard_deviation"], std::sqrt(0.5 * (1 + 1.0 / 4 + 1.0 / 16)), 1e-12);
  EXPECT_EQ(info["voxels"], 125);
  EXPECT_EQ(info["nan"], 0);
  EXPECT_EQ(info["inf"], 0);
  const std::vector<int> histogram = info["histogram"];
  ASSERT_EQ(histogram.size(), 7u);
  EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), 0), 125);
  EXPECT_EQ(histogram[0], 6);  // below -1.25: x = y = -1 with four z, x = -1 and y = -0.5 with two
}

TEST_F(Data, InfoByValue) {
  // Its gradient is one vector, of length sqrt(21) / 4: no value stands out
  const auto info =
      json_of({"info", "builtin:linear?n=9", "--by-value", path("curves.csv"), "--suggest-peaks"});
  EXPECT_EQ(info["suggested_peaks"], nlohmann::json::array());
  std::istringstream csv(content_of(path("curves.csv")));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "from,to,volume,surface_area,mean_gradient,enclosed_volume");
  std::getline(csv, line);
  double from = 0, to = 0, volume = 0, area = 0, gradient = 0, enclosed = 0;
  ASSERT_EQ(
      std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", &from, &to, &volume, &area, &gradient, &enclosed),
      6);
  EXPECT_EQ(from, -1.75);
  EXPECT_NEAR(to, -1.75 + 3.5 / 512, 1e-12);
  EXPECT_NEAR(gradient, std::sqrt(21) / 4, 1e-9);
  EXPECT_NEAR(enclosed, 8, 1e-9);
  EXPECT_NEAR(area, gradient * volume / (to - from), 1e-9);
  // The wall of a sphere's field is everywhere; a vessel tree has one
  EXPECT_FALSE(json_of({"info", "builtin:vessels?n=32", "--suggest-peaks"})["suggested_peaks"].empty());
}

TEST_F(Data, MatchCarriesAPresetOver) {
  // Twice the values: what is in data values is doubled, what is over the range stays
  const std::string from = "builtin:linear?n=33", to = "builtin:linear?n=33&a=2&b=1&c=0.5";
  const std::string preset = write("data.json", R"({"format": "crest-preset", "version": 1,
    "transfer_function": {"points": [{"value": -1, "color": [1, 0, 0], "opacity": 0},
                                     {"value": 0.3, "color": [1, 0, 0], "opacity": 0.5}]}})");
  for (const char* by : {"histogram", "range", "least-squares"}) {
    const auto said =
        json_of({"match", preset, "--from", from, "--to", to, "-o", path("out.json"), "--by", by, "--json"});
    EXPECT_NEAR(said["values"][1]["to"], 0.6, 1e-3) << by;
    const TransferFunction tf = load_preset(path("out.json")).transfer_function;
    EXPECT_EQ(tf.domain, Domain::data);
    EXPECT_NEAR(tf.points[0].value, -2, 1e-3) << by;
    EXPECT_EQ(tf.points[1].value, said["values"][1]["to"]) << by;
  }
  const auto fitted = json_of({"match", preset, "--from", from, "--to", to, "-o", path("out.json"), "--by",
                               "least-squares", "--json"});
  EXPECT_NEAR(fitted["explained"], 1, 1e-6);
  expect_error(1,
               {"match", preset, "--from", from, "--to", "builtin:linear?n=17", "-o", path("x.json"), "--by",
                "least-squares"},
               {"33x33x33", "17x17x17", "same grid"});
  run({"match", "four-peaks", "--from", from, "--to", to, "-o", path("out.json")});
  const TransferFunction before = load_preset("four-peaks").transfer_function,
                         after = load_preset(path("out.json")).transfer_function;
  EXPECT_EQ(after.domain, before.domain);
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_NEAR(after.points[i].value, before.points[i].value, 1e-3) << i;
  expect_error(2, {"match", "four-peaks", "--from", from, "-o", path("x.json")}, {"--to"});
  expect_error(1, {"match", "four-peaks", "--from", from, "--to", "none.nrrd", "-o", path("x.json")},
               {"none.nrrd"});
}

TEST_F(Data, InfoOfARawFile) {
  std::string bytes;
  for (int i = 0; i < 24; ++i) bytes += {char(0), char(i)};
  const auto info =
      json_of({"info", write("v.raw", "##" + bytes) +
                           "?size=2x3x4&type=int16&endian=big&offset=2&spacing=1,2,3&origin=4,5,6"});
  EXPECT_EQ(info["dims"], nlohmann::json({2, 3, 4}));
  EXPECT_EQ(info["type"], "int16");
  EXPECT_EQ(info["spacing"], nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(info["origin"], nlohmann::json({4.0, 5.0, 6.0}));
  EXPECT_EQ(info["range"], nlohmann::json({0.0, 23.0}));
  EXPECT_EQ(info["mean"], 11.5);
}

TEST_F(Data, PeaksInTheirOwnValuesAndInAVolumes) {
  const auto own = json_of({"peaks", "four-peaks", "--bins", "200"});
  ASSERT_EQ(own["peaks"].size(), 4u);
  const double values[] = {0.455, 0.485, 0.515, 0.545};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& peak = own["peaks"][i];
    EXPECT_EQ(peak["value"], values[i]);
    EXPECT_EQ(peak["opacity"], 0.45);
    EXPECT_NEAR(peak["width"], 0.002, 1e-12);
    EXPECT_TRUE(peak["detected"] == true && peak["shown"] == true && peak["spike"] == true);
  }
  const auto& table = own["table"];
  EXPECT_EQ(table["bins"], 200);
  EXPECT_EQ(table["range"], nlohmann::json({0.0, 1.0}));
  EXPECT_EQ(table["largest_count"], 4);
  // From the first bin to the last all are met upwards, and back downwards.
  int found = 0;
  for (const auto& cell : table["cells"]) {
    if (cell["entry"] == 0 && cell["exit"] == 199) {
      EXPECT_EQ(cell["peaks"], nlohmann::json(values));
      ++found;
    }
    if (cell["entry"] == 199 && cell["exit"] == 0) {
      EXPECT_EQ(cell["peaks"], nlohmann::json({0.545, 0.515, 0.485, 0.455}));
      ++found;
    }
  }
  EXPECT_EQ(found, 2);

  const auto of_volume = json_of({"peaks", "four-peaks", "--volume", "builtin:linear?n=5"});
  EXPECT_EQ(of_volume["table"]["bins"], 128);
  EXPECT_EQ(of_volume["table"]["range"], nlohmann::json({-1.75, 1.75}));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(of_volume["peaks"][i]["value"], -1.75 + 3.5 * values[i], 1e-12);
}

TEST_F(Data, ExportToParaView) {
  const Outcome fitted = run(
      {"export", "four-peaks", "--to", "paraview", "-o", path("v.json"), "--volume", "builtin:linear?n=5"});
  EXPECT_EQ(fitted.exit_code, 0) << fitted.err;
  EXPECT_EQ(fitted.out, "");
  const auto map = test::parse_json(content_of(path("v.json"))).at(0);
  EXPECT_TRUE(map["Name"].get<std::string>().starts_with("Four peaks "));
  ASSERT_EQ(map["Points"].size(), 16u * 4);
  ASSERT_EQ(map["RGBPoints"].size(), 16u * 4);
  EXPECT_NEAR(map["Points"][3 * 4], -1.75 + 3.5 * 0.455, 1e-12);
  EXPECT_EQ(map["Points"][3 * 4 + 1], 0.45);
  EXPECT_NE(fitted.err.find("Scalar Opacity Unit Distance, in the volume's properties, to 8\n"),
            std::string::npos)
      << "what is lost is told: 16 voxels of 0.5; " << fitted.err;
}

TEST_F(Data, ExportToATable) {
  // In the volume's values, and, of a preset that has values of its own, in those
  Preset own = load_preset("smooth-haze");
  own.transfer_function.domain = Domain::data;
  own.transfer_function.unit = LengthUnit::world;
  const std::string own_file = write("own.json", write_preset(own));
  for (const std::string volume : {"", "builtin:linear?n=5"}) {
    Words arguments = {
        "export", volume.empty() ? own_file : "smooth-haze", "--to", "csv", "-o", path("t.csv"), "--samples",
        "27"};
    if (!volume.empty()) arguments = arguments + Words{"--volume", volume};
    EXPECT_EQ(run(arguments).exit_code, 0);
    std::istringstream lines(content_of(path("t.csv")));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "value,red,green,blue,opacity,extinction");
    const auto value = [&](double normalized) {
      return volume.empty() ? normalized : -1.75 + 3.5 * normalized;
    };
    const double unit_distance = volume.empty() ? 10 : 5;
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
      double number[6];
      ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", number, number + 1, number + 2,
                            number + 3, number + 4, number + 5),
                6);
      EXPECT_NEAR(number[0], value(0.35 + 0.65 * rows / 26), 1e-12);
      EXPECT_NEAR(number[5], extinction(number[4], unit_distance), 1e-12);
      if (rows == 4) {  // 0.45, a point of the preset
        EXPECT_NEAR(number[4], 0.06, 1e-12);
        EXPECT_NEAR(number[1], 0.45, 1e-12);
      }
    }
    EXPECT_EQ(rows, 27);
  }
}

}  // namespace
}  // namespace crest::test
