#include <unistd.h>

#include <set>
#include <sstream>

#include "program.h"
#include "render/files/image.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;

/// A limit on the size of written files, in units of 1024 bytes: a disk that is full after so much.
std::string disk_of(int kilobytes) { return "ulimit -f " + std::to_string(2 * kilobytes) + ";"; }

class Output : public ProgramTest {
 protected:
  static Words render_to(const std::string& file) {
    return {"render", "builtin:sphere?n=8", "--preset", "onion", "--size", "64x64", "-o", file};
  }
  static Words export_to(const std::string& file, const std::string& format = "csv") {
    return {"export", "onion",     "--to", format,     "-o",
            file,     "--samples", "256",  "--volume", "builtin:linear?n=5"};
  }
};

TEST_F(Output, NoFolderOrAFolderItself) {
  for (const char* name : {"missing/a.png", "missing/a.exr"})
    expect_error(1, render_to(path(name)), {name, "folder does not exist"});
  expect_error(1, export_to(path("missing/a.csv")), {"missing/a.csv", "folder does not exist"});
  std::filesystem::create_directory(path("folder.png"));
  expect_error(1, render_to(path("folder.png")), {"folder.png", "irectory"});
  expect_error(1, export_to(path("")), {"irectory"});
  write("file", "");
  expect_error(1, export_to(path("file/a.csv")), {"file/a.csv"});
}

TEST_F(Output, PicturesAreOfTwoKinds) {
  for (const char* name : {"a.jpg", "a", ".png.txt", "png"})
    expect_error(1, render_to(path(name)), {name, ".png or .exr"});
}

/// Every command that writes, with what it would read; the name of what it cannot write comes behind.
const std::vector<Words> writers = {
    {"render", "none.nrrd", "--preset", "none.json", "-o"},
    {"render", "none.nrrd", "-o", "a.png", "--error-bound"},
    {"compare", "none.nrrd", "--preset", "none.json", "-o"},
    {"report", "none.nrrd", "--preset", "none.json", "-o"},
    {"report", "--study", "knoll", "--data", ".", "-o"},
    {"stability", "-o"},
    {"info", "none.nrrd", "--by-value"},
    {"export", "none.json", "--to", "csv", "--volume", "none.nrrd", "-o"},
    {"export", "none.json", "--to", "csv", "--volume", "none.nrrd", "-o", "a.csv", "--preview"},
    {"import", "none.vp.json", "--onto", "none.json", "--volume", "none.nrrd", "-o"},
    {"window", "--preset", "none.json", "--log-frames"},
    {"window", "--preset", "none.json", "--log-layout"},
    {"match", "none.json", "--from", "none.nrrd", "--to", "none.nrrd", "-o"},
};

TEST_F(Output, IsFoundWrongBeforeAnythingIsRead) {
  write("file", "");
  for (const Words& words : writers) expect_error(1, words + Words{"file/a.png"}, {"file/a.png"});
  for (const char* command : {"render", "compare"})
    expect_error(1, {command, "none.nrrd", "-o", "a.jpg"}, {"a.jpg", ".png or .exr"});
}

TEST_F(Output, AllCommandsThatHaveOneAreLookedAt) {
  std::set<std::string> with_output, looked_at;
  std::istringstream lines(output_of({"list", "options"}));
  std::string command;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## crest ")) command = line.substr(9);
    if (line.starts_with("| `-o, --output")) with_output.insert(command);
  }
  for (const Words& words : writers)
    if (words.back() == "-o") looked_at.insert(words.front());
  EXPECT_EQ(looked_at, with_output);
}

TEST_F(Output, NoPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::create_directory(path("locked"));
  std::filesystem::permissions(path("locked"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  expect_error(1, render_to(path("locked/a.png")), {"locked/a.png", "ermission denied"});
  expect_error(1, export_to(path("locked/a.csv")), {"locked/a.csv", "ermission denied"});
}

TEST_F(Output, AFullDiskLeavesWhatWasThere) {
  write("old.csv", "as it was");
  expect_error(1, export_to(path("old.csv")), {"old.csv", "too large"}, disk_of(2));
  EXPECT_EQ(content_of(path("old.csv")), "as it was");
  expect_error(1, export_to(path("new.csv")), {"new.csv", "too large"}, disk_of(2));
  expect_error(1, export_to("/dev/full"), {"/dev/full", "No space left"});
  write("old.png", "as it was");
  expect_error(1, render_to(path("old.png")), {"old.png", "too large"}, disk_of(1));
  expect_error(1, render_to(path("new.exr")), {"new.exr", "too large"}, disk_of(1));
  std::filesystem::create_symlink("/dev/full", path("device.png"));
  expect_error(1, render_to(path("device.png")), {"device.png", "No space left"});
}

TEST_F(Output, TheSameCommandMakesTheSamePicture) {
  output_of(render_to(path("a.png")));
  const std::string png = content_of(path("a.png"));
  output_of(render_to(path("a.png")));
  EXPECT_EQ(content_of(path("a.png")), png);
  output_of(render_to(path("a.exr")));
  const auto pixels = read_image(path("a.exr")).pixels;
  output_of(render_to(path("a.exr")));
  EXPECT_TRUE(read_image(path("a.exr")).pixels == pixels);  // its header holds the time of writing
  output_of({"compare", "builtin:sphere?n=8", "--preset", "onion", "--size", "32x32", "-o", path("c.png")});
  const std::string first = content_of(path("c.png"));
  output_of({"compare", "builtin:sphere?n=8", "--preset", "onion", "--size", "32x32", "-o", path("c.png")});
  EXPECT_EQ(content_of(path("c.png")), first);
  EXPECT_EQ(names(), (Words{"a.exr", "a.png", "c.png"}));
}

}  // namespace
}  // namespace crest::test
