#include "render/raycaster/raycaster.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>

#include "presets/error.h"
#include "render/camera.h"
#include "render/gl/program.h"
#include "render/raycaster/table_textures.h"
#include "render/raycaster/volume_texture.h"
#include "render/volume/clip.h"

namespace crest {
namespace {

/// Some drivers (Mesa's llvmpipe) end all loops of one invocation together after 65,535 rounds, in silence.
constexpr int most_loop_rounds = 60000;

enum Unit : GLuint { volume_unit, empty_cells_unit, tf_unit, peak_table_unit, peak_runs_unit };

void set(GLuint program, const char* name, float x) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), x);
}
void set(GLuint program, const char* name, glm::vec2 v) {
  glProgramUniform2f(program, glGetUniformLocation(program, name), v.x, v.y);
}
void set(GLuint program, const char* name, glm::vec3 v) {
  glProgramUniform3f(program, glGetUniformLocation(program, name), v.x, v.y, v.z);
}
void set(GLuint program, const char* name, int i) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), i);
}

/// Intervals of the longest ray: its segments, and for peaks one more at each end of each span.
int most_intervals(const Scene& scene) {
  const Grid& grid = scene.volume->grid;
  const double diagonal = glm::length(grid.box_size()) / grid.smallest_spacing();
  const int spans = scene.volume->has_empty_cells() ? grid.dims.x + grid.dims.y + grid.dims.z : 1;
  return int(std::min(std::ceil(diagonal / scene.rendering.step) + 2.0 * spans, 2e9));
}

int intervals_per_pass(const Features& features, const Classification& classification, const Grid& grid) {
  const int walk = features.empty_cells ? 2 * (grid.dims.x + grid.dims.y + grid.dims.z) : 0;
  const int candidates =
      features.peak_table ? classification.table.largest_count() : most_peaks_without_table;
  // A step may be two parts; a crossing in one takes a round, and two for its root
  const int rounds = features.peaks ? 4 + 6 * candidates : 1;
  return std::max(1, (most_loop_rounds - walk) / rounds);
}

void set_view(GLuint program, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const Grid& grid = scene.volume->grid;
  const double unit = grid.smallest_spacing();
  const RayFrame rays = ray_frame(camera, grid, size);
  const glm::dvec3 cell_size = grid.spacing / unit;
  set(program, "image_size", glm::vec2(size));
  set(program, "box_size", glm::vec3(grid.box_size() / unit));
  const Box rendered = rendered_box(grid, scene.rendering.clip_box);
  set(program, "rendered_min", glm::vec3((rendered.min - grid.origin) / unit));
  set(program, "rendered_max", glm::vec3((rendered.max - grid.origin) / unit));
  set(program, "cell_size", glm::vec3(cell_size));
  set(program, "texture_scale", glm::vec3(1.0 / (cell_size * glm::dvec3(grid.dims))));
  set(program, "texture_offset", glm::vec3(0.5 / glm::dvec3(grid.dims)));
  set(program, "ray_anchor", glm::vec3(rays.anchor));
  set(program, "ray_anchor_u", glm::vec3(rays.anchor_u));
  set(program, "ray_anchor_v", glm::vec3(rays.anchor_v));
  set(program, "ray_w", glm::vec3(rays.w));
  set(program, "ray_u", glm::vec3(rays.u));
  set(program, "ray_v", glm::vec3(rays.v));
  set(program, "eye_to_anchor", float(rays.eye_to_anchor));
  set(program, "step_length", float(scene.rendering.step));
  set(program, "least_residual", float(scene.rendering.early_termination));
}

void set_few_peaks(GLuint program, const std::vector<Peak>& peaks) {
  glm::vec4 values(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < peaks.size(); ++i) values[int(i)] = float(peaks[i].value);
  glProgramUniform4f(program, glGetUniformLocation(program, "few_peaks"), values.x, values.y, values.z,
                     values.w);
  set(program, "peak_count", int(peaks.size()));
}

}  // namespace

struct Raycaster::State {
  std::filesystem::path shader_folder;
  gl::VertexArrayHandle vertex_array;

  std::shared_ptr<const Volume> volume;
  StoredUnits units;  ///< of the volume's texture, and so of every value that a shader is given
  VolumeTexture volume_texture;

  std::optional<Classification> classification;
  std::optional<TfTexture> full_tf, base_tf;
  PeakTableTextures peak_table;
  gl::BufferHandle peaks;

  struct Variant {
    gl::ProgramHandle program;
    bool current = false;  ///< false after reload_shaders, until it was compiled again
  };
  std::map<std::vector<std::string>, Variant> variants;
  std::string shader_error;
  int most_intervals_per_pass = 0;

  void take_volume(const Scene& scene);
  void take_classification(const Scene& scene);
  const gl::ProgramHandle& program(const Features& features);
  void bind(const Scene& scene, const Features& features, GLuint program);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
            const std::function<void(int pass)>& after_pass);
};

void Raycaster::State::take_volume(const Scene& scene) {
  if (volume == scene.volume) return;
  classification.reset();
  volume.reset();
  volume_texture = {};  // the old one's room first
  units = stored_units(scene.volume->statistics.range);
  volume_texture = upload_volume(*scene.volume, units);
  volume = scene.volume;
}

void Raycaster::State::take_classification(const Scene& scene) {
  take_volume(scene);
  const int bins = scene.rendering.peak_bins;
  if (classification && classification->tf == scene.tf && classification->table.bins == bins) return;
  classification = classify(scene.tf, scene.volume->statistics.range, bins);
  full_tf.reset();
  base_tf.reset();
  peak_table = {};
  peaks = {};
}

const gl::ProgramHandle& Raycaster::State::program(const Features& features) {
  Variant& variant = variants[shader_defines(features)];
  if (!variant.current) {
    try {
      variant.program =
          gl::build_fullscreen_program("raycaster.frag", shader_defines(features), shader_folder);
    } catch (const Error& error) {
      if (!variant.program) throw;
      shader_error = error.what();
    }
    variant.current = true;
  }
  return variant.program;
}

void Raycaster::State::bind(const Scene& scene, const Features& features, GLuint program) {
  glBindTextureUnit(volume_unit, volume_texture.values.id());
  set(program, "volume", int(volume_unit));
  if (features.empty_cells) {
    glBindTextureUnit(empty_cells_unit, volume_texture.empty_cells.id());
    set(program, "empty_cells", int(empty_cells_unit));
  }
  if (features.dvr) {
    auto& tf = features.base_tf ? base_tf : full_tf;
    if (!tf)
      tf = upload_tf(
          units.stored(features.base_tf ? base_transfer_function(scene.tf, classification->peaks) : scene.tf),
          units.stored(volume->statistics.range), volume->grid.smallest_spacing());
    glBindTextureUnit(tf_unit, tf->texture.id());
    set(program, "tf_texture", int(tf_unit));
    // The centres of the first and the last entry are the range's ends
    const double scale = (tf_entries - 1.0) / tf_entries / tf->range.width();
    set(program, "tf_min_scale_offset", glm::vec3(tf->range.min, scale, 0.5 / tf_entries));
  }
  if (features.peaks) {
    const std::vector<Peak> surfaces = units.stored(classification->surfaces);
    if (!peaks) peaks = upload_peaks(surfaces);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, peaks.id());
    set(program, "max_peaks", scene.rendering.max_peaks);
    if (!features.peak_table) set_few_peaks(program, surfaces);
  }
  if (features.peak_table) {
    const PeakTable& table = classification->table;
    if (!peak_table.runs) peak_table = upload_peak_table(table, units.stored(classification->surfaces));
    glBindTextureUnit(peak_table_unit, peak_table.ranges.id());
    set(program, "peak_table", int(peak_table_unit));
    glBindTextureUnit(peak_runs_unit, peak_table.runs.id());
    set(program, "peak_runs", int(peak_runs_unit));
    set(program, "bin_min_scale", glm::vec2(units.stored(table.range.min), table.bin_scale() / units.scale));
  }
}

Raycaster::Raycaster(std::filesystem::path shader_folder) : state_(std::make_unique<State>()) {
  state_->shader_folder = std::move(shader_folder);
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  state_->vertex_array = gl::VertexArrayHandle(id);
}
Raycaster::~Raycaster() = default;
Raycaster::Raycaster(Raycaster&&) noexcept = default;

const Classification& Raycaster::classification(const Scene& scene) {
  state_->take_classification(scene);
  return *state_->classification;
}

Features Raycaster::features(const Scene& scene, bool statistics) {
  return needed_features(*scene.volume, classification(scene), scene.rendering, statistics);
}

void Raycaster::State::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
                            const std::function<void(int pass)>& after_pass) {
  take_classification(scene);
  const Features features =
      needed_features(*scene.volume, *classification, scene.rendering, target.has_counts());
  const GLuint id = program(features).id();
  bind(scene, features, id);
  set_view(id, scene, camera, target.size());

  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  glViewport(0, 0, target.size().x, target.size().y);
  glScissor(tile.begin.x, tile.begin.y, tile.end.x - tile.begin.x, tile.end.y - tile.begin.y);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);  // a later pass lies behind
  glBindVertexArray(vertex_array.id());
  glUseProgram(id);

  const int allowed = intervals_per_pass(features, *classification, scene.volume->grid);
  const int per_pass = most_intervals_per_pass > 0 ? std::min(most_intervals_per_pass, allowed) : allowed;
  const int total = most_intervals(scene);
  for (int pass = 0; pass * std::int64_t(per_pass) < total; ++pass) {
    set(id, "first_interval", pass * per_pass);
    set(id, "interval_count", per_pass);
    if (pass == 1) glEnablei(GL_BLEND, 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (after_pass) after_pass(pass);
  }
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

void Raycaster::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  state_->draw(scene, camera, target, tile, {});
}

void Raycaster::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  draw(scene, camera, target, Tile{{0, 0}, target.size()});
}

std::vector<PixelCounts> Raycaster::draw_counts(const Scene& scene, const Camera& camera,
                                                gl::RenderTarget& target) {
  std::vector<PixelCounts> sums(std::size_t(target.size().x) * std::size_t(target.size().y));
  state_->draw(scene, camera, target, Tile{{0, 0}, target.size()}, [&](int) {
    const auto counts = target.read_counts();
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].samples += counts[i].x;
      sums[i].dvr_samples += counts[i].y;
      sums[i].crossings += counts[i].z;
      sums[i].crossings_left_out += counts[i].w & 0x7fffffffu;
      sums[i].hit = counts[i].w >> 31;
    }
  });
  return sums;
}

RenderCounts Raycaster::draw_counted(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  RenderCounts total;
  for (const PixelCounts& pixel : draw_counts(scene, camera, target)) {
    total.pixels += 1;
    total.hit_pixels += pixel.hit;
    total.samples += pixel.samples;
    total.dvr_samples += pixel.dvr_samples;
    total.crossings += pixel.crossings;
    total.crossings_left_out += pixel.crossings_left_out;
  }
  return total;
}

void Raycaster::set_most_intervals_per_pass(int intervals) { state_->most_intervals_per_pass = intervals; }

void Raycaster::reload_shaders() {
  state_->shader_error.clear();
  for (auto& [defines, variant] : state_->variants) variant.current = false;
}

const std::string& Raycaster::shader_error() const { return state_->shader_error; }

}  // namespace crest
