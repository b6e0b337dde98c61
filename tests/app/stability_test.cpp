#include <unistd.h>

#include <set>

#include "page.h"
#include "program.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

class Stability : public ProgramTest {
 protected:
  Words stability(const Words& options) const { return Words{"stability"} + options; }
};

TEST_F(Stability, WritesAllOfItsTable) {
  const Outcome outcome = run(stability({"--size", "16x16", "-o", path("new/folder"), "--json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json table = test::parse_json(outcome.out);
  EXPECT_EQ(test::parse_json(content_of(path("new/folder/stability.json"))), table);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("new/folder")), {}), 2);

  std::set<std::string> rows, groups;
  for (const json& row : table["rows"]) {
    const std::string name = row["case"], quantity = row["quantity"];
    EXPECT_TRUE(rows.insert(name + ": " + quantity).second) << name << ": " << quantity;
    groups.insert(row["group"]);
    EXPECT_EQ(row["verdict"], "pass") << name;
    EXPECT_LE(row["measured"], row["bound"]) << name;
    EXPECT_EQ(row["pixels_not_finite"], 0) << name;
  }
  EXPECT_GE(rows.size(), 200U);
  EXPECT_EQ(groups, (std::set<std::string>{"invariances", "transfer functions", "opacities", "crossings",
                                           "values", "grids", "cameras"}));
  const json shown = expect_standalone_page(content_of(path("new/folder/stability.html")));
  ASSERT_EQ(shown["rows"].size(), rows.size());
  for (const json& row : shown["rows"])
    EXPECT_TRUE(row["picture"].get<std::string>().starts_with("data:image/png;base64,")) << row["case"];
}

TEST_F(Stability, StoppedItLeavesNothing) {
  expect_error(1, stability({"--size", "256x256", "-o", path("new/folder")}),
               {"crest: stopped before the table was done; nothing is written\n"}, interrupted_after(3));
}

TEST_F(Stability, WrongCommandLines) {
  for (const char* size : {"0x0", "16", "-1x16", "16x16x16", "huge", "", "8x8", "1x1", "16x24", "16384x16"})
    expect_error(2, stability({"--size", size}), {"--size"});
  expect_error(2, stability({"-o"}), {"--output"});
  expect_error(2, stability({"-o", ""}), {"--output"});
  expect_error(2, stability({"--mode", "both"}), {"--mode"});
  expect_error(2, stability({"builtin:plume"}), {"builtin:plume"});
}

TEST_F(Stability, WhatCannotBeIsFoundBeforeAnyWork) {
  expect_error(2, stability({"--size", "99999x16"}), {"99999x16", "1..16384"});
  expect_error(1, stability({"--device", "99"}), {"99"});
  write("file", "");
  expect_error(1, stability({"-o", path("file")}), {"file", "folder"});
  expect_error(1, stability({"-o", path("file/below")}), {"file", "folder"});
  expect_error(1, stability({"-o", path("new/folder"), "--device", "99"}), {"99"});
  expect_error(1, stability({"-o", "/proc/folder"}), {"/proc/folder"});
}

TEST_F(Stability, NoPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::create_directory(path("locked"));
  std::filesystem::permissions(path("locked"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  expect_error(1, stability({"-o", path("locked")}), {"locked", "ermission denied"});
  expect_error(1, stability({"-o", path("locked/below")}), {"locked/below", "ermission denied"});
}

}  // namespace
}  // namespace crest::test
