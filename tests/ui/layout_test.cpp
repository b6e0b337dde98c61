#include <string>
#include <vector>

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

struct Size {
  const char* name;
  ImVec2 pixels;
  float scale;
};
void PrintTo(const Size& size, std::ostream* out) { *out << size.name; }

const Size sizes[] = {{"small", {1024, 700}, 1}, {"large", {3840, 2160}, 2}};

constexpr const char* tab_names[] = {"Peaks", "Points", "Rendering", "Accuracy", "Slices", "Ray", "History"};

/// What lies on something else by design: marks on a plot, a row behind its fields, a line of text that is
/// noted for tests.
bool lies_on_others(std::string_view name) {
  for (const std::string_view mark : {"point/", "span/", "suggestion/", "measured/", "measure/"})
    if (name.starts_with(mark)) return true;
  if (name.starts_with("peak") && name.find_first_not_of("0123456789", 4) == name.npos) return true;
  return name.find(": ") != name.npos;
}

class Layout : public Studio, public ::testing::WithParamInterface<Size> {
 protected:
  Layout() {
    apply_style(GetParam().scale, Theme::light);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::GetIO().DisplaySize = GetParam().pixels;
    state->editor.selection = {1};
    for (ViewPicture& view : inputs.views) view.warnings = {"It shows nothing."};
    frames(5);
  }

  using Rect = std::pair<ImVec2, ImVec2>;
  using Items = std::vector<std::pair<std::string, Rect>>;

  Items items_but(const ItemRects& others) const {
    Items items;
    for (const auto& item : state->widgets.items)
      if (!others.contains(item.first) && !lies_on_others(item.first)) items.push_back(item);
    return items;
  }

  /// `scrolls`: what is too low can be scrolled to.
  void expect_inside(const Items& items, bool scrolls) const {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    for (const auto& [name, rect] : items) {
      EXPECT_GE(rect.first.x, 0) << name;
      EXPECT_LE(rect.second.x, window.x) << name;
      EXPECT_GE(rect.first.y, 0) << name;
      if (!scrolls) {
        EXPECT_LE(rect.second.y, window.y) << name;
      }
    }
  }

  void expect_apart(const Items& items) const {
    for (std::size_t i = 0; i < items.size(); ++i)
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        const auto& [a_low, a_high] = items[i].second;
        const auto& [b_low, b_high] = items[j].second;
        const bool apart = a_high.x <= b_low.x + 1 || b_high.x <= a_low.x + 1 || a_high.y <= b_low.y + 1 ||
                           b_high.y <= a_low.y + 1;
        EXPECT_TRUE(apart) << items[i].first << " and " << items[j].first;
      }
  }
};

TEST_P(Layout, EachTabIsInsideAndNothingOverlaps) {
  for (const char* name : tab_names) {
    SCOPED_TRACE(name);
    click(std::string("tab/") + name);
    frames(3);
    const bool scrolls = std::string_view("Rendering Accuracy Points").find(name) != std::string_view::npos;
    expect_inside(items_but({}), scrolls);
    expect_apart(items_but({}));
  }
}

TEST_P(Layout, TheEditorAndTheCaptionsAreWhole) {
  // Nothing may be cut by the part of the window that it is in
  const auto& [plot_low, plot_high] = state->widgets.items["plot"];
  for (const char* name :
       {"add peak", "##peak width", "shapes", "points", "##histogram", "log opacity", "fit", "##color",
        "##value", "##opacity", "##surface", "##unit distance", "##unit"}) {
    ASSERT_TRUE(has(name)) << name;
    EXPECT_LE(state->widgets.items[name].second.x, GetParam().pixels.x - 8) << name;
  }
  for (int i = 0; i < view_count; ++i) {
    const auto& [low, high] = state->widgets.items["view" + std::to_string(i)];
    for (const char* part : {"content", "compare", "enlarge", "warning"}) {
      const auto& [part_low, part_high] = state->widgets.items[part + std::to_string(i)];
      EXPECT_GE(part_low.x, low.x) << part << i;
      EXPECT_LE(part_high.x, high.x + 1) << part << i;
      EXPECT_LE(part_high.y, low.y) << part << i;
    }
  }
  const auto& [curve_low, curve_high] = state->widgets.items["##histogram"];
  EXPECT_GE(curve_high.x - curve_low.x, choice_width("values, log"));
  EXPECT_GE(curve_high.x - curve_low.x + ImGui::GetFrameHeight(), choice_width("visibility, log"))
      << "it fits without the arrow";
  EXPECT_GT(plot_high.x - plot_low.x, 300);
  EXPECT_GT(plot_high.y - plot_low.y, 120);
}

TEST_P(Layout, DialogsAreInsideAndNothingInThemOverlaps) {
  const ItemRects base = state->widgets.items;
  const auto check = [&](const char* name, auto&& open) {
    SCOPED_TRACE(name);
    open();
    frames(5);
    const Items items = items_but(base);
    EXPECT_FALSE(items.empty());
    expect_inside(items, false);
    expect_apart(items);
    key_of(ImGuiKey_Escape);
    frames(3);
  };
  check("export", [&] { ctrl('E'); });
  check("picture", [&] { ctrl('P'); });
  check("library", [&] { ctrl('L'); });
  check("help", [&] { state->show_help = true; });
  check("settings", [&] { state->settings_asked = true; });
  check("name and notes", [&] { state->details.asked = true; });
}

// Twice the scale, twice the sizes: nothing is tiny.
TEST_P(Layout, WhatIsClickedIsAsLargeAsTheScaleSays) {
  const float least = 16 * GetParam().scale;
  for (const char* name : {"add peak", "fit", "##value", "##unit", "menu/View", "content0", "tab/Peaks"}) {
    ASSERT_TRUE(has(name)) << name;
    const auto& [low, high] = state->widgets.items[name];
    EXPECT_GE(high.y - low.y, least) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Layout, ::testing::ValuesIn(sizes),
                         [](const auto& size) { return std::string(size.param.name); });

}  // namespace
}  // namespace crest::test
