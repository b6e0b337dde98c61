#include "page.h"
#include "program.h"
#include "render/files/image.h"
#include "render/measure/methods.h"
#include "render/studies/random/measure.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

class RandomStudy : public ProgramTest {
 protected:
  /// The first scene of a seed, at a tiny size.
  Words study_to(const std::string& folder, const Words& options = {}) const {
    return Words{"report", "--study", "random", "--size", "12x9", "--budget", "0.001s", "-o", path(folder)} +
           options;
  }
  json json_in(const std::string& folder) const {
    return test::parse_json(content_of(path(folder + "/random.json")));
  }
};

TEST_F(RandomStudy, HasEveryMethodAtEachStep) {
  const Outcome outcome = run(study_to("new/out", {"--json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json study = json_in("new/out");
  EXPECT_EQ(test::parse_json(outcome.out), study);
  EXPECT_EQ(study["format"], "crest-random-study");
  EXPECT_EQ(study["seed"], 1);
  EXPECT_EQ(study["size"], json({12, 9}));
  ASSERT_EQ(study["scenes"].size(), 1U);
  EXPECT_EQ(study["scenes_of_seed"], 12);
  EXPECT_EQ(study["methods"].size(), methods().size());
  std::size_t expected = 0;
  for (const Method& method : methods())
    expected += exact_answers_of(method).size() * (method.has_step ? std::size(random_study_steps) : 1);
  for (const json& left_out : study["scenes"][0]["left_out"])
    expected -= std::size(random_study_steps) *
                exact_answers_of(*find_method(left_out["what"].get<std::string>())).size();
  EXPECT_EQ(study["measurements"].size(), expected);
  for (const json& m : study["measurements"]) {
    EXPECT_GE(m["within"], 0);
    EXPECT_LE(m["within"], 1);
    EXPECT_EQ(m["crossings"].is_null(), m["method"].get<std::string>().starts_with("dvr"));
    if (m["step"].is_null()) {
      EXPECT_EQ(m["wrong"], 0) << m["method"];
    }
  }
  ASSERT_EQ(study["groups"].size(), 3U);
  EXPECT_EQ(study["groups"][0]["id"], "all");
  EXPECT_EQ(study["groups"][0]["scenes"], 1);
  EXPECT_EQ(study["groups"][1]["scenes"].get<int>() + study["groups"][2]["scenes"].get<int>(), 1);
  const std::string csv = content_of(path("new/out/random.csv"));
  EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), expected + 1);
}

TEST_F(RandomStudy, ItsPageStandsAloneAndItsTableIsPrinted) {
  const Outcome outcome = run(study_to("out", {"--seed", "7"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("of seed 7"), std::string::npos);
  EXPECT_NE(outcome.out.find("\nxor-pre "), std::string::npos);
  EXPECT_NE(outcome.out.find("\nMethods without steps: "), std::string::npos);
  EXPECT_TRUE(outcome.out.ends_with(path("out/random.html") + "\n"));
  json data = expect_standalone_page(content_of(path("out/random.html")));
  EXPECT_EQ(read_image(path("out/images/scene-0.png")).size, glm::ivec2(12, 9));
  EXPECT_EQ(data["pictures"].size(), 1U);
  data.erase("pictures");
  EXPECT_EQ(data, json_in("out"));
  EXPECT_EQ(data["seed"], 7);
}

TEST_F(RandomStudy, StoppedItLeavesNothing) {
  const Words words{"report", "--study", "random", "-o", path("new/out")};
  expect_error(1, words,
               {"crest: " + path("new/out") + ": stopped before the study was done; nothing is written\n"},
               interrupted_after(2));
}

TEST_F(RandomStudy, WrongCommandLines) {
  for (const char* seed : {"-1", "x", "1.5", "1 ", "18446744073709551616"})
    expect_error(2, study_to("out", {"--seed", seed}), {"--seed", "whole number"});
  expect_error(2, {"report", "builtin:gyroid?n=9", "--seed", "2", "-o", path("out")}, {"--seed", "random"});
  expect_error(2, {"report", "--study", "knoll", "--seed", "2", "-o", path("out")}, {"--seed", "random"});
  expect_error(2, study_to("out", {"builtin:gyroid?n=9"}), {"VOLUME", "random"});
  expect_error(2, study_to("out", {"--preset", "onion"}), {"VOLUME"});
}

}  // namespace
}  // namespace crest::test
