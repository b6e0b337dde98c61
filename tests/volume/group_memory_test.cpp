#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "render/volume/memory.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;

class GroupMemory : public ::testing::Test {
 protected:
  GroupMemory() { fs::create_directories(folder_); }
  ~GroupMemory() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  std::uint64_t left(const std::string& membership) const {
    write("cgroup", membership);
    return group_memory(folder_ / "cgroup", folder_);
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("crest groups " + std::to_string(getpid()));
};

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

TEST_F(GroupMemory, NoGroupIsNoLimit) {
  EXPECT_EQ(left(""), no_limit);
  EXPECT_EQ(left("0::/\n"), no_limit);
  write("memory.max", "max\n");
  EXPECT_EQ(left("0::/\n"), no_limit);
}

TEST_F(GroupMemory, TheTightestAboveCounts) {
  write("memory.max", "9000\n");
  write("a/memory.max", "5000\n");
  write("a/memory.stat", "file 1\nanon 1500\n");
  write("a/b/memory.max", "max\n");
  EXPECT_EQ(left("0::/a/b\n"), 3500U);
  EXPECT_EQ(left("0::/other\n"), 9000U);
  write("a/b/memory.max", "100\n");
  write("a/b/memory.stat", "anon 200\n");
  EXPECT_EQ(left("0::/a/b\n"), 0U);
}

TEST_F(GroupMemory, VersionOneIsSeen) {
  write("memory/docker/x/memory.limit_in_bytes", "7000\n");
  write("memory/docker/x/memory.stat", "rss 3\ntotal_rss 1000\n");
  EXPECT_EQ(left("12:cpu,cpuacct:/y\n4:memory:/docker/x\n"), 6000U);
  EXPECT_EQ(left("4:cpu,memory:/docker/x\n"), 6000U);
  write("memory/memory.limit_in_bytes", "2000\n");  // in a container: the group's own name is not there
  EXPECT_EQ(left("4:memory:/not/here\n"), 2000U);
}

}  // namespace
}  // namespace crest::test
