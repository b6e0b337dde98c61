#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/paths.h"

namespace {

namespace fs = std::filesystem;

const std::array<std::string, 4> layers{"presets", "render", "ui", "app"};  // each may use those before it

struct Include {
  std::string file, target;  ///< below the source folder; as written
};

std::vector<Include> includes_below(const std::string& folder) {
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(crest::test::source_folder() / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".h") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (!line.starts_with("#include ")) continue;
      found.push_back({entry.path().lexically_relative(crest::test::source_folder()).string(),
                       line.substr(10, line.size() - 11)});
    }
  }
  return found;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& prefixes) {
  return std::ranges::any_of(prefixes, [&](const std::string& p) { return text.starts_with(p); });
}

// presets <- render <- ui <- app, and nothing points the other way.
TEST(Dependence, RunsInOneDirection) {
  std::size_t seen = 0;
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
    for (const Include& include : includes_below(layers[layer]))
      for (std::size_t other = 0; other < layers.size(); ++other)
        if (include.target.starts_with(layers[other] + "/")) {
          ++seen;
          EXPECT_LE(other, layer) << include.file << " includes " << include.target;
        }
  EXPECT_GT(seen, 100u);  // the test sees the includes at all
}

TEST(Dependence, NoGraphicsWhereItDoesNotBelong) {
  const std::vector<std::string> gl{"epoxy/", "GL/", "GLFW/"}, gui{"imgui", "backends/imgui", "GLFW/"};
  for (const std::string folder : {"presets", "ui"})
    for (const Include& include : includes_below(folder))
      EXPECT_FALSE(starts_with_any(include.target, gl)) << include.file << " includes " << include.target;
  for (const std::string folder : {"presets", "render"})
    for (const Include& include : includes_below(folder))
      EXPECT_FALSE(starts_with_any(include.target, gui)) << include.file << " includes " << include.target;
}

/// The folders of render: each may use those before it. What lies in render itself joins both engines.
const std::vector<std::string> render_folders{
    "volume",        "classify",  "files",     "readers", "reader", "scene", "reference", "gl",
    "shader_inputs", "resources", "raycaster", "vdls",    "slices", "",      "measure",   "studies"};

/// Which of them a path lies in: render/studies/knoll/lab.h in "studies", render/renderer.h in "".
std::string folder_of(const std::string& path) {
  const std::string below = path.substr(std::string("render/").size());
  return below.substr(0, below.find('/') == below.npos ? 0 : below.find('/'));
}

TEST(Dependence, RunsInOneDirectionWithinRender) {
  const auto rank = [](const std::string& folder) {
    const auto found = std::ranges::find(render_folders, folder);
    EXPECT_NE(found, render_folders.end()) << "render/" << folder << " has no place in the order";
    return found - render_folders.begin();
  };
  std::size_t seen = 0;
  for (const Include& include : includes_below("render")) {
    if (!include.target.starts_with("render/")) continue;
    ++seen;
    const std::string from = folder_of(include.file), to = folder_of(include.target);
    EXPECT_LE(rank(to), rank(from)) << include.file << " includes " << include.target;
    EXPECT_FALSE(from == "vdls" && to == "raycaster") << "an engine uses the other: " << include.file;
  }
  EXPECT_GT(seen, 300u);
}

// The CPU side of render needs no GL: it is what the tables and the tests build on.
TEST(Dependence, VolumesTablesAndTheReferenceNeedNoGl) {
  for (const std::string folder : {"volume", "classify", "files", "readers", "reader", "scene", "reference"})
    for (const Include& include : includes_below("render/" + folder))
      EXPECT_FALSE(include.target.starts_with("epoxy/")) << include.file << " includes " << include.target;
}

}  // namespace
