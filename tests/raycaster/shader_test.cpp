#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/gl/shader_source.h"
#include "render/volume/builtin.h"
#include "tests/paths.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

namespace fs = std::filesystem;

class Shaders : public RaycasterTest {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("crest-shaders-" + std::to_string(::getpid()));
    fs::copy(test::source_folder() / "render/shaders", folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  void append(const char* file, const char* text) { std::ofstream(folder / file, std::ios::app) << text; }

  fs::path folder;
  Scene scene =
      make_scene(std::make_shared<const Volume>(make_builtin("sphere?n=16")), load_preset("dirac-shell"));
};

// A shader that no longer compiles keeps the last good program, and says which line of which file is wrong.
TEST_F(Shaders, FailedReloadKeepsTheLastGoodProgram) {
  Raycaster from_folder(folder);
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  gl::RenderTarget target({16, 16}, false);
  from_folder.draw(scene, camera, target);
  const Image good = target.read_color();
  int lines = 0;
  std::ifstream file(folder / "compositing.glsl");
  for (std::string line; std::getline(file, line);) ++lines;
  append("compositing.glsl", "float wrong = nothing_like_this;\n");
  from_folder.resources().programs.reload();
  from_folder.draw(scene, camera, target);
  EXPECT_EQ(target.read_color().pixels, good.pixels);
  EXPECT_NE(from_folder.resources().programs.error().find("compositing.glsl:" + std::to_string(lines + 1)),
            std::string::npos)
      << from_folder.resources().programs.error();
  fs::copy_file(test::source_folder() / "render/shaders/compositing.glsl", folder / "compositing.glsl",
                fs::copy_options::overwrite_existing);
  from_folder.resources().programs.reload();
  from_folder.draw(scene, camera, target);
  EXPECT_EQ(from_folder.resources().programs.error(), "");
}

TEST_F(Shaders, FirstFailureIsAnError) {
  append("field.glsl", "}\n");
  Raycaster from_folder(folder);
  gl::RenderTarget target({16, 16}, false);
  EXPECT_THROW(from_folder.draw(scene, whole_volume_camera(scene.volume->grid, 1), target), Error);
}

TEST(ShaderLog, NamesFilesForEveryDriver) {
  const std::vector<std::string> files{"a.frag", "b.glsl"};
  EXPECT_EQ(gl::name_files_in_log("0:10012(3): error: x", files), "b.glsl:12(3): error: x\n");  // Mesa
  EXPECT_EQ(gl::name_files_in_log("0(7) : error C1: x", files), "a.frag:7 : error C1: x\n");    // NVIDIA
  EXPECT_EQ(gl::name_files_in_log("ERROR: 0:10005: 'x'", files), "ERROR: b.glsl:5: 'x'\n");     // AMD
  EXPECT_EQ(gl::name_files_in_log("no place here", files), "no place here\n");
}

}  // namespace
}  // namespace crest::testing
