// Linked programs are read again at the next start, and compiled where that fails.
#include "render/gl/program_files.h"

#include <filesystem>
#include <fstream>

#include "presets/atomic_file.h"
#include "presets/preset_file.h"
#include "render/files/folder_cache.h"
#include "render/gl/program_cache.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

namespace fs = std::filesystem;

class ProgramFiles : public RaycasterTest {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "crest-programs-XXXXXX").string();
    ASSERT_TRUE(mkdtemp(name.data()));
    folder = name;
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    if (formats == 0) GTEST_SKIP() << "this driver gives no program binaries";
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }

  /// How many programs a new start compiles for a variant.
  int compiled(bool statistics = false) const {
    Features features;
    features.dvr = true;
    features.statistics = statistics;
    gl::ProgramCache programs({}, folder);
    for (int again = 0; again < 2; ++again)
      EXPECT_NE(programs.program("fullscreen.vert", "raycaster.frag", shader_defines(features)), 0u);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    return programs.compiled();
  }
  std::vector<fs::path> files() const { return {fs::directory_iterator(folder), fs::directory_iterator()}; }

  fs::path folder;
};

TEST_F(ProgramFiles, ASecondStartCompilesNothing) {
  EXPECT_EQ(compiled(), 1);
  EXPECT_EQ(compiled(), 0);
  EXPECT_EQ(compiled(true), 1) << "another variant";
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(ProgramFiles, WhatWasReadDrawsTheSamePicture) {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=16"));
  const Scene scene = make_scene(volume, load_preset("onion"));
  const Camera camera = whole_volume_camera(volume->grid, 1);
  gl::RenderTarget target({24, 24}, false);
  std::vector<glm::vec4> pictures[2];
  for (auto& pixels : pictures) {
    Raycaster started(std::make_shared<Resources>(fs::path(), folder));
    started.draw(scene, camera, target);
    pixels = target.read_color().pixels;
  }
  EXPECT_EQ(files().size(), 1u);
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(ProgramFiles, ADamagedFileIsCompiledAgain) {
  EXPECT_EQ(compiled(), 1);
  const fs::path file = files().at(0);
  std::string content = read_file(file, 1 << 24);
  content[content.size() / 2] ^= 1;
  std::ofstream(file, std::ios::binary) << content;
  EXPECT_EQ(compiled(), 1);
  EXPECT_EQ(compiled(), 0);
  fs::resize_file(file, 3);
  EXPECT_EQ(compiled(), 1);
}

// As after a change of the driver that its version does not tell.
TEST_F(ProgramFiles, WhatTheDriverDoesNotTakeIsCompiledAgain) {
  EXPECT_EQ(compiled(), 1);
  const fs::path file = files().at(0);
  std::string content = *read_cached(file, 1 << 30);
  content.resize(sizeof(GLenum));  // the format alone
  write_cached(file, content + std::string(1000, 'x'), gl::program_files_bytes);
  EXPECT_EQ(compiled(), 1);
  EXPECT_EQ(compiled(), 0);
}

TEST_F(ProgramFiles, ThoseThatWereUsedLongestAgoAreLetGo) {
  constexpr int most = int(gl::ProgramCache::most_programs);
  gl::ProgramCache programs({}, folder);
  const auto variant = [&](int i) {
    return programs.program("fullscreen.vert", "present.frag", {"VARIANT " + std::to_string(i)});
  };
  const GLuint first = variant(0), second = variant(1);
  for (int i = 2; i < most; ++i) variant(i);
  EXPECT_EQ(variant(0), first) << "all have room";
  EXPECT_EQ(programs.compiled(), most);
  variant(most);
  EXPECT_EQ(programs.count(), std::size_t(most));
  EXPECT_EQ(variant(0), first) << "it was used again";
  EXPECT_FALSE(glIsProgram(second));
  EXPECT_NE(variant(1), 0u);
  EXPECT_EQ(programs.compiled(), most + 1) << "it is read, not compiled";
}

TEST_F(ProgramFiles, AFolderThatCannotBeWrittenIsNoError) {
  std::ofstream(folder / "file") << "no folder";
  folder /= "file";
  EXPECT_EQ(compiled(), 1);
  EXPECT_EQ(compiled(), 1);
  folder = folder.parent_path();
}

}  // namespace
}  // namespace crest::testing
