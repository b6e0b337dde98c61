#include "app/editor_image.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/offscreen_context.h"
#include "presets/error.h"

namespace crest {
namespace {

/// A red plateau from 0 to 1 that ends in a green flank.
Document plateau() {
  Document document;
  for (const auto& [value, opacity, color] : {std::tuple(0.0, 0.5, glm::dvec3(1, 0, 0)),
                                              {0.5, 0.5, glm::dvec3(1, 0, 0)},
                                              {0.5, 0.5, glm::dvec3(0, 1, 0)},
                                              {1.0, 0.5, glm::dvec3(0, 1, 0)}}) {
    ControlPoint point;
    point.value = value;
    point.opacity = opacity;
    point.color = color;
    document.preset.transfer_function.points.push_back(point);
  }
  return document;
}

bool is_reddish(glm::vec4 c) { return c.r > 0.3F && c.r > 2 * c.g; }
bool is_greenish(glm::vec4 c) { return c.g > 0.3F && c.g > 2 * c.r; }

// Colours lie below the curve, where their values are, the first row at the top; whatever the size.
TEST(EditorImage, ShowsTheCurveInItsColours) {
  const OffscreenContext context;
  for (const glm::ivec2 size : {glm::ivec2(640, 360), {1501, 700}}) {
    const Image image = editor_image(plateau(), {}, {}, size);
    ASSERT_EQ(image.size, size);
    const auto at = [&](double x, double y) { return image.at(int(x * size.x), int(y * size.y)); };
    EXPECT_TRUE(is_reddish(at(0.35, 0.75))) << size.x;
    EXPECT_TRUE(is_greenish(at(0.75, 0.75))) << size.x;
    for (const double x : {0.35, 0.75}) {
      EXPECT_FALSE(is_reddish(at(x, 0.25)) || is_greenish(at(x, 0.25))) << "above the curve is nothing";
    }
    for (const glm::vec4& pixel : image.pixels) ASSERT_EQ(pixel.a, 1);
  }
}

TEST(EditorImage, HasNothingThatIsSelected) {
  const OffscreenContext context;
  EditorState selected;
  selected.selection = {1, 2};
  const Image with = editor_image(plateau(), selected, {}, {400, 200}),
              without = editor_image(plateau(), {}, {}, {400, 200});
  EXPECT_EQ(with.pixels, without.pixels);
}

TEST(EditorImage, TakesAnySizeThatAPictureHas) {
  const OffscreenContext context;
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {3, 200}, {900, 2}})
    EXPECT_EQ(editor_image(plateau(), {}, {}, size).size, size);
  EXPECT_EQ(editor_image({}, {}, {}, {50, 50}).size, glm::ivec2(50)) << "no points";
  EXPECT_THROW(editor_image(plateau(), {}, {}, {20000, 10}), Error);
}

// The window's own Dear ImGui goes on with its frame.
TEST(EditorImage, LeavesTheWindowsContext) {
  const OffscreenContext context;
  ImGuiContext* window = ImGui::CreateContext();
  ImGui::GetIO().DisplaySize = {100, 100};
  ImGui::GetIO().Fonts->Build();
  ImGui::NewFrame();
  editor_image(plateau(), {}, {}, {64, 64});
  EXPECT_EQ(ImGui::GetCurrentContext(), window);
  ImGui::Render();
  EXPECT_TRUE(ImGui::GetDrawData()->Valid);
  ImGui::DestroyContext(window);
}

}  // namespace
}  // namespace crest
