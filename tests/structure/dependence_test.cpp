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

// The CPU side of render needs no GL: it is what the tables and the tests build on.
TEST(Dependence, VolumesTablesAndTheReferenceNeedNoGl) {
  for (const std::string folder : {"render/volume", "render/classify", "render/reference"})
    for (const Include& include : includes_below(folder)) {
      EXPECT_FALSE(starts_with_any(include.target, {"epoxy/", "render/gl/", "render/raycaster/"}))
          << include.file << " includes " << include.target;
    }
}

}  // namespace
