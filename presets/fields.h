#pragma once

#include <concepts>
#include <type_traits>

#include "presets/preset.h"

namespace crest {

/// What a field of a preset may hold, and when it is there. Numbers (each of them, in a vector) lie between
/// min and max.
struct FieldRule {
  double min = -1e300, max = 1e300;  ///< differences and widths of such numbers are finite
  bool open_min = false, open_max = false;
  bool required = false;        ///< reading without it is an error
  bool always_written = false;  ///< also where it has its default
};

inline constexpr FieldRule any_value{};
inline constexpr FieldRule unit_interval{.min = 0, .max = 1};
inline constexpr FieldRule not_negative{.min = 0};
inline constexpr FieldRule positive{.min = 0, .open_min = true};

constexpr FieldRule required(FieldRule rule) {
  rule.required = rule.always_written = true;
  return rule;
}
constexpr FieldRule always_written(FieldRule rule = any_value) {
  rule.always_written = true;
  return rule;
}

template <class Self, class T>
concept Either = std::same_as<std::remove_const_t<Self>, T>;

// visit_fields(values, field) calls field(name, member, rule) for each field of a preset's JSON, in the order
// in which they are written. Reading, validation, writing and setting a field by its path all come from
// these lists: a new field is a new line here.

template <Either<ClipBox> Self, class Field>
void visit_fields(Self& box, Field&& field) {
  field("min", box.min, required(any_value));
  field("max", box.max, required(any_value));
}

template <Either<VdlsOptions> Self, class Field>
void visit_fields(Self& options, Field&& field) {
  field("homo_regions", options.homo_regions, any_value);
  field("leaves", options.leaves, FieldRule{.min = 0, .max = 256});
  field("merge_threshold", options.merge_threshold, FieldRule{.min = 0, .max = 1e6});
  field("early_test", options.early_test, any_value);
  field("layers_per_pass", options.layers_per_pass, FieldRule{.min = 1, .max = 64});
  field("back_to_front", options.back_to_front, any_value);
  field("gradient_volume", options.gradient_volume, any_value);
}

template <Either<Rendering> Self, class Field>
void visit_fields(Self& rendering, Field&& field) {
  field("mode", rendering.mode, always_written());
  field("peak_form", rendering.peak_form, any_value);
  field("engine", rendering.engine, always_written());
  field("vdls", rendering.vdls, any_value);
  field("classification", rendering.classification, any_value);
  field("preintegration_bins", rendering.preintegration_bins, FieldRule{.min = 2, .max = 2048});
  field("step", rendering.step, FieldRule{.min = 1e-3});  // a ray has a finite number of them
  field("placement", rendering.placement, any_value);
  field("sampling", rendering.sampling, any_value);
  field("s_k", rendering.s_k, FieldRule{.min = 1e-3, .max = 1e3});
  field("adaptive", rendering.adaptive, any_value);
  field("skipping", rendering.skipping, any_value);
  field("filter", rendering.filter, any_value);
  field("root_filter", rendering.root_filter, any_value);
  field("bc_b", rendering.bc_b, FieldRule{.min = -10, .max = 10});
  field("bc_c", rendering.bc_c, FieldRule{.min = -10, .max = 10});
  field("max_peaks", rendering.max_peaks, FieldRule{.min = 1, .max = 64});
  field("peak_bins", rendering.peak_bins, FieldRule{.min = 1, .max = 4096});
  field("shading", rendering.shading, any_value);
  field("gradient", rendering.gradient, any_value);
  field("illumination", rendering.blend_mode, any_value);
  field("early_termination", rendering.early_termination, unit_interval);
  field("clip_box", rendering.clip_box, any_value);
  field("background", rendering.background, unit_interval);
}

template <Either<Camera> Self, class Field>
void visit_fields(Self& camera, Field&& field) {
  field("eye", camera.eye, always_written());
  field("target", camera.target, always_written());
  field("up", camera.up, always_written());
  field("fov_y_degrees", camera.fov_y_degrees,
        always_written({.min = 0, .max = 180, .open_min = true, .open_max = true}));
  field("projection", camera.projection, any_value);
}

template <Either<Surface> Self, class Field>
void visit_fields(Self& surface, Field&& field) {
  field("mode", surface.mode, any_value);
  field("opacity", surface.opacity, unit_interval);
}

template <Either<ControlPoint> Self, class Field>
void visit_fields(Self& point, Field&& field) {
  field("value", point.value, required(any_value));
  field("color", point.color, always_written(unit_interval));
  field("opacity", point.opacity, required(unit_interval));
  field("surface", point.surface, any_value);
}

template <Either<TransferFunction> Self, class Field>
void visit_fields(Self& tf, Field&& field) {
  field("domain", tf.domain, always_written());
  field("unit_distance", tf.unit_distance, always_written(positive));
  field("unit", tf.unit, always_written());
  field("min_prominence", tf.min_prominence, unit_interval);
  field("plateau_width", tf.plateau_width, not_negative);
  field("spike_width", tf.spike_width, unit_interval);
  field("points", tf.points, required(any_value));
}

template <Either<Preset> Self, class Field>
void visit_fields(Self& preset, Field&& field) {
  field("name", preset.name, always_written());
  field("notes", preset.notes, always_written());
  field("tags", preset.tags, any_value);
  field("transfer_function", preset.transfer_function, required(any_value));
  field("rendering", preset.rendering, always_written());
  field("camera", preset.camera, any_value);
}

/// A struct that has a list of fields.
template <class T>
concept Fielded = requires(T& values) {
  visit_fields(values, [](const char*, auto&, const FieldRule&) {});
};

/// Fielded structs that keep the JSON keys which they do not know. Those without pass them to what they are
/// in.
template <class T>
concept KeepsUnknown = Fielded<T> && requires(T& values) {
  values.unknown;
};

}  // namespace crest
