#include "app/studio_settings.h"

#include <gtest/gtest.h>

#include "presets/atomic_file.h"
#include "presets/error.h"

namespace crest::testing {
namespace {

class StudioSettingsFile : public ::testing::Test {
 protected:
  StudioSettingsFile() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~StudioSettingsFile() override { std::filesystem::remove_all(folder); }

  ReadSettings read(const std::string& text) const {
    write_file_atomically(file, text);
    return read_settings(file);
  }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      (std::string("crest-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
  const std::filesystem::path file = folder / "settings.json";
};

TEST_F(StudioSettingsFile, ComeBackAsTheyWereWritten) {
  const StudioSettings settings{
      .theme = Theme::light, .scale = 1.25, .data_values = false, .large_peak_table = true};
  write_settings(folder / "new" / "settings.json", settings);
  const ReadSettings result = read_settings(folder / "new" / "settings.json");
  EXPECT_EQ(result.settings, settings);
  EXPECT_EQ(result.problem, "");
  write_settings(file, StudioSettings{});
  EXPECT_EQ(read_settings(file).settings, StudioSettings{});
}

TEST_F(StudioSettingsFile, WithoutAFileTheyAreTheDefaults) {
  EXPECT_EQ(read_settings(file).settings, StudioSettings{});
  EXPECT_EQ(read_settings(file).problem, "");
  EXPECT_EQ(read_settings({}).problem, "");
}

TEST_F(StudioSettingsFile, ABadFileIsToldAndWhatIsRightInItIsTaken) {
  const auto problem_of = [&](const std::string& text) { return read(text).problem; };
  EXPECT_NE(problem_of("{").find("not JSON"), std::string::npos) << problem_of("{");
  EXPECT_NE(problem_of("[1]").find("not a JSON object"), std::string::npos);
  EXPECT_NE(problem_of(R"({"scale": 40})").find("scale"), std::string::npos);
  EXPECT_NE(problem_of(R"({"scale": "big"})").find("from 0.75 to 3"), std::string::npos);
  EXPECT_NE(problem_of(R"({"data_values": 1})").find("data_values"), std::string::npos);
  EXPECT_NE(problem_of(std::string(1 << 20, ' ')), "");
  const ReadSettings half = read(R"({"theme": "light", "scale": -1})");
  EXPECT_EQ(half.settings.theme, Theme::light);
  EXPECT_EQ(half.settings.scale, std::nullopt);
  EXPECT_NE(half.problem.find(file.string()), std::string::npos);
}

TEST_F(StudioSettingsFile, KeysOfOtherVersionsStay) {
  write_file_atomically(file, R"({"later": [1, 2], "theme": "light"})");
  write_settings(file, read_settings(file).settings);
  EXPECT_NE(read_file(file, 1000).find("later"), std::string::npos);
  EXPECT_EQ(read_settings(file).settings.theme, Theme::light);
}

TEST_F(StudioSettingsFile, WhatCannotBeWrittenIsAnError) {
  write_file_atomically(file, "");
  EXPECT_THROW(write_settings(file / "settings.json", StudioSettings{}), Error);
}

}  // namespace
}  // namespace crest::testing
