
#include "program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using nlohmann::json;
using VdlsStudy = ProgramTest;

// Small, it has all its parts, and both engines show the same.
TEST_F(VdlsStudy, HasAllItsParts) {
  const Outcome outcome =
      run({"report", "--study", "vdls", "--size", "24x24", "--budget", "1s", "-o", path("out")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json study = test::parse_json(content_of(path("out/vdls.json")));
  EXPECT_EQ(study["format"], "crest-vdls-study");
  ASSERT_EQ(study["table"].size(), 6u);
  for (const json& row : study["table"]) {
    EXPECT_LT(row["largest_difference"]["same_gradients"].get<double>(), 1e-4) << row["id"];
    ASSERT_EQ(row["timings"].size(), 5u);
    const double basic = row["timings"][0]["samples"], enhanced = row["timings"][1]["samples"];
    EXPECT_GT(basic, 0);
    EXPECT_LE(enhanced, basic);
    EXPECT_EQ(row["timings"][3]["samples"], basic);  // the ray caster's without skipping
    for (const json& timing : row["timings"]) EXPECT_GT(timing["frame_ms"].get<double>(), 0);
  }
  std::vector<std::string> ids;
  for (const json& series : study["series"]) ids.push_back(series["id"]);
  EXPECT_EQ(ids,
            (std::vector<std::string>{"intervals", "quadtrees", "layers", "volumes", "images", "rates"}));
  for (const json& series : study["series"])
    for (const json& point : series["points"])
      for (const json& timing : point["timings"])  // so that its numbers can be compared
        EXPECT_EQ(timing["views"], series["points"][0]["timings"][0]["views"]) << series["id"];
  for (const std::size_t scaling : {3, 4, 5}) EXPECT_GE(study["series"][scaling]["fits"].size(), 2u);
  ASSERT_EQ(study["filters"].size(), 6u);
  for (const json& filter : study["filters"])
    EXPECT_LT(filter["largest_difference"]["same_gradients"].get<double>(), 1e-4);
  for (const json& quality : study["quality"]) EXPECT_LT(quality["rmse"].get<double>(), 0.05);
  EXPECT_EQ(study["quality"][0]["rmse"].get<double>() > 0, true);
  EXPECT_NEAR(study["quality"][0]["rmse"], study["quality"][1]["rmse"], 1e-6);  // the same samples
  const std::string page = content_of(path("out/vdls.html"));
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
}

TEST_F(VdlsStudy, TakesAFolder) {
  expect_error(1, {"report", "--study", "vdls", "--data", path("nothing"), "-o", path("out")},
               {"nothing", "folder", "bonsai"});
}

}  // namespace
}  // namespace crest::test
