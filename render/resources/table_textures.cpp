#include "render/resources/table_textures.h"

#include <glm/vec2.hpp>
#include <limits>

#include "render/gl/uniforms.h"

namespace crest {
namespace {

gl::TextureHandle upload_square(int side, GLenum internal_format, GLenum format, GLenum type,
                                const void* data) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  gl::TextureHandle texture(id);
  glTextureStorage2D(id, 1, internal_format, side, side);
  glTextureSubImage2D(id, 0, 0, 0, side, side, format, type, data);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
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
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_1D, 1, &id);
  TfTexture result{gl::TextureHandle(id), table.range, entries};
  const auto count = GLsizei(table.entries.size());
  glTextureStorage1D(id, 1, GL_RGBA32F, count);
  glTextureSubImage1D(id, 0, 0, count, GL_RGBA, GL_FLOAT, table.entries.data());
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  return result;
}

PeakTableTextures upload_peak_table(const PeakTable& table, const std::vector<Peak>& peaks) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<std::uint32_t> runs;
  std::vector<glm::vec2> ranges;
  runs.reserve(table.cells.size());
  ranges.reserve(table.cells.size());
  for (const auto& cell : table.cells) {
    runs.push_back(cell.first | std::uint32_t(cell.count) << 16);
    if (cell.count == 0)
      ranges.emplace_back(infinity, -infinity);
    else
      ranges.emplace_back(peaks[cell.first].value, peaks[std::size_t(cell.first + cell.count - 1)].value);
  }
  PeakTableTextures textures{table.bins, table.range, table.bin_scale(), {}, {}};
  textures.ranges = upload_square(table.bins, GL_RG32F, GL_RG, GL_FLOAT, ranges.data());
  textures.runs = upload_square(table.bins, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, runs.data());
  return textures;
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
  return gl::BufferHandle(id);
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

const PeakTableTextures& peak_table_textures(KeyedCache& held, const std::vector<Peak>& surfaces,
                                             ValueRange field, int bins) {
  return held.get(PeakTableKey{surfaces, field, bins},
                  std::size_t(bins) * std::size_t(bins) * 3 * sizeof(float),
                  [&] { return upload_peak_table(build_peak_table(surfaces, field, bins), surfaces); });
}

GLuint peak_buffer(KeyedCache& held, const std::vector<Peak>& peaks) {
  return held.get(PeaksKey{peaks}, peaks.size() * 8 * sizeof(float), [&] { return upload_peaks(peaks); })
      .id();
}

}  // namespace crest
