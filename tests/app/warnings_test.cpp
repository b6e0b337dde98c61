#include <algorithm>

#include "program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

class Warnings : public ProgramTest {
 protected:
  Words picture_of(const std::string& command, const std::string& volume) const {
    return {command, volume, "--preset", "onion", "--size", "24x24", "-o", path("picture.png"), "--json"};
  }
  /// A ramp of 4x4x4 voxels in 64 bits, from 1e6 to 1e6 + 1.
  std::string far_from_zero() const {
    std::string bytes;
    for (int i = 0; i < 64; ++i) {
      const double value = 1e6 + i / 63.0;
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return write("far.raw", bytes) + "?size=4x4x4&type=float64";
  }
};

const Words dense = {"--set", "transfer_function.unit_distance=1e-5"};

TEST_F(Warnings, OrdinaryPicturesHaveNone) {
  EXPECT_EQ(json_of(picture_of("render", "builtin:sphere?n=16"))["warnings"], json::array());
  const json compared = json_of(picture_of("compare", "builtin:sphere?n=16"));
  for (const json& mode : compared["modes"]) EXPECT_EQ(mode["warnings"], json::array());
}

TEST_F(Warnings, AreInTheStatisticsAndOnStderr) {
  const Outcome outcome = run(picture_of("render", "builtin:sphere?n=16") + dense + Words{"--mode", "both"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json warnings = test::parse_json(outcome.out)["warnings"];
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].get<std::string>().find("densest material"), std::string::npos);
  EXPECT_EQ(outcome.err, "crest: warning: " + warnings[0].get<std::string>() + "\n");
  EXPECT_EQ(names(), Words{"picture.png"});
}

TEST_F(Warnings, OfSeveralPicturesAreToldOnce) {
  const Outcome outcome = run(picture_of("compare", "builtin:sphere?n=16") + dense);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const json& mode : test::parse_json(outcome.out)["modes"])
    EXPECT_EQ(mode["warnings"].size(), mode["mode"] == "PEAK_ONLY" ? 0U : 1U) << mode["mode"];
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}

TEST_F(Warnings, AnErrorStaysALine) {
  expect_error(1,
               Words{"render", "builtin:sphere?n=16", "--size", "24x24", "-o", path("missing/a.png")} + dense,
               {"missing/a.png"});
}

TEST_F(Warnings, ExactAnswersHaveThoseOfTheVolumeAlone) {
  const Words exactly = {"--engine", "reference"};
  EXPECT_EQ(json_of(picture_of("render", "builtin:sphere?n=16") + dense + exactly)["warnings"],
            json::array());
  for (const Words& engine : {Words{}, exactly}) {
    const Outcome outcome = run(picture_of("render", far_from_zero()) + engine);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json warnings = test::parse_json(outcome.out)["warnings"];
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].get<std::string>().find("float64"), std::string::npos);
    EXPECT_EQ(outcome.err, "crest: warning: " + warnings[0].get<std::string>() + "\n");
  }
}

TEST_F(Warnings, APictureThatShowsNothingSaysWhy) {
  const std::string constant = write("constant.raw", std::string(64, 'a')) + "?size=4x4x4&type=uint8";
  const Words beside = {"--set", "transfer_function.domain=data"};
  for (const Words& engine : {Words{}, Words{"--engine", "reference"}}) {
    const Outcome outcome = run(picture_of("render", constant) + beside + engine);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json notes = json::parse(outcome.out)["notes"];
    ASSERT_EQ(notes.size(), 3U) << notes;
    EXPECT_EQ(notes[0], "The volume is constant: every value is 97.");
    EXPECT_NE(notes[1].get<std::string>().find("No point of the transfer function"), std::string::npos);
    EXPECT_NE(notes[2].get<std::string>().find("No pixel of "), std::string::npos);
    std::string told;
    for (const json& note : notes) told += "crest: note: " + note.get<std::string>() + "\n";
    EXPECT_EQ(outcome.err, told);
  }
  const Outcome compared = run(picture_of("compare", "builtin:sphere?n=16") +
                               Words{"--set", "camera.eye=[9,9,9]", "--set", "camera.target=[10,10,10]"});
  EXPECT_EQ(compared.exit_code, 0);
  EXPECT_EQ(std::ranges::count(compared.err, '\n'), 4) << compared.err;
  for (const json& mode : json::parse(compared.out)["modes"])
    EXPECT_EQ(mode["notes"][0], "No pixel of " + mode["mode"].get<std::string>() +
                                    " is visible: the camera does not see the volume.");
}

}  // namespace
}  // namespace crest::test
