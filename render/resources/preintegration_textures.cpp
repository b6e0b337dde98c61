#include "render/resources/preintegration_textures.h"

#include "render/gl/errors.h"
#include "render/gl/texture.h"

namespace crest {
namespace {

gl::TextureHandle upload_rgba(GLsizei width, GLsizei height, GLint filter, const void* data) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_2D, filter);
  glTextureStorage2D(texture.id(), 1, GL_RGBA32F, width, height);
  glTextureSubImage2D(texture.id(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, data);
  gl::require_no_error("making room for a table");
  return texture;
}

struct AntiderivativesKey {
  TransferFunction tf;
  ValueRange field;
  double smallest_spacing;
  int bins;
  bool operator==(const AntiderivativesKey&) const = default;
};

struct TableKey {
  TransferFunction tf;
  ValueRange field;
  double smallest_spacing, length;
  int bins;
  bool operator==(const TableKey&) const = default;
};

AntiderivativesTexture upload(const Antiderivatives& table) {
  static_assert(sizeof(Antiderivatives::Entry) == 4 * sizeof(glm::vec4));
  const auto entries = GLsizei(table.entries.size());
  return {upload_rgba(4, entries, GL_NEAREST, table.entries.data()), table.range, int(entries) - 2};
}

PreintegrationTexture upload(const PreintegrationTable& table) {
  return {upload_rgba(table.bins, table.bins, GL_LINEAR, table.entries.data()), table.range, table.length,
          table.bins};
}

}  // namespace

const AntiderivativesTexture& antiderivatives_texture(KeyedCache& held, const TransferFunction& tf,
                                                      ValueRange field, double smallest_spacing, int bins) {
  return held.get(AntiderivativesKey{tf, field, smallest_spacing, bins},
                  std::size_t(bins + 2) * sizeof(Antiderivatives::Entry),
                  [&] { return upload(build_antiderivatives(tf, field, smallest_spacing, bins)); });
}

const PreintegrationTexture& preintegration_texture(KeyedCache& held, const TransferFunction& tf,
                                                    ValueRange field, double smallest_spacing, double length,
                                                    int bins) {
  const auto make = [&] {
    return upload(build_preintegration_table(tf, field, smallest_spacing, length, bins));
  };
  return held.get(TableKey{tf, field, smallest_spacing, length, bins},
                  std::size_t(bins) * std::size_t(bins) * sizeof(glm::vec4), make);
}

}  // namespace crest
