#include "render/resources/table_textures.h"

#include <glm/vec4.hpp>
#include <limits>

#include "render/gl/errors.h"
#include "render/gl/texture.h"
#include "render/gl/uniforms.h"

namespace crest {
namespace {

/// A row of RGBA32F texels.
gl::TextureHandle upload_row(const void* texels, std::size_t count, GLint filter) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_1D, filter);
  glTextureStorage1D(texture.id(), 1, GL_RGBA32F, GLsizei(count));
  glTextureSubImage1D(texture.id(), 0, 0, GLsizei(count), GL_RGBA, GL_FLOAT, texels);
  gl::require_no_error("making room for a table");
  return texture;
}

struct TfKey {
  TransferFunction tf;
  ValueRange field;
  double smallest_spacing;
  int entries;
  bool operator==(const TfKey&) const = default;
};

struct PeakTableKey {
  std::vector<Peak> surfaces;
  ValueRange field;
  int bins;
  bool operator==(const PeakTableKey&) const = default;
};

struct PeaksKey {
  std::vector<Peak> peaks;
  bool operator==(const PeaksKey&) const = default;
};

TfTexture upload_tf(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries) {
  const TfTable table = build_tf_table(tf, field, smallest_spacing, entries);
  return {upload_row(table.entries.data(), table.entries.size(), GL_LINEAR), table.range, entries};
}

PeakTableTexture upload_peak_table(const PeakTable& table, const std::vector<Peak>& peaks) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const int first_inside = table.first_peak_from.front(), past_inside = table.past_peak_to.back();
  std::vector<glm::vec4> texels;
  for (std::size_t bin = 0; bin < std::size_t(table.bins); ++bin) {
    const int first = table.first_peak_from[bin], past = table.past_peak_to[bin];
    texels.emplace_back(first < past_inside ? float(peaks[std::size_t(first)].value) : infinity,
                        past > first_inside ? float(peaks[std::size_t(past - 1)].value) : -infinity, first,
                        past);
  }
  return {upload_row(texels.data(), texels.size(), GL_NEAREST), table.range, table.bins, table.bin_scale()};
}

gl::BufferHandle upload_peaks(const std::vector<Peak>& peaks) {
  struct GpuPeak {  // std430 layout of the shader's Peak
    glm::vec4 color_opacity;
    float value, padding[3];
  };
  std::vector<GpuPeak> list;
  list.reserve(peaks.size());
  if (peaks.empty()) list.push_back({glm::vec4(0), std::numeric_limits<float>::infinity(), {}});
  for (const Peak& peak : peaks)
    list.push_back({glm::vec4(peak.color, float(peak.opacity)), float(peak.value), {}});
  GLuint id = 0;
  glCreateBuffers(1, &id);
  glNamedBufferStorage(id, GLsizeiptr(list.size() * sizeof(GpuPeak)), list.data(), 0);
  gl::BufferHandle buffer(id);
  gl::require_no_error("making room for the peaks");
  return buffer;
}

}  // namespace

const TfTexture& tf_texture(KeyedCache& held, const TransferFunction& tf, ValueRange field,
                            double smallest_spacing, int entries) {
  return held.get(TfKey{tf, field, smallest_spacing, entries}, std::size_t(entries) * sizeof(glm::vec4),
                  [&] { return upload_tf(tf, field, smallest_spacing, entries); });
}

void bind_tf_texture(GLuint program, const TfTexture& tf, GLuint unit) {
  glBindTextureUnit(unit, tf.texture.id());
  gl::set(program, "tf_texture", int(unit));
  // The centres of the first and the last entry are the range's ends
  const double scale = (tf.entries - 1.0) / tf.entries / tf.range.width();
  gl::set(program, "tf_min_scale_offset", glm::vec3(tf.range.min, scale, 0.5 / tf.entries));
}

const PeakTableTexture& peak_table_texture(KeyedCache& held, const std::vector<Peak>& surfaces,
                                           ValueRange field, int bins) {
  return held.get(PeakTableKey{surfaces, field, bins}, std::size_t(bins) * sizeof(glm::vec4),
                  [&] { return upload_peak_table(build_peak_table(surfaces, field, bins), surfaces); });
}

GLuint peak_buffer(KeyedCache& held, const std::vector<Peak>& peaks) {
  return held.get(PeaksKey{peaks}, peaks.size() * 8 * sizeof(float), [&] { return upload_peaks(peaks); })
      .id();
}

}  // namespace crest
