#include "app/manual.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "tests/paths.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;

struct Manual : ::testing::Test {
  Manual() { fs::create_directories(folders[1]); }
  ~Manual() override { fs::remove_all(root); }
  static void write(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "# A page";
  }
  fs::path root = fs::temp_directory_path() / ("crest_manual_" + std::to_string(::getpid()));
  std::vector<fs::path> folders{root / "none", root / "docs"};
};

TEST_F(Manual, IsThePageOrItsBeginning) {
  EXPECT_EQ(manual_page("", folders), "");
  write(folders[1] / "manual/index.md");
  EXPECT_EQ(manual_page("", folders), folders[1] / "manual/index.md");
  EXPECT_EQ(manual_page("views", folders), folders[1] / "manual/index.md");
  write(folders[1] / "manual/views.md");
  EXPECT_EQ(manual_page("views", folders), folders[1] / "manual/views.md");
  write(folders[0] / "manual/views.md");
  EXPECT_EQ(manual_page("views", folders), folders[0] / "manual/views.md") << "the first folder comes first";
}

TEST_F(Manual, OfTheSourcesIsFound) {
  const fs::path page = manual_page("", docs_folders());
  EXPECT_TRUE(fs::is_regular_file(page)) << page;
  EXPECT_TRUE(page.string().starts_with(source_folder().string())) << page;
}

}  // namespace
}  // namespace crest::test
