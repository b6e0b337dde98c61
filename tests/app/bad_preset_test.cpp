
#include "presets/json.h"
#include "program.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
class BadPreset : public ProgramTest {
 protected:
  /// Each command that reads a preset refuses this one.
  void expect_refused(const std::string& content, const std::string& fault) {
    const std::string file = write("p.json", content);
    expect_error(1, {"peaks", file}, {file, fault});
    expect_error(1, {"export", file, "--to", "csv", "-o", path("x.csv")}, {file, fault});
    expect_error(1, {"render", "builtin:sphere?n=8", "--preset", file, "-o", path("a.png")}, {file, fault});
  }
  static std::string with_points(const std::string& points) {
    return R"({"transfer_function": {"points": )" + points + "}}";
  }
};

TEST_F(BadPreset, FaultsAreToldWithTheirJsonPath) {
  expect_refused(with_points(R"([{"value": 1, "opacity": 0}, {"value": 0, "opacity": 0}])"),
                 "transfer_function.points[1].value: 0 is less than the value before it");
  expect_refused(with_points(R"([{"value": 0, "opacity": 1.2}])"),
                 "transfer_function.points[0].opacity: 1.2 is not in [0, 1]");
  expect_refused(with_points(R"([{"value": 0}])"), "transfer_function.points[0].opacity: is missing");
  expect_refused(with_points(R"([{"value": "NaN", "opacity": 0}])"),
                 "transfer_function.points[0].value: \"NaN\" is not a number");
  expect_refused(with_points(R"([{"value": NaN, "opacity": 0}])"), "invalid literal");
  expect_refused(with_points("[]"), "transfer_function.points: holds no point");
  expect_refused("{}", "transfer_function: is missing");
  expect_refused(R"({"version": 2})", "version: 2 is of a newer Crest");
  expect_refused(R"({"format": "other"})", "format: \"other\"");
}

TEST_F(BadPreset, WhatIsNoPresetAtAll) {
  expect_refused("", "unexpected end of input");
  expect_refused("[1, 2]", "is not an object");
  expect_refused(std::string(1000, '\0'), "it is zero");
  expect_refused(std::string(100000, '['), "64 levels");
  expect_error(1, {"peaks", path("")}, {"folder"});
  expect_error(1, {"peaks", path("missing.json")}, {"missing.json", "no such file"});
}

}  // namespace
}  // namespace crest::test
