#include <unistd.h>

#include <gtest/gtest.h>

#include <cmath>

#include "app/stability_files.h"
#include "presets/atomic_file.h"
#include "presets/json.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using stability::Row;
using stability::Truth;
using stability::Verdict;

Row a_row() {
  Row row;
  row.group = "a group";
  row.claim = {.name = "a case </script>",
               .quantity = "a quantity",
               .bound = 1e-5,
               .truth = Truth::reference,
               .limit = stability::Limit{0.25, "why", {"A pixel may be off."}}};
  row.measured = 2e-4;
  row.at = "step 2";
  row.not_finite = 1;
  row.covered = 7;
  row.left_out = 3;
  row.picture = {{2, 1}, {glm::vec4(1), glm::vec4(0)}};
  row.verdict = Verdict::limited;
  return row;
}

TEST(StabilityFiles, ARowAsJson) {
  const Json table = stability_json({a_row()}, "a renderer");
  EXPECT_EQ(table, Json::parse(R"({"renderer": "a renderer", "rows": [{
      "group": "a group", "case": "a case </script>", "quantity": "a quantity", "truth": "exact reference",
      "bound": 1e-5, "measured": 2e-4, "verdict": "limited", "worst_at": "step 2", "pixels_not_finite": 1,
      "pixels_covered": 7, "pixels_grazing": 3,
      "limit": {"bound": 0.25, "why": "why", "warnings": ["A pixel may be off."]}}]})"));
}

TEST(StabilityFiles, NoLimitAndNoNumber) {
  Row row = a_row();
  row.claim.limit.reset();
  row.measured = INFINITY;
  row.verdict = Verdict::fail;
  const Json read = Json::parse(stability_json({row}, "").dump())["rows"][0];
  EXPECT_FALSE(read.contains("limit"));
  EXPECT_TRUE(read["measured"].is_null());
  EXPECT_EQ(read["verdict"], "FAIL");
}

TEST(StabilityFiles, TheFolderHasTheTableAndAPageThatStandsAlone) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("crest-stability-files-" + std::to_string(::getpid()));
  fs::create_directory(folder);
  Row empty = a_row();
  empty.picture = {};
  const Json table = stability_json({a_row(), empty}, "a renderer");
  write_stability({a_row(), empty}, table, folder);

  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"stability.html", "stability.json"}));
  EXPECT_EQ(Json::parse(read_file(folder / "stability.json", 1 << 20)), table);
  const std::string page = read_file(folder / "stability.html", 1 << 20);
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const Json data = Json::parse(page.substr(at, page.find("</script>", at) - at));
  EXPECT_EQ(data["rows"][0]["case"], "a case </script>");
  EXPECT_TRUE(data["rows"][0]["picture"].get<std::string>().starts_with("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_FALSE(data["rows"][1].contains("picture"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace crest
