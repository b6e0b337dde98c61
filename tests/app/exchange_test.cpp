// crest export and crest import, as a person types them.
#include "presets/exchange/exporters.h"

#include <algorithm>

#include "presets/exchange/importers.h"
#include "presets/preset_file.h"
#include "render/files/image.h"
#include "tests/app/program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

class Exchange : public ProgramTest {};

TEST_F(Exchange, EachFormatIsWritten) {
  for (const Exporter& exporter : exporters()) {
    const std::string file = "out-" + std::string(exporter.name) + std::string(exporter.extension);
    const auto json = json_of({"export", "dirac-shell", "--to", std::string(exporter.name), "-o", path(file),
                               "--volume", "builtin:sphere?n=16", "--json"});
    EXPECT_EQ(json["format"], exporter.name);
    EXPECT_EQ(json["files"][0], path(file));
    for (const std::string written : json["files"])
      EXPECT_GT(std::filesystem::file_size(written), 50u) << written;
    EXPECT_TRUE(json["losses"].is_array());
  }
}

// What is lost is said on stderr, a sentence a line, and nothing is on stdout.
TEST_F(Exchange, SaysWhatIsLost) {
  const Outcome outcome =
      run({"export", "dirac-shell", "--to", "1dt", "-o", path("a.1dt"), "--volume", "builtin:sphere?n=16"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("lost: 1 peak is not drawn as a surface there"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("lost: the unit distance is not in the file"), std::string::npos) << outcome.err;
}

TEST_F(Exchange, ErrorsSayWhatWouldBeRight) {
  const std::string out = path("a.json");
  expect_error(1, {"export", "dirac-shell", "--to", "paraview", "-o", out}, {"normalized", "--volume"});
  expect_error(1,
               {"export", "dirac-shell", "--to", "paraview", "-o", path("none/a.json"), "--volume",
                "builtin:sphere?n=8"},
               {"none"});
  expect_error(2, {"export", "dirac-shell", "--to", "doom", "-o", out}, {"doom", "paraview-script"});
  expect_error(2, {"export", "dirac-shell", "--to", "csv", "-o", out, "--samples", "1"},
               {"--samples", "[2, 1048576]"});
  expect_error(2, {"export", "dirac-shell", "--to", "csv", "-o", out, "--samples", "x"},
               {"--samples", "auto"});
  expect_error(2, {"export", "dirac-shell", "--to", "csv", "-o", out, "--preview", path("p.png")},
               {"--volume"});
  expect_error(1, {"import", path("none.json"), "-o", out}, {"none.json"});
  expect_error(1, {"import", write("a.txt", "words"), "-o", out}, {"a.txt", "none of the formats", "Inviwo"});
  expect_error(1, {"import", write("bad.itf", "<x>"), "-o", out}, {"bad.itf", "not XML"});
  expect_error(2, {"import", write("one.1dt", "2\n0 0 0 0\n1 1 1 1\n")}, {"--output", "--list"});
  expect_error(2, {"import", path("one.1dt"), "-o", out, "--take", "colors"}, {"--onto"});
  expect_error(1,
               {"render", "builtin:sphere?n=8", "--preset",
                write("map.json", R"([{"RGBPoints": [0,0,0,0, 1,1,1,1]}])"), "-o", path("p.png")},
               {"map.json", "crest import"});
}

TEST_F(Exchange, APreviewIsDrawnBesideCrest) {
  const auto json =
      json_of({"export", "dirac-shell", "--to", "1dt", "--samples", "256", "-o", path("a.1dt"), "--volume",
               "builtin:sphere?n=16", "--preview", path("p.png"), "--size", "64x64", "--json"});
  EXPECT_GT(json["preview"]["rmse"].get<double>(), 0.05) << "the shell is missed between samples";
  const Image image = read_image(path("p.png"));
  EXPECT_EQ(image.size, glm::ivec2(3 * 64 + 4, 64));
  // Of a source that keeps the peaks the picture is the same
  const auto same = json_of({"export", "dirac-shell", "--to", "glsl", "-o", path("a.glsl"), "--volume",
                             "builtin:sphere?n=16", "--preview", path("q.png"), "--size", "64x64", "--json"});
  EXPECT_LT(same["preview"]["rmse"].get<double>(), 2e-3);
}

TEST_F(Exchange, AFileWithSeveralIsListedAndChosen) {
  const std::string maps = write(
      "maps.json", R"([{"Name": "one", "RGBPoints": [0,0,0,0, 1,1,1,1], "Points": [0,0,0.5,0, 1,0.5,0.5,0]},
                                                  {"Name": "two", "RGBPoints": [0,1,0,0, 1,0,0,1]}])");
  EXPECT_EQ(output_of({"import", maps, "--list"}), "one\ntwo\n");
  expect_error(1, {"import", maps, "-o", path("p.json")}, {"2 presets", "--name", "one, two"});
  const auto json = json_of({"import", maps, "--name", "one", "-o", path("p.json"), "--json"});
  EXPECT_EQ(json["name"], "one");
  const Preset preset = load_preset(path("p.json"));
  EXPECT_EQ(preset.transfer_function.points[1].opacity, 0.5);
  run({"import", maps, "--name", "two", "--take", "colors", "--onto", path("p.json"), "-o", path("q.json")});
  const Preset mixed = load_preset(path("q.json"));
  EXPECT_EQ(mixed.transfer_function.points[1].opacity, 0.5);
  EXPECT_EQ(mixed.transfer_function.points[0].color, glm::dvec3(1, 0, 0));
}

}  // namespace
}  // namespace crest::test
