#include "render/raycaster/raycaster.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <optional>

#include "render/camera.h"
#include "render/gl/program_cache.h"
#include "render/gl/uniforms.h"
#include "render/raycaster/illumination.h"
#include "render/raycaster/macrocell_store.h"
#include "render/raycaster/preintegration_textures.h"
#include "render/raycaster/table_textures.h"
#include "render/raycaster/view_uniforms.h"
#include "render/raycaster/volume_texture.h"

namespace crest {
namespace {

using gl::set;

enum Unit : GLuint {
  volume_unit,
  empty_cells_unit,
  macrocells_unit,
  tf_unit,  ///< or what stands for the TF: antiderivatives, pre-integration table
  peak_table_unit,
  peak_runs_unit
};

void set_few_peaks(GLuint program, const std::vector<Peak>& peaks) {
  glm::vec4 values(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < peaks.size(); ++i) values[int(i)] = float(peaks[i].value);
  glProgramUniform4f(program, glGetUniformLocation(program, "few_peaks"), values.x, values.y, values.z,
                     values.w);
  set(program, "peak_count", int(peaks.size()));
}

void set_bc_weights(GLuint program, const Rendering& rendering) {
  const auto weights = filter_weights({Filter::bc, rendering.bc_b, rendering.bc_c});
  glm::mat4 by_power;  // column k: what multiplies u^k
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 4; ++i) by_power[k][i] = float(weights[std::size_t(i)][std::size_t(k)]);
  glProgramUniformMatrix4fv(program, glGetUniformLocation(program, "bc_weights"), 1, GL_FALSE,
                            &by_power[0][0]);
}

void clear(const gl::RenderTarget& target) {
  constexpr GLfloat transparent[4] = {};
  constexpr GLuint none[4] = {};
  glClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, transparent);
  if (target.has_counts()) glClearNamedFramebufferuiv(target.framebuffer(), GL_COLOR, 1, none);
}

/// What DVR looks a TF up in: only what was asked for.
struct DvrTables {
  std::optional<TfTexture> samples;
  std::optional<AntiderivativesTexture> antiderivatives;
  std::optional<PreintegrationTexture> preintegration;
};

/// What a TF is on the GPU: only what was asked for.
struct Tables {
  DvrTables full_tf, base_tf;
  std::optional<PeakTableTextures> peak_table;
  gl::BufferHandle peaks;
};

}  // namespace

struct Raycaster::State {
  explicit State(std::filesystem::path shader_folder) : programs(std::move(shader_folder)) {}

  gl::ProgramCache programs;
  gl::VertexArrayHandle vertex_array;

  std::shared_ptr<const Volume> volume;
  StoredUnits units;  ///< of the volume's texture, and so of every value that a shader is given
  gl::TextureHandle values, empty_cells;
  int empty_cells_radius = 0;  ///< of the filter that they are made for

  std::optional<Classification> classification;
  ValueRange dvr_range, surface_range;  ///< of the scene that is drawn
  Tables tables;
  MacrocellStore macrocells;
  Tables no_tables;  ///< of a TF that shows nothing, for what is forced in

  Forced forced;

  void take_volume(const Scene& scene);
  void take_classification(const Scene& scene);
  Need need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics);
  void bind(const Scene& scene, const Need& need, GLuint program);
  void bind_macrocells(const Scene& scene, const Need& need, GLuint program);
  void bind_tf(const Scene& scene, const Need& need, GLuint program);
  void bind_antiderivatives(const TransferFunction& shown, DvrTables& held, const Need& need, GLuint program);
  void bind_preintegration(const TransferFunction& shown, DvrTables& held, double step, int bins,
                           GLuint program);
  void bind_peaks(const Need& need, GLuint program);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
            const std::function<void(int pass)>& after_pass);
  void draw_passes(const Scene& scene, const Camera& camera, const gl::RenderTarget& target,
                   const Need& needs, const std::function<void(int pass)>& after_pass);
};

void Raycaster::State::take_volume(const Scene& scene) {
  if (volume == scene.volume) return;
  classification.reset();
  volume.reset();
  macrocells.forget_volume();
  values = {};  // the old one's room first
  empty_cells = {};
  units = stored_units(scene.volume->statistics.range);
  values = upload_volume(*scene.volume, units);
  volume = scene.volume;
}

void Raycaster::State::take_classification(const Scene& scene) {
  take_volume(scene);
  const ValueRange dvr = crest::dvr_range(scene), surfaces = crest::surface_range(scene);
  if (classification && classification->tf == scene.tf && dvr == dvr_range && surfaces == surface_range)
    return;
  classification = classify(scene.tf, surfaces);
  dvr_range = dvr;
  surface_range = surfaces;
  tables = {};
  macrocells.forget_tf();
}

Need Raycaster::State::need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics) {
  take_classification(scene);
  const auto occupied_share = [&](const Features& features, const TableBlur& blur) {
    return macrocells.occupied_share(*scene.volume, *classification, scene.rendering, features, blur);
  };
  return find_need(*scene.volume, *classification, scene.rendering, camera, size, statistics, forced,
                   occupied_share);
}

void Raycaster::State::bind(const Scene& scene, const Need& need, GLuint program) {
  const Features& features = need.features;
  glBindTextureUnit(volume_unit, values.id());
  set(program, "volume", int(volume_unit));
  if (features.empty_cells) {
    const int radius = support_radius(scene.rendering);
    if (!empty_cells || empty_cells_radius != radius) empty_cells = upload_empty_cells(*volume, radius);
    empty_cells_radius = radius;
    glBindTextureUnit(empty_cells_unit, empty_cells.id());
    set(program, "empty_cells", int(empty_cells_unit));
  }
  if (uses_filter(features, Filter::bc)) set_bc_weights(program, scene.rendering);
  if (features.skipping || features.adaptive) bind_macrocells(scene, need, program);
  if (features.dvr) bind_tf(scene, need, program);
  if (features.illumination != Illumination::semi_transparent) bind_illumination(program, scene, units);
  if (features.peaks) bind_peaks(need, program);
  // What is forced in does not show
  set(program, "max_peaks", scene.rendering.max_peaks);
  set(program, "least_residual",
      need.needed.early_termination ? float(scene.rendering.early_termination) : 0.0f);
  set(program, "shading_strength", need.needed.shading ? 1.0f : 0.0f);
}

void Raycaster::State::bind_macrocells(const Scene& scene, const Need& need, GLuint program) {
  Features features = need.needed;  // what is forced in does not show
  features.skipping = need.features.skipping;
  glBindTextureUnit(macrocells_unit,
                    macrocells.texture(*volume, *classification, scene.rendering, features, need.tf_blur));
  set(program, "macrocells", int(macrocells_unit));
  const Grid& grid = volume->grid;
  set(program, "macrocell_size",
      glm::vec3(grid.spacing / grid.smallest_spacing() * double(MacrocellStore::side(*volume))));
}

void Raycaster::State::bind_tf(const Scene& scene, const Need& need, GLuint program) {
  const TransferFunction nothing;
  const bool is_base = need.features.base_tf;
  DvrTables& held = !need.needed.dvr ? no_tables.full_tf : is_base ? tables.base_tf : tables.full_tf;
  const TransferFunction& shown = !need.needed.dvr ? nothing
                                  : is_base        ? classification->base
                                                   : classification->tf;
  if (need.features.preintegration_table)
    return bind_preintegration(shown, held, scene.rendering.step, need.preintegration_bins, program);
  if (need.features.preintegrated) return bind_antiderivatives(shown, held, need, program);

  auto& tf = held.samples;
  const int entries = need.tf_table.entries;
  if (!tf || tf->entries != entries)
    tf = upload_tf(units.stored(shown), units.stored(dvr_range), volume->grid.smallest_spacing(), entries);
  bind_tf_texture(program, *tf, tf_unit);
}

void Raycaster::State::bind_antiderivatives(const TransferFunction& shown, DvrTables& held, const Need& need,
                                            GLuint program) {
  auto& table = held.antiderivatives;
  const int stretches = need.tf_table.entries - 1;
  if (!table || table->stretches != stretches)
    table = upload_antiderivatives(build_antiderivatives(units.stored(shown), units.stored(dvr_range),
                                                         volume->grid.smallest_spacing(), stretches));
  glBindTextureUnit(tf_unit, table->texture.id());
  set(program, "antiderivatives", int(tf_unit));
  set(program, "antiderivatives_min_scale", glm::vec2(table->range.min, stretches / table->range.width()));
}

void Raycaster::State::bind_preintegration(const TransferFunction& shown, DvrTables& held, double step,
                                           int bins, GLuint program) {
  auto& table = held.preintegration;
  if (!table || table->bins != bins || table->length != step)
    table = upload_preintegration_table(build_preintegration_table(
        units.stored(shown), units.stored(dvr_range), volume->grid.smallest_spacing(), step, bins));
  glBindTextureUnit(tf_unit, table->texture.id());
  set(program, "preintegration_table", int(tf_unit));
  // The centres of the first and the last texel are the range's ends
  const double scale = (bins - 1.0) / bins / table->range.width();
  set(program, "preintegration_min_scale_offset", glm::vec3(table->range.min, scale, 0.5 / bins));
  set(program, "preintegrated_length", float(step));
}

void Raycaster::State::bind_peaks(const Need& need, GLuint program) {
  const std::vector<Peak> none;
  const std::vector<Peak>& surfaces = need.needed.peaks ? classification->surfaces : none;
  Tables& held = need.needed.peaks ? tables : no_tables;
  if (!held.peaks) held.peaks = upload_peaks(units.stored(surfaces));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, held.peaks.id());
  if (!need.features.peak_table) return set_few_peaks(program, units.stored(surfaces));

  if (!held.peak_table || held.peak_table->bins != need.peak_bins) {
    const PeakTable table = build_peak_table(surfaces, surface_range, need.peak_bins);
    held.peak_table = upload_peak_table(table, units.stored(surfaces));
  }
  glBindTextureUnit(peak_table_unit, held.peak_table->ranges.id());
  set(program, "peak_table", int(peak_table_unit));
  glBindTextureUnit(peak_runs_unit, held.peak_table->runs.id());
  set(program, "peak_runs", int(peak_runs_unit));
  set(program, "bin_min_scale",
      glm::vec2(units.stored(held.peak_table->range.min), held.peak_table->bin_scale / units.scale));
}

Raycaster::Raycaster(std::filesystem::path shader_folder)
    : state_(std::make_unique<State>(std::move(shader_folder))) {
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

Need Raycaster::need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics) {
  return state_->need(scene, camera, size, statistics);
}

Features Raycaster::features(const Scene& scene, bool statistics) {
  return need(scene, whole_volume_camera(scene.volume->grid, 1), {1, 1}, statistics).features;
}

void Raycaster::State::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
                            const std::function<void(int pass)>& after_pass) {
  const Need needs = need(scene, camera, target.size(), target.has_counts());
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  glViewport(0, 0, target.size().x, target.size().y);
  glScissor(tile.begin.x, tile.begin.y, tile.end.x - tile.begin.x, tile.end.y - tile.begin.y);
  glEnable(GL_SCISSOR_TEST);
  if (needs.is_empty())
    clear(target);
  else
    draw_passes(scene, camera, target, needs, after_pass);
  if (needs.is_empty() && after_pass) after_pass(0);
  glDisable(GL_SCISSOR_TEST);
}

void Raycaster::State::draw_passes(const Scene& scene, const Camera& camera, const gl::RenderTarget& target,
                                   const Need& needs, const std::function<void(int pass)>& after_pass) {
  const GLuint id = programs.program("fullscreen.vert", "raycaster.frag", shader_defines(needs.features));
  bind(scene, needs, id);
  set_view(id, scene, camera, target.size());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  set_blending(needs.features.illumination, false);
  glBindVertexArray(vertex_array.id());
  glUseProgram(id);
  for (int pass = 0; pass < needs.passes(); ++pass) {
    set(id, "first_interval", pass * needs.intervals_per_pass);
    set(id, "interval_count", needs.intervals_per_pass);
    if (pass == 1) glEnablei(GL_BLEND, 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (after_pass) after_pass(pass);
  }
  glDisable(GL_BLEND);
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
  return sum_of(draw_counts(scene, camera, target));
}

void Raycaster::force(const Forced& forced) { state_->forced = forced; }

void Raycaster::reload_shaders() { state_->programs.reload(); }

const std::string& Raycaster::shader_error() const { return state_->programs.error(); }

}  // namespace crest
