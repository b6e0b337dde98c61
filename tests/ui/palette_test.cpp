#include "ui/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "ui/style.h"

namespace crest::test {
namespace {

glm::dvec3 rgb_of(ImU32 color) {
  return glm::dvec3(color & 0xFF, color >> 8 & 0xFF, color >> 16 & 0xFF) / 255.0;
}

double linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// Relative luminance, as WCAG 2.1 defines it.
double luminance(glm::dvec3 c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); }

/// WCAG 2.1, from 1 to 21.
double contrast(glm::dvec3 a, glm::dvec3 b) {
  const double least = std::min(luminance(a), luminance(b)), most = std::max(luminance(a), luminance(b));
  return (most + 0.05) / (least + 0.05);
}

/// A ground that lets something through, over black and over white.
double least_contrast(ImU32 text, ImU32 ground) {
  const double alpha = double(ground >> 24) / 255;
  double least = 21;
  for (const double behind : {0.0, 1.0})
    least = std::min(least, contrast(rgb_of(text), glm::mix(glm::dvec3(behind), rgb_of(ground), alpha)));
  return least;
}

TEST(ThemeColors, TheContrastIsThatOfWcag) {
  EXPECT_NEAR(contrast(glm::dvec3(1), glm::dvec3(0)), 21, 1e-9);
  // The grey that is often quoted as the lightest one on white that suffices
  EXPECT_NEAR(contrast(rgb_of(IM_COL32(0x76, 0x76, 0x76, 255)), glm::dvec3(1)), 4.54, 0.01);
}

TEST(ThemeColors, EveryTextCanBeReadOnItsGround) {
  for (const Theme theme : {Theme::dark, Theme::light})
    for (const TextOnGround& pair : texts_on_grounds(palette_of(theme)))
      EXPECT_GE(least_contrast(pair.text_color, pair.ground_color), 4.5)
          << pair.text << " on " << pair.ground << (theme == Theme::dark ? ", dark" : ", light");
}

TEST(ThemeColors, IsOfTheThemeThatWasApplied) {
  ImGui::CreateContext();
  for (const Theme theme : {Theme::light, Theme::dark}) {
    apply_style(1, theme);
    EXPECT_EQ(&palette(), &palette_of(theme));
    const ImVec4* colors = ImGui::GetStyle().Colors;
    EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(colors[ImGuiCol_TextDisabled]), palette_of(theme).secondary);
  }
  ImGui::DestroyContext();
}

TEST(ThemeColors, NoTextIsSmallerThan13PixelsAndTitlesAreLarger) {
  ImGui::CreateContext();
  apply_style(1);
  ImGui::GetIO().Fonts->Build();
  EXPECT_GE(font_of(TextSize::body)->FontSize, 13);
  EXPECT_GT(font_of(TextSize::heading)->FontSize, font_of(TextSize::body)->FontSize);
  EXPECT_GT(font_of(TextSize::title)->FontSize, font_of(TextSize::heading)->FontSize);
  apply_style(2);
  ImGui::GetIO().Fonts->Build();
  EXPECT_EQ(font_of(TextSize::body)->FontSize, 2 * pixels_of(TextSize::body));
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace crest::test
