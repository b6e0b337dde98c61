#include "app/preset_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "app/trash.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// A home for data of its own.
class OwnPresets : public ::testing::Test {
 protected:
  OwnPresets() {
    fs::remove_all(home);
    fs::create_directories(home);
    ::setenv("XDG_DATA_HOME", home.c_str(), 1);
  }
  ~OwnPresets() override {
    ::unsetenv("XDG_DATA_HOME");
    fs::remove_all(home);
  }
  static Preset named(const std::string& name) {
    Preset preset = load_preset("onion");
    preset.name = name;
    return preset;
  }
  std::vector<std::string> titles() {
    std::vector<std::string> list;
    for (const auto& item : folder.items()) list.push_back(title_of(item.preset, item.path.stem().string()));
    return list;
  }
  std::string trash_info(const std::string& name) const {
    return read_file(home / "Trash" / "info" / (name + ".trashinfo"), 10000);
  }

  fs::path home = fs::temp_directory_path() / ("crest data %" + std::to_string(::getpid()));
  PresetFolder folder{home / "crest" / "presets"};
};

using Names = std::vector<std::string>;

TEST_F(OwnPresets, AreAddedRenamedAndDuplicated) {
  folder.read_again();
  EXPECT_TRUE(folder.items().empty());
  const fs::path skull = folder.add(named("My skull"));
  EXPECT_EQ(skull.filename(), "my-skull.json");
  EXPECT_EQ(folder.add(named("My skull")).filename(), "my-skull-2.json");
  const fs::path copy = folder.duplicate(skull);
  EXPECT_EQ(load_preset(copy.string()), named("Copy of My skull"));
  EXPECT_EQ(titles(), (Names{"Copy of My skull", "My skull", "My skull"}));
  const fs::path renamed = folder.rename(copy, "A head");
  EXPECT_EQ(renamed.filename(), "a-head.json");
  EXPECT_FALSE(fs::exists(copy));
  EXPECT_EQ(load_preset(renamed.string()), named("A head"));
  EXPECT_EQ(folder.rename(renamed, "a HEAD"), renamed) << "its file's name stays";
  EXPECT_EQ(folder.duplicate("onion").filename(), "copy-of-onion.json") << "of the program's";
}

TEST_F(OwnPresets, WhatIsNoPresetIsLeftOut) {
  folder.add(named("One"));
  std::ofstream(home / "crest" / "presets" / "other.json") << "[1, 2]";
  std::ofstream(home / "crest" / "presets" / "notes.txt") << "text";
  folder.read_again();
  EXPECT_EQ(titles(), Names{"One"});
  EXPECT_THROW(folder.rename(home / "missing.json", "x"), Error);
}

TEST_F(OwnPresets, DeletedOnesAreInTheBinAsAFileManagerExpects) {
  const fs::path one = folder.add(named("One"));
  const std::string content = read_file(one, 1 << 20);
  folder.remove(one);
  EXPECT_TRUE(folder.items().empty());
  EXPECT_EQ(read_file(home / "Trash" / "files" / "one.json", 1 << 20), content);
  const std::string info = trash_info("one.json");
  EXPECT_TRUE(info.starts_with("[Trash Info]\nPath=/")) << info;
  EXPECT_NE(info.find("crest%20data%20%25"), info.npos) << "escaped as in a URL: " << info;
  EXPECT_NE(info.find("/crest/presets/one.json\nDeletionDate=2"), info.npos) << info;
  EXPECT_EQ(info.size(),
            info.find("DeletionDate=") + std::string("DeletionDate=2026-01-01T00:00:00\n").size());
}

TEST_F(OwnPresets, TwoOfOneNameAreBothInTheBin) {
  folder.remove(folder.add(named("One")));
  folder.remove(folder.add(named("One")));
  EXPECT_TRUE(fs::exists(home / "Trash" / "files" / "one.json"));
  EXPECT_TRUE(fs::exists(home / "Trash" / "files" / "one.2.json"));
  EXPECT_NE(trash_info("one.2.json").find("/one.json\n"), std::string::npos) << "where it was";
}

TEST_F(OwnPresets, WhatCannotBeMovedStays) {
  const fs::path one = folder.add(named("One"));
  std::ofstream(home / "Trash") << "a file in the way";
  EXPECT_THROW(folder.remove(one), Error);
  EXPECT_TRUE(fs::exists(one));
  EXPECT_THROW(move_to_trash(home / "missing.json", home), Error);
}

TEST(FileName, IsMadeOfATitle) {
  EXPECT_EQ(file_name_for("My skull (CT)"), "my-skull-ct");
  EXPECT_EQ(file_name_for("../../etc/passwd"), "etc-passwd");
  EXPECT_EQ(file_name_for("///"), "preset");
  EXPECT_EQ(file_name_for("Sch\xc3\xa4"
                          "del"),
            "sch\xc3\xa4"
            "del");
  EXPECT_EQ(file_name_for(std::string(79, 'a') + "\xc3\xa4").size(), 79U) << "no half of a character";
}

}  // namespace
}  // namespace crest
