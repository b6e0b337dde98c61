#include <algorithm>
#include <regex>

#include "program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class KnollStudy : public ProgramTest {
 protected:
  /// Small, of the built-in volumes, and no longer than it must be.
  Words study_to(const std::string& folder, const std::string& budget) const {
    return {"report", "--study", "knoll", "--size", "16x16", "--budget", budget, "-o", path(folder)};
  }
  const std::string no_real_volumes = "unset CREST_DATA;";
};

TEST_F(KnollStudy, OfWhatTheBudgetHasTimeFor) {
  const Outcome outcome = run(study_to("out", "2s") + Words{"--json"}, no_real_volumes);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("table 1: heptane (fig. 3)"), std::string::npos) << outcome.err;
  const json study = test::parse_json(content_of(path("out/knoll.json")));
  EXPECT_EQ(test::parse_json(outcome.out), study);
  EXPECT_EQ(study["format"], "crest-knoll-study");
  EXPECT_EQ(study["claims"].size(), 10u);

  // What is not measured is told: eight scenes, two parts on tables, nineteen comparisons of sampling
  const std::size_t done = study["table1"].size() + study["table2"].size() +
                           std::size_t(!study["bins"].is_null()) + std::size_t(!study["builds"].empty());
  EXPECT_EQ(done + study["left_out"].size(), 8u + 2 + 19);
  EXPECT_GE(study["left_out"].size(), 1u);

  const json& row = study["table1"][0];
  EXPECT_EQ(row["scene"], "heptane-3");
  EXPECT_EQ(row["paper"]["fps_post"], 11.6);
  EXPECT_EQ(study["scenes"][0]["volume"], "builtin:plume?n=96");
  EXPECT_NE(study["scenes"][0]["note"].get<std::string>().find("stands in"), std::string::npos);
  std::map<std::string, json> shots;
  for (const json& shot : row["shots"]) shots[shot["variant"]] = shot;
  for (const char* id : {"post", "xor-paper", "xor", "preintegrated", "preintegrated-table", "xor-paper-all"})
    ASSERT_TRUE(shots.contains(id)) << id;
  EXPECT_EQ(shots["post"]["ratio"], 1.0);
  EXPECT_EQ(shots["post"]["crossings_per_ray"], 0.0);
  EXPECT_EQ(shots["post"]["answer"], "integral");
  EXPECT_EQ(shots["xor"]["answer"], "base+crossings");
  EXPECT_GT(shots["xor"]["samples_per_ray"], shots["post"]["samples_per_ray"]);
  EXPECT_GT(shots["xor-paper-all"]["samples_per_ray"],
            1.5 * shots["xor-paper"]["samples_per_ray"].get<double>());
  EXPECT_NEAR(shots["preintegrated-table"]["dvr_samples_per_ray"].get<double>() /
                  shots["post"]["dvr_samples_per_ray"].get<double>(),
              1, 0.1);
  EXPECT_LT(shots["xor"]["error"]["rmse"], shots["xor-paper"]["error"]["rmse"]);
  for (const auto& [id, shot] : shots) EXPECT_GE(shot["frame_ms_all"].size(), 3u) << id;

  const std::string csv = content_of(path("out/knoll.csv"));
  std::size_t rows = 1 + 2 * study["table2"].size();
  for (const json& table_row : study["table1"]) rows += table_row["shots"].size();
  if (!study["bins"].is_null()) rows += study["bins"]["shots"].size();
  EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), rows);
}

TEST_F(KnollStudy, ThePageStandsAloneAndAPresetRendersItsScene) {
  ASSERT_EQ(run(study_to("out", "1s"), no_real_volumes).exit_code, 0);
  const std::string page = content_of(path("out/knoll.html"));
  EXPECT_EQ(page.find("{{"), page.npos);
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(https?://(?!www\.w3\.org/))")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(<(link|script|img)[^>]*(src|href)=)")));
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const json data = test::parse_json(page.substr(at, page.find("</script>", at) - at));
  std::size_t panels = 0;
  for (const json& figure : data["figures"])
    for (const json& panel : figure["panels"])
      for (const char* kind : {"picture", "error_picture"}) {
        const std::string name = panel[kind];
        EXPECT_TRUE(std::filesystem::exists(path("out/" + name))) << name;
        EXPECT_TRUE(data["pictures"].contains(name)) << name;
        ++panels;
      }
  EXPECT_GE(panels, 8u) << "figure 3 at least";

  // Steps, peaks and camera are the study's own, so the samples are
  const json& scene = data["scenes"][0];
  const json statistics =
      json_of({"render", scene["volume"], "--preset", path("out/" + scene["preset"].get<std::string>()),
               "--size", "16x16", "-o", path("p.png"), "--json"});
  EXPECT_EQ(statistics["samples_per_ray"], data["table1"][0]["shots"][1]["samples_per_ray"]);
}

TEST_F(KnollStudy, WrongCommandLines) {
  expect_error(1, study_to("out", "1s") + Words{"--data", path("nowhere")}, {"nowhere", "--data"});
  expect_error(1, study_to("out", "0.000001s"), {"nothing was measured", "budget"}, no_real_volumes);
  expect_error(2, study_to("out", "1s") + Words{"builtin:sphere"}, {"knoll", "VOLUME"});
}

TEST_F(KnollStudy, StoppedItWritesNothing) {
  const Outcome outcome = run({"report", "--study", "knoll", "--size", "64x64", "-o", path("out")},
                              no_real_volumes + interrupted_after(3));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("nothing is written"), std::string::npos) << outcome.err;
  EXPECT_EQ(names(), Words{});
}

}  // namespace
}  // namespace crest::test
