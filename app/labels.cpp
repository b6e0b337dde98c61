#include "app/labels.h"

#include <imgui.h>

namespace crest {
namespace {

void blend(Image& image, int x, int y, float opacity, float brightness) {
  if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) return;
  glm::vec4& pixel = image.at(x, y);
  pixel = glm::vec4(glm::vec3(brightness * opacity), opacity) + (1 - opacity) * pixel;
}

void fill(Image& image, int x, int y, int width, int height, float opacity, float brightness) {
  for (int row = y; row < y + height; ++row)
    for (int column = x; column < x + width; ++column) blend(image, column, row, opacity, brightness);
}

}  // namespace

void draw_label(Image& image, int x, int y, std::string_view text, int scale) {
  ImFontAtlas atlas;  // Dear ImGui's font needs no file and no window
  const ImFont* font = atlas.AddFontDefault();
  unsigned char* alpha = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&alpha, &width, &height);

  float text_width = 0;
  for (const char c : text) text_width += font->FindGlyph(ImWchar(c))->AdvanceX;
  fill(image, x, y, (int(text_width) + 8) * scale, (int(font->FontSize) + 5) * scale, 0.6f, 0.f);

  float pen = 4;
  for (const char c : text) {
    const ImFontGlyph& glyph = *font->FindGlyph(ImWchar(c));
    const int u0 = int(glyph.U0 * float(width) + 0.5f), v0 = int(glyph.V0 * float(height) + 0.5f);
    const int columns = int(glyph.X1 - glyph.X0), rows = int(glyph.Y1 - glyph.Y0);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const float opacity = float(alpha[(v0 + row) * width + u0 + column]) / 255.f;
        const int left = x + (int(pen + glyph.X0) + column) * scale,
                  top = y + (int(2 + glyph.Y0) + row) * scale;
        if (opacity > 0) fill(image, left, top, scale, scale, opacity, 1.f);
      }
    pen += glyph.AdvanceX;
  }
}

}  // namespace crest
