#include "render/vdls/vdls.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "presets/choices.h"
#include "presets/error.h"
#include "presets/names.h"
#include "render/classify/stored_units.h"
#include "render/gl/draw_state.h"
#include "render/gl/uniforms.h"
#include "render/resources/table_textures.h"
#include "render/resources/texel_format.h"
#include "render/resources/volume_texture.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/shader_inputs/view_uniforms.h"
#include "render/vdls/gradient_volume.h"
#include "render/vdls/homo_regions.h"
#include "render/vdls/layer_textures.h"
#include "render/vdls/proxy.h"
#include "render/vdls/variants.h"
#include "render/volume/whole_values.h"

namespace crest {
namespace {

using gl::set;

enum Unit : GLuint { volume_unit, gradients_unit, tf_unit, layer_unit, delta_unit };
constexpr GLuint leaf_counts_binding = 1;

/// The fixed point of the layer samples: 30 bits for the longest side of the box.
float fixed_unit(const Grid& grid) {
  const glm::dvec3 size = grid.box_size() / grid.smallest_spacing();
  return float(std::exp2(std::ceil(std::log2(std::max({size.x, size.y, size.z}))) - 30));
}

/// Of a delta vector: what 31 bits have room for beside twice the step, at most ten.
int fraction_bits(const Scene& scene) {
  const double step = scene.rendering.step / double(fixed_unit(scene.volume->grid));
  return std::clamp(29 - int(std::ceil(std::log2(step))), 0, 10);
}

gl::BufferHandle make_buffer(std::size_t bytes, const void* data) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  glNamedBufferData(id, GLsizeiptr(std::max(bytes, std::size_t(4))), nullptr, GL_STREAM_DRAW);
  if (data && bytes > 0) glNamedBufferSubData(id, 0, GLsizeiptr(bytes), data);
  return gl::BufferHandle(id);
}

/// Squares on the picture, `on_axis` along its longer side.
struct Leaves {
  int on_axis, side;
  Leaves(glm::ivec2 size, int wanted)
      : on_axis(std::max(wanted, 1)), side((std::max(size.x, size.y) - 1) / on_axis + 1) {}
  std::size_t count() const { return std::size_t(on_axis) * std::size_t(on_axis); }
};

gl::BufferHandle make_counts(const Leaves& leaves) {
  const std::vector<std::uint32_t> zeros(leaves.count());
  return make_buffer(zeros.size() * sizeof zeros[0], zeros.data());
}

std::vector<std::uint32_t> read_counts(const gl::PendingBuffer& from, const Leaves& leaves) {
  std::vector<std::uint32_t> counts(leaves.count());
  from.copy_to(counts.data(), counts.size() * sizeof counts[0]);
  return counts;
}

/// In one call: the window waits for as long as the driver needs to take them.
constexpr double most_layers_at_once = 8192;

/// Of the longest ray through a part of the box, with some to spare for rounding at either end.
std::uint32_t most_samples(const Scene& scene, const Box& part) {
  if (part.is_empty()) return 0;
  const double step = scene.volume->grid.smallest_spacing() * scene.rendering.step;
  const double samples = std::ceil(glm::length(part.max - part.min) / step) + 4;
  if (samples > most_layers_at_once)
    throw Error(
        fmt::format("vdls: up to {:.0f} layers are too many to be drawn at once (at most {:.0f}): "
                    "rendering.step {} is too small for that",
                    samples, most_layers_at_once, scene.rendering.step));
  return std::uint32_t(samples);
}

}  // namespace

/// A scene with what the engine makes of its volume and its TF.
struct Vdls::Prepared {
  const Scene& scene;
  const Volume& volume;
  StoredUnits units;  ///< of the volume's texture
  ValueRange field;
  TfTableSize table_size;
  const TfTexture& tf;

  Box box() const { return rendered_box(volume.grid, scene.rendering.clip_box); }
};

Vdls::Prepared Vdls::prepare(const Scene& scene) {
  const Volume& volume = *scene.volume;
  const ValueRange field = volume.statistics.range;
  const StoredUnits units = stored_units(volume);
  const double spacing = volume.grid.smallest_spacing();
  const TfTableSize size =
      tf_table_size(scene.tf, field, spacing, glm::length(volume.grid.box_size()) / spacing);
  const TfTexture& tf =
      tf_texture(resources_->held, units.stored(scene.tf), units.stored(field), spacing, size.entries);
  return {scene, volume, units, field, size, tf};
}

std::string why_not_vdls(const Scene& scene) {
  const Rendering defaults, &r = scene.rendering;
  const auto only = [](const char* field, auto can, auto asked) {
    return can == asked ? ""
                        : fmt::format("the vdls engine renders {} alone, and rendering.{} is {}",
                                      name_of(can), field, name_of(asked));
  };
  for (const std::string& why :
       {only("mode", Mode::dvr_only, r.mode), only("placement", defaults.placement, r.placement),
        only("classification", defaults.classification, r.classification),
        only("sampling", defaults.sampling, r.sampling), only("filter", defaults.filter, r.filter),
        only("gradient", defaults.gradient, r.gradient)})
    if (!why.empty()) return why;
  if (r.adaptive) return "the vdls engine takes all steps alike, and rendering.adaptive is true";
  if (scene.volume->has_empty_cells())
    return fmt::format(
        "the vdls engine renders volumes in which each voxel has a value, and {} has {} without",
        scene.volume->name, scene.volume->statistics.nan_count + scene.volume->statistics.inf_count);
  return "";
}

// A bucket is visible if the TF shows a value in it, or within an entry of its table, which interpolates.
Box Vdls::visible_part(const Prepared& p) {
  const Rendering& rendering = p.scene.rendering;
  const BlendMode blend_mode = rendering.blend_mode;
  const Grid& grid = p.volume.grid;
  if (!rendering.vdls.homo_regions || !rendering.skipping || shows_values(blend_mode))
    return {grid.box_min(), grid.box_max()};
  const HomoRegions& homo = homo_regions(resources_->held, p.scene.volume);
  const double entry = 1.001 * p.tf.range.width() / (p.tf.entries - 1) / p.units.scale;
  const double least =
      blend_mode == BlendMode::iso_surface ? (1 - 1e-6) * iso_opacity(p.scene.tf, homo.range) : 0;
  return visible_box(homo, grid, [&](ValueRange bucket) {
    const double opacity = largest_opacity(p.scene.tf, {bucket.min - entry, bucket.max + entry});
    return opacity > 0 && opacity >= least;
  });
}

Box Vdls::shown_part(const Prepared& p) {
  const Box box = p.box(), part = visible_part(p);
  return {glm::max(box.min, part.min), glm::min(box.max, part.max)};
}

void Vdls::draw_into(const gl::RenderTarget& target, Tile tile) {
  glViewport(0, 0, target.size().x, target.size().y);
  glScissor(tile.begin.x, tile.begin.y, tile.end.x - tile.begin.x, tile.end.y - tile.begin.y);
  glBindVertexArray(vertex_array_.id());
}

void Vdls::set_up(const Prepared& p, const Camera& camera, const gl::RenderTarget& target, Tile tile,
                  GLuint counts) {
  const Scene& scene = p.scene;
  const Leaves leaves(target.size(), scene.rendering.vdls.leaves);
  layers_.attach(target);
  draw_into(target, tile);
  const GLuint program = resources_->programs.program("fullscreen.vert", "vdls_setup.frag",
                                                      setup_defines(scene.rendering, target.has_counts()));
  const Grid& grid = p.volume.grid;
  const Box part = visible_part(p);
  set_view(program, scene, camera, target.size());
  set(program, "fixed_unit", fixed_unit(grid));
  set(program, "fraction_bits", fraction_bits(scene));
  set(program, "leaf_side", leaves.side);
  set(program, "leaves", leaves.on_axis);
  set(program, "visible_min", glm::vec3((part.min - grid.origin) / grid.smallest_spacing()));
  set(program, "visible_max", glm::vec3((part.max - grid.origin) / grid.smallest_spacing()));
  glBindFramebuffer(GL_FRAMEBUFFER, layers_.setup_framebuffer());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, leaf_counts_binding, counts);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  set_up_ = counts;
}

Proxy Vdls::make_proxy(const Prepared& p, const Camera& camera, glm::ivec2 size, const LeafCounts& counts) {
  const Scene& scene = p.scene;
  work_ = {};
  Proxy proxy;
  if (scene.rendering.vdls.leaves > 0) {
    const Leaves leaves(size, scene.rendering.vdls.leaves);
    work_.nodes = screen_quadtree(counts, leaves.on_axis, leaves.side, scene.rendering.vdls.merge_threshold);
    proxy = proxy_of(work_.nodes);
  } else {
    proxy = proxy_of(shown_part(p), camera, size, int(std::ranges::max(counts)));
  }
  const int per_pass = scene.rendering.vdls.layers_per_pass;
  const auto passes_through = [&](int count) { return (count + per_pass - 1) / per_pass; };
  work_.layers = proxy.layers();
  work_.passes = passes_through(work_.layers);
  for (const ScreenNode& node : work_.nodes) {
    const glm::dvec2 part = glm::min(node.begin + node.side, size) - node.begin;
    work_.drawn_samples += part.x * part.y * passes_through(node.layers) * per_pass;
  }
  return proxy;
}

void Vdls::bind_volume(const Prepared& p, GLuint program) {
  KeyedCache& held = resources_->held;
  crest::bind_volume(*resources_, p.scene.volume, nullptr, {volume_unit, volume_unit}, program);
  bind_tf_texture(program, p.tf, tf_unit);
  bind_blend_mode(program, p.scene, p.units);
  if (!is_shaded(p.scene.rendering)) return;
  set(program, "shading_strength", 1.0f);
  if (!p.scene.rendering.vdls.gradient_volume) return;
  glBindTextureUnit(gradients_unit, gradient_texture(held, p.scene.volume));
  set(program, "gradients", int(gradients_unit));
}

void Vdls::draw_layers(const Prepared& p, const Camera& camera, glm::ivec2 size, const Proxy& proxy) {
  const Scene& scene = p.scene;
  const gl::BufferHandle corners =
      make_buffer(proxy.corners.size() * sizeof proxy.corners[0], proxy.corners.data());
  glVertexArrayVertexBuffer(vertex_array_.id(), 0, corners.id(), 0, sizeof proxy.corners[0]);
  const GLuint program =
      resources_->programs.program("vdls_proxy.vert", "vdls_layers.frag",
                                   layers_defines(scene.rendering, whole_values(p.volume).has_value()));
  set_view(program, scene, camera, size);
  set(program, "fixed_unit", fixed_unit(p.volume.grid));
  set(program, "fraction_bits", fraction_bits(scene));
  set(program, "picture_size", glm::vec2(size));
  bind_volume(p, program);
  glBindTextureUnit(delta_unit, layers_.delta_vectors());
  set(program, "delta_vectors", int(delta_unit));
  set(program, "layer_samples", int(layer_unit));
  glUseProgram(program);
  glEnablei(GL_BLEND, 0);
  set_blending(scene.rendering.blend_mode, scene.rendering.vdls.back_to_front);
  for (int pass = 0; pass < work_.passes; ++pass) {
    const int layer = pass * scene.rendering.vdls.layers_per_pass;
    glBindTextureUnit(layer_unit, layers_.layer_samples(pass));
    glBindFramebuffer(GL_FRAMEBUFFER, layers_.pass_framebuffer(pass));
    set(program, "first_layer", layer);
    glDrawArrays(GL_TRIANGLES, 0, proxy.corners_beyond(layer));
  }
}

Vdls::Vdls(std::shared_ptr<Resources> resources) : resources_(std::move(resources)) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  vertex_array_ = gl::VertexArrayHandle(id);
  glEnableVertexArrayAttrib(id, 0);
  glVertexArrayAttribFormat(id, 0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(id, 0, 0);
}

Vdls::Prepared Vdls::hold(const Scene& scene) {
  if (const std::string why = why_not_vdls(scene); !why.empty()) throw Error(why);
  resources_->held.begin_round();
  Prepared prepared = prepare(scene);
  if (is_in_bricks(*resources_, scene.volume))
    throw Error(
        "the vdls engine needs the whole volume on the graphics device, and draws none of more than 2 GiB "
        "there");
  hold_volume(*resources_, scene.volume);  // which may draw
  return prepared;
}

gl::PendingBuffer Vdls::begin(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  const Prepared prepared = hold(scene);
  const gl::DrawState state;
  gl::BufferHandle counts = make_counts(Leaves(target.size(), scene.rendering.vdls.leaves));
  set_up(prepared, camera, target, tile, counts.id());
  return gl::PendingBuffer(std::move(counts));
}

void Vdls::finish(const Prepared& p, const Camera& camera, const gl::RenderTarget& target,
                  const LeafCounts& counts) {
  set_up_ = 0;  // the layers take its place
  const Proxy proxy = make_proxy(p, camera, target.size(), counts);
  if (proxy.layers() > 0) draw_layers(p, camera, target.size(), proxy);
}

void Vdls::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  draw(scene, camera, target, tile, begin(scene, camera, target, tile));
}

// The layers' textures are all pictures', so that a picture is set up again after others were. The counts,
// which are read by then, stay the same.
void Vdls::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
                const gl::PendingBuffer& begun) {
  const Prepared prepared = hold(scene);
  const LeafCounts counts = read_counts(begun, Leaves(target.size(), scene.rendering.vdls.leaves));
  const gl::DrawState state;
  if (set_up_ == begun.id())
    draw_into(target, tile);
  else
    set_up(prepared, camera, target, tile, begun.id());
  finish(prepared, camera, target, counts);
}

void Vdls::draw_at_once(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  const Prepared prepared = hold(scene);
  const Leaves leaves(target.size(), scene.rendering.vdls.leaves);
  const LeafCounts counts(leaves.count(), most_samples(scene, shown_part(prepared)));
  const gl::DrawState state;
  const gl::BufferHandle unread = make_counts(leaves);
  set_up(prepared, camera, target, Tile{{0, 0}, target.size()}, unread.id());
  finish(prepared, camera, target, counts);
}

PictureNeed Vdls::need(const Scene& scene, glm::ivec2 size) {
  resources_->held.begin_round();
  const Prepared prepared = prepare(scene);
  const VdlsOptions& o = scene.rendering.vdls;
  PictureNeed need;
  const auto add = [&](bool in, const char* name, const std::string& why_not) {
    if (in)
      need.features.in.emplace_back(name);
    else
      need.features.left_out.emplace_back(name, why_not);
  };
  const std::string off = "it is switched off";
  const bool values_alone = shows_values(scene.rendering.blend_mode);
  const std::string blend_mode =
      fmt::format("rendering.illumination is {}", name_of(scene.rendering.blend_mode));
  add(true, "layers", "");
  add(o.homo_regions && scene.rendering.skipping && !values_alone, "homo_regions",
      !o.homo_regions             ? off
      : !scene.rendering.skipping ? "rendering.skipping is false"
                                  : blend_mode);
  add(o.leaves > 0, "screen_quadtree", off);
  add(o.early_test, "early_outside_volume_test", off);
  add(o.layers_per_pass > 1, "segmented_traversal", off);
  const bool shading = is_shaded(scene.rendering);
  const std::string unshaded = values_alone ? blend_mode : "rendering.shading is none";
  add(shading, "shading", unshaded);
  add(shading && o.gradient_volume, "gradient_volume", shading ? off : unshaded);
  add(false, "early_termination", "a layer does not see what lies before it");

  const glm::ivec3 dims = prepared.volume.grid.dims;
  need.gpu_data.push_back(
      {"volume", fmt::format("{}x{}x{} points", dims.x, dims.y, dims.z),
       prepared.volume.grid.point_count() * texel_kind(resources_->held, prepared.volume).bytes});
  if (shading && o.gradient_volume)
    need.gpu_data.push_back({"gradients", fmt::format("{}x{}x{} points", dims.x, dims.y, dims.z),
                             prepared.volume.grid.point_count() * 4 * sizeof(GLshort)});
  need.gpu_data.push_back({"transfer_function", fmt::format("{} entries", prepared.table_size.entries),
                           std::size_t(prepared.table_size.entries) * 4 * sizeof(float)});
  need.gpu_data.push_back(
      {"layers", fmt::format("3 x {}x{} pixels", size.x, size.y), LayerTextures::bytes(size)});
  need.tf_error = prepared.table_size.error;
  return need;
}

}  // namespace crest
