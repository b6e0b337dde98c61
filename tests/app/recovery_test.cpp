#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "app/autosave.h"
#include "app/recovery_file.h"
#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

class Recovery : public ::testing::Test {
 protected:
  Recovery() { fs::remove_all(folder); }
  ~Recovery() override { fs::remove_all(folder); }

  static KeptDocument kept(const std::string& preset, int age = 0) {
    KeptDocument one;
    one.document.volume_source = "builtin:plume?n=64";
    one.document.preset = load_preset(preset);
    one.document.preset.camera = Camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 40, Projection::perspective, ""};
    one.document.preset_path = "/presets/mine.json";
    one.time = std::chrono::system_clock::time_point(seconds(1'700'000'000 - age));
    return one;
  }
  /// As a program that is killed leaves one.
  fs::path leave_behind(const KeptDocument& document) const {
    const RecoveryFile file(folder);
    file.write(document);
    return file.path();
  }
  std::size_t file_count() const {
    return fs::exists(folder) ? std::size_t(std::distance(fs::directory_iterator(folder), {})) : 0;
  }

  fs::path folder = fs::temp_directory_path() / ("crest_recovery_" + std::to_string(::getpid())) / "inner";
};

TEST_F(Recovery, ADocumentComesBackAsItWas) {
  leave_behind(kept("four-peaks"));
  const auto found = RecoveryFile::left_behind(folder);
  ASSERT_EQ(found.size(), 1U);
  const KeptDocument read = found[0].read();
  EXPECT_EQ(read.document, kept("four-peaks").document);
  EXPECT_EQ(read.time, kept("four-peaks").time);
  found[0].remove();
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(Recovery, WhatARunningProgramHoldsIsNotOffered) {
  const RecoveryFile mine(folder);
  mine.write(kept("onion"));
  EXPECT_TRUE(RecoveryFile::left_behind(folder).empty());
  leave_behind(kept("fire"));
  const auto found = RecoveryFile::left_behind(folder);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(RecoveryFile::left_behind(folder).empty()) << "who offers it holds it";
}

TEST_F(Recovery, TheNewestComesFirstAndTooManyGo) {
  std::vector<fs::path> names;
  for (int i = 0; i < int(most_recoveries) + 3; ++i) {
    names.push_back(leave_behind(kept("onion")));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // their names tell their age
  }
  const auto found = RecoveryFile::left_behind(folder);
  ASSERT_EQ(found.size(), most_recoveries);
  EXPECT_EQ(found.front().path(), names.back());
  EXPECT_FALSE(fs::exists(names[2]));
  EXPECT_TRUE(fs::exists(names[3]));
}

TEST_F(Recovery, WhatCannotBeReadTakesNoPlaceFromWhatCan) {
  const fs::path good = leave_behind(kept("fire"));
  for (std::size_t i = 0; i < most_recoveries; ++i) {  // all newer
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    std::ofstream(leave_behind(kept("onion"))) << "damage";
  }
  const auto found = RecoveryFile::left_behind(folder);
  EXPECT_EQ(found.size(), most_recoveries + 1);
  EXPECT_EQ(found.back().path(), good);
  EXPECT_TRUE(fs::exists(good));
}

TEST_F(Recovery, DamagedFilesAreErrorsNotCrashes) {
  const fs::path name = leave_behind(kept("onion"));
  for (const char* text :
       {"", "{", "[]", R"({"format":"crest-recovery","version":1})",
        R"({"format":"crest-recovery","version":2,"time":0,"volume":"","preset_path":""})",
        R"({"format":"crest-recovery","version":1,"time":"x","volume":"","preset_path":"",)"
        R"("library_name":"","preset":{}})"}) {
    std::ofstream(name) << text;
    const auto found = RecoveryFile::left_behind(folder);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THROW(found[0].read(), Error) << text;
  }
}

TEST_F(Recovery, ANameThatIsNoUtf8CostsNothingElse) {
  KeptDocument odd = kept("onion");
  odd.document.preset_path = "/presets/\xff.json";
  leave_behind(odd);
  EXPECT_EQ(RecoveryFile::left_behind(folder)[0].read().document.preset, odd.document.preset);
}

/// Time is what the tests say it is.
class KeepingUnsavedChanges : public Recovery {
 protected:
  /// One look at the document, `at` seconds after the start; waits for what it begins to write.
  void update(const Document& shown, bool unsaved, double at) {
    const auto now = Autosave::Clock::time_point(
        std::chrono::duration_cast<Autosave::Clock::duration>(std::chrono::duration<double>(at)));
    EXPECT_EQ(autosave->update(shown, unsaved, now), "");
    while (autosave->is_writing()) std::this_thread::yield();
  }
  std::size_t kept_count() const {
    std::size_t count = 0;
    if (fs::exists(folder))
      for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ".json";
    return count;
  }
  std::unique_ptr<Autosave> autosave = std::make_unique<Autosave>(folder);
  Document document = kept("onion").document;
};

TEST_F(KeepingUnsavedChanges, SomeSecondsAfterTheEdit) {
  update(document, true, 0);
  update(document, true, 1.9);
  EXPECT_EQ(kept_count(), 0U);
  update(document, true, 2.1);
  EXPECT_EQ(kept_count(), 1U);
  document.preset.name = "later";
  update(document, true, 3);
  update(document, true, 5.1);
  autosave.reset();  // as a crash: nobody chose to lose it
  const auto found = RecoveryFile::left_behind(folder);
  ASSERT_EQ(found.size(), 1U) << "one file a program";
  EXPECT_EQ(found[0].read().document.preset.name, "later");
}

TEST_F(KeepingUnsavedChanges, AlsoInTheMidstOfALongEdit) {
  for (int i = 0; i <= 95; ++i) {
    document.preset.rendering.step = 1 + i;
    update(document, true, i * 0.1);
  }
  EXPECT_EQ(kept_count(), 0U);
  for (int i = 96; i <= 101; ++i) {
    document.preset.rendering.step = 1 + i;
    update(document, true, i * 0.1);
  }
  EXPECT_EQ(kept_count(), 1U);
}

TEST_F(KeepingUnsavedChanges, NothingIsKeptOfWhatIsSaved) {
  update(document, true, 0);
  update(document, true, 3);
  EXPECT_EQ(kept_count(), 1U);
  update(document, false, 4);
  EXPECT_EQ(file_count(), 0U);
  update(document, true, 5);
  update(document, true, 8);
  EXPECT_EQ(kept_count(), 1U) << "the same again";
  autosave->end();
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(KeepingUnsavedChanges, WhatWasRestoredStaysKept) {
  const fs::path name = leave_behind(kept("fire"));
  auto found = RecoveryFile::left_behind(folder);
  autosave->adopt(std::move(found[0]), document);
  update(document, true, 0);
  EXPECT_TRUE(fs::exists(name)) << "a second crash, now, loses nothing either";
  update(document, false, 1);
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(KeepingUnsavedChanges, AFolderThatCannotBeIsToldAndDoesNotStop) {
  fs::create_directories(folder.parent_path());
  std::ofstream(folder) << "a file in the way";
  using Clock = Autosave::Clock;
  EXPECT_EQ(autosave->update(document, true, Clock::time_point{}), "");
  EXPECT_EQ(autosave->update(document, true, Clock::time_point{} + seconds(3)), "");
  while (autosave->is_writing()) std::this_thread::yield();
  EXPECT_NE(autosave->update(document, true, Clock::time_point{} + seconds(4)).find("cannot keep"),
            std::string::npos);
}

}  // namespace
}  // namespace crest
