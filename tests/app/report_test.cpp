#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "json_schema.h"
#include "page.h"
#include "program.h"
#include "render/files/image.h"
#include "render/measure/methods.h"
#include "tests/json.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class ReportTest : public ProgramTest {
 protected:
  Words report_to(const std::string& folder) const {
    return {"report", "builtin:sphere?n=12", "--preset", "onion", "--size", "24x24", "-o", path(folder)};
  }
  json json_in(const std::string& folder) const {
    return test::parse_json(content_of(path(folder + "/report.json")));
  }
};

TEST_F(ReportTest, OfASmallScene) {
  const Outcome outcome = run(report_to("out") + Words{"--budget", "none", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(names(), Words{"out"});
  const json report = json_in("out");
  EXPECT_EQ(test::parse_json(outcome.out), report);
  const json schema = test::parse_json(content_of(test::source_folder() / "docs/report.schema.json"));
  EXPECT_EQ(schema_faults(report, schema), Words{});

  // Every method, against its own exact answer, and the finer step is the closer one; without steps it is
  // exact
  EXPECT_EQ(report["methods"].size(), methods().size());
  std::map<std::pair<std::string, std::string>, std::map<double, double>> rmse;
  std::size_t rows = 1;
  for (const json& point : report["points"])
    for (const json& error : point["errors"]) {
      const double step = point["step"].is_null() ? 0.0 : point["step"].get<double>();
      rmse[{point["method"], error["answer"]}][step] = error["compared"]["rmse"];
      ++rows;
    }
  std::size_t pairs = 0;  // the paper's PEAK_XOR_DVR has two answers
  std::set<ExactAnswer> answers;
  for (const Method& method : methods())
    for (const ExactAnswer& exact : exact_answers_of(method)) {
      ++pairs;
      answers.insert(exact);
    }
  EXPECT_EQ(report["answers"].size(), answers.size());
  EXPECT_EQ(rmse.size(), pairs);
  constexpr double rounding = 1e-7;  // of a picture in float
  for (const auto& [key, errors] : rmse)
    EXPECT_LT(errors.begin()->second,
              errors.begin()->first > 0 ? std::max(0.5 * errors.rbegin()->second, rounding) : 1e-4)
        << key.first << " against " << key.second;

  const std::string csv = content_of(path("out/report.csv"));
  EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), rows);
}

TEST_F(ReportTest, ThePageStandsAlone) {
  ASSERT_EQ(run(report_to("out") + Words{"--budget", "2s"}).exit_code, 0);
  const json data = expect_standalone_page(content_of(path("out/report.html")));
  // All the pictures that it names are in it, as they are in the folder
  std::size_t pictures = 0;
  const auto expect_picture = [&](const json& name) {
    if (name.is_null()) return;
    ++pictures;
    EXPECT_TRUE(std::filesystem::exists(path("out/" + name.get<std::string>()))) << name;
    EXPECT_TRUE(data["pictures"].contains(name.get<std::string>())) << name;
  };
  for (const json& answer : data["answers"]) expect_picture(answer["picture"]);
  for (const json& point : data["points"]) {
    expect_picture(point["picture"]);
    for (const json& error : point["errors"]) expect_picture(error["picture"]);
  }
  EXPECT_GE(pictures, 4u);
  for (const json& picture : data["pictures"])
    EXPECT_EQ(picture.get<std::string>().substr(0, 22), "data:image/png;base64,");
}

TEST_F(ReportTest, ItsCommandRendersThePictureThatWasMeasured) {
  const Words settings{"--mode", "DVR_ONLY",
                       "--step", "0.3",
                       "--set",  "rendering.background=[0,0,0.5]",
                       "--set",  "rendering.placement=eye",
                       "--set",  "rendering.early_termination=0.5",
                       "--set",  "rendering.engine=reference"};
  ASSERT_EQ(run(report_to("out") + Words{"--budget", "3s"} + settings).exit_code, 0);
  std::size_t compared = 0;
  const json report = json_in("out");
  for (const json& point : report["points"]) {
    if (point["picture"].is_null()) continue;
    const std::string command = point["command"];
    Words words;
    std::smatch match;
    const std::regex word(R"('([^']*)'|(\S+))");
    for (auto rest = command; std::regex_search(rest, match, word); rest = match.suffix())
      words.push_back(match[1].matched ? match[1] : match[2]);
    ASSERT_EQ(words.front(), "crest");
    words.erase(words.begin());
    words.back() = path("picture.png");
    ASSERT_EQ(run(words).exit_code, 0) << command;
    EXPECT_EQ(read_image(path("picture.png")).pixels,
              read_image(path("out/" + point["picture"].get<std::string>())).pixels)
        << command;
    if (++compared == 4) break;
  }
  EXPECT_EQ(compared, 4u);
}

TEST_F(ReportTest, PaysForAnExactAnswerOnce) {
  const std::string cache = "export XDG_CACHE_HOME=" + path("cache") + ";";
  ASSERT_EQ(run(report_to("out") + Words{"--budget", "3s"}, cache).exit_code, 0);
  const Words render{
      "render",   "builtin:sphere?n=12", "--preset", "onion",          "--size", "24x24", "--json",
      "--engine", "reference",           "-o",       path("exact.png")};
  const Outcome exact = run(render, cache);
  ASSERT_EQ(exact.exit_code, 0) << exact.err;
  EXPECT_EQ(test::parse_json(exact.out)["from_cache"], true);
}

TEST_F(ReportTest, StoppedItKeepsWhatWasMeasured) {
  const Words words{"report",  "builtin:plume?n=48", "--preset", "dirac-shell", "--size",
                    "400x400", "--budget",           "none",     "-o",          path("out")};
  const Outcome outcome = run(words, "self=$(exec sh -c 'echo $PPID'); (sleep 6; kill -INT $self) &");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("stopped after"), std::string::npos) << outcome.err;
  const json report = json_in("out");
  EXPECT_EQ(report["complete"], false);
  EXPECT_GE(report["points"].size(), 1u);
  EXPECT_NE(content_of(path("out/report.html")).find("\"complete\":false"), std::string::npos);
}

TEST_F(ReportTest, TooLittleTimeLeavesNothing) {
  expect_error(1, report_to("out") + Words{"--budget", "0.000001s"}, {"nothing was measured"});
}

TEST_F(ReportTest, FoldersThatItMadeGoAgain) {
  expect_error(1, report_to("new/folder/") + Words{"--budget", "0.000001s"}, {"nothing was measured"});
  expect_error(1, {"report", path("missing.nrrd"), "-o", path("new/folder")}, {"missing.nrrd"});
  expect_error(1, report_to("new/folder") + Words{"--device", "99"}, {"99"});
  std::filesystem::create_directory(path("old"));
  expect_error(1, report_to("old/folder") + Words{"--device", "99"}, {"99"});  // the folder above is kept
}

TEST_F(ReportTest, WrongCommandLines) {
  expect_error(2, {"report", "-o", path("out")}, {"VOLUME", "--study"});
  expect_error(2, {"report", "builtin:sphere?n=8"}, {"--output"});
  expect_error(2, {"report", "builtin:sphere?n=8", "-o", ""}, {"--output"});
  for (const char* budget : {"soon", "0s", "0", "-1", "-1s", "1e9", "1d", "nan", "99999999999s"})
    expect_error(2, report_to("out") + Words{"--budget", budget}, {"--budget", budget, "90s", "none"});
  expect_error(2, report_to("out") + Words{"--target-error", "psnr=30"},
               {"psnr=30", "share=0.001", "rmse", "flip"});
  for (const char* size : {"huge", "0x0", "0x8", "-8x8", "8", "1e3x8"})
    expect_error(2, {"report", "builtin:sphere?n=8", "--size", size, "-o", path("out")}, {size, "512x512"});
  expect_error(2, {"report", "builtin:sphere?n=8", "--size", "20000x8", "-o", path("out")},
               {"20000x8", "1..16384"});
  expect_error(2, {"report", "--study", "bogus", "-o", path("out")}, {"bogus", "study"});
  expect_error(2, {"report", "--study", "placement", "--budget", "9s", "-o", path("out")},
               {"--budget", "--study"});
  write("file", "");
  expect_error(1, report_to("file"), {"file", "folder"});
  expect_error(1, report_to("file/below"), {"file", "folder"});
  expect_error(1, {"report", "builtin:sphere?n=8", "-o", "/proc/folder"}, {"/proc/folder"});
}

}  // namespace
}  // namespace crest::test
