#include "tests/benchmark/feature_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/raycaster/raycaster.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"

namespace crest::bench {
namespace {

using VolumePtr = std::shared_ptr<const Volume>;

/// The same with a point in its middle that has no value.
VolumePtr with_hole(Volume volume) {
  const glm::ivec3 dims = volume.grid.dims, middle = dims / 2;
  volume.values.floats()[std::size_t(middle.x + dims.x * (middle.y + dims.y * middle.z))] =
      std::numeric_limits<float>::quiet_NaN();
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

/// The same in 8 bits.
VolumePtr in_steps(Volume volume) {
  const ValueRange range = volume.statistics.range;
  std::vector<std::uint8_t> stored;
  for (const float value : volume.values.to_floats())
    stored.push_back(std::uint8_t(std::lround(255 * (double(value) - range.min) / range.width())));
  volume.values = Voxels(std::move(stored), {});
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

ControlPoint point(double value, double opacity) {
  ControlPoint p;
  p.value = value;
  p.opacity = opacity;
  p.color = {value, 0.5, 1 - value};
  return p;
}

/// Haze of this opacity in 16 voxels, with spikes that stand out of it; values are 0..1 over the volume's
/// range.
TransferFunction haze_with_spikes(std::vector<double> spikes, double haze = 0.1) {
  TransferFunction tf;
  tf.domain = Domain::normalized;
  tf.unit = LengthUnit::voxel;
  tf.unit_distance = 16;
  tf.points.push_back(point(0, haze));
  for (const double spike : spikes)
    for (const auto& [offset, opacity] : {std::pair(-1e-3, haze), {0.0, 0.3}, {1e-3, haze}})
      tf.points.push_back(point(spike + offset, opacity));
  tf.points.push_back(point(1, haze));
  return tf;
}

/// Clear, then haze, with a ramp of this width between them.
TransferFunction ramp(double width) {
  TransferFunction tf = haze_with_spikes({});
  tf.points = {point(0, 0), point(0.5, 0), point(0.5 + width, 0.1), point(1, 0.1)};
  return tf;
}

/// Nothing is skipped, so that no feature comes or goes with what is empty.
Scene scene_of(const VolumePtr& volume, const TransferFunction& tf, Mode mode) {
  Preset preset;
  preset.transfer_function = tf;
  preset.rendering.mode = mode;
  preset.rendering.skipping = false;
  return make_scene(volume, preset);
}

template <class Value>
Scene with(Scene scene, Value Rendering::*setting, const std::type_identity_t<Value>& value) {
  scene.rendering.*setting = value;
  return scene;
}

FeatureCase forceable(const char* feature, const Scene& needed, const Scene& sibling, const Forced& forced) {
  return {feature, {needed}, {sibling}, Frame{sibling, forced}};
}

FeatureCase forceable(bool Features::*feature, const Scene& needed, const Scene& sibling) {
  const auto name = std::ranges::find(all_features(), feature, &FeatureName::in)->name;
  Forced forced;
  forced.features.*feature = true;
  return forceable(name, needed, sibling, forced);
}

std::vector<FeatureCase> peak_cases(const VolumePtr& volume) {
  const auto peaks_at = [&](const std::vector<double>& values) {
    return scene_of(volume, haze_with_spikes(values), Mode::peak_only);
  };
  const Scene one = peaks_at({0.5}), two = peaks_at({0.3, 0.6}),
              both = with(one, &Rendering::mode, Mode::both);
  return {
      forceable(&Features::dvr, both, one),
      forceable(&Features::peaks, both, with(one, &Rendering::mode, Mode::dvr_only)),
      forceable(&Features::peak_list, two, one),
      forceable(&Features::peak_table, peaks_at({0.1, 0.3, 0.5, 0.7, 0.9}), peaks_at({0.2, 0.4, 0.6, 0.8})),
      forceable(&Features::several_peaks, peaks_at({0.5, 0.51}), two),
  };
}

std::vector<FeatureCase> ray_cases(const VolumePtr& volume) {
  const Scene plain = scene_of(volume, haze_with_spikes({0.5}), Mode::both);
  const Scene holed = scene_of(with_hole(*volume), haze_with_spikes({0.5}), Mode::both);
  const Scene dense = scene_of(volume, haze_with_spikes({0.5}, 0.95), Mode::both);
  const Scene full = with(scene_of(volume, haze_with_spikes({}), Mode::dvr_only), &Rendering::skipping, true);
  const Scene sparse = with(scene_of(volume, ramp(0.1), Mode::dvr_only), &Rendering::skipping, true);
  FeatureCase long_rays = forceable(&Features::long_rays, plain, plain);
  long_rays.needed.forced.intervals_per_pass = 120;  // of some 220
  FeatureCase statistics = forceable(&Features::statistics, plain, plain);
  statistics.needed.counts = true;
  return {
      forceable(&Features::shading, with(plain, &Rendering::shading, Shading::gradient), plain),
      forceable(&Features::early_termination, with(dense, &Rendering::early_termination, 0.01), dense),
      forceable(&Features::skipping, sparse, full),
      forceable(&Features::empty_cells, holed, plain),
      {"whole_values", {scene_of(in_steps(*volume), haze_with_spikes({0.5}), Mode::both)}, {plain}},
      {"bricks", {plain, {}, false, true}, {plain}},
      long_rays,
      statistics,
  };
}

std::vector<FeatureCase> table_cases(const VolumePtr& volume) {
  Forced large;
  large.large_tables = true;
  const auto with_bins = [&](const std::vector<double>& values) {
    return with(scene_of(volume, haze_with_spikes(values), Mode::peak_only), &Rendering::peak_bins, 1024);
  };
  return {
      forceable("large TF table", scene_of(volume, ramp(1e-3), Mode::dvr_only),
                scene_of(volume, ramp(0.5), Mode::dvr_only), large),
      forceable("large peak table", with_bins({0.1, 0.3, 0.5, 0.502, 0.9}),
                with_bins({0.1, 0.3, 0.5, 0.7, 0.9}), large),
  };
}

std::vector<FeatureCase> other_cases(const VolumePtr& volume) {
  const Scene split = scene_of(volume, haze_with_spikes({0.5}), Mode::both);
  const Scene shaded = with(split, &Rendering::shading, Shading::gradient);
  const Scene paper = with(split, &Rendering::peak_form, PeakForm::paper);
  const auto in_mode = [](const Scene& scene, Mode mode) { return with(scene, &Rendering::mode, mode); };
  const auto placed = [&](Placement placement) { return with(split, &Rendering::placement, placement); };
  const auto sampled = [&](Sampling sampling) {
    return with(with(split, &Rendering::sampling, sampling), &Rendering::s_k, 0.35);  // about as many samples
  };
  const Scene preintegrated = with(split, &Rendering::classification, ClassificationMethod::preintegrated);
  const Scene in_table =
      with(placed(Placement::entry), &Rendering::classification, ClassificationMethod::preintegrated_table);
  const Grid& grid = volume->grid;
  const ClipBox clip{grid.box_min() + 1e-3 * grid.box_size(), grid.box_max(), ""};
  return {
      {"extrema", {in_mode(split, Mode::peak_only)}, {in_mode(paper, Mode::peak_only)}},
      {"split", {split}, {paper}},
      {"exclusive", {in_mode(paper, Mode::peak_xor_dvr)}, {paper}},
      {"base_tf", {in_mode(split, Mode::peak_xor_dvr)}, {split}},
      {"own_root_filter", {with(split, &Rendering::root_filter, Filter::bspline)}, {split}},
      {"filter_linear_exact", {with(split, &Rendering::filter, Filter::linear_exact)}, {split}},
      {"filter_bspline", {with(split, &Rendering::filter, Filter::bspline)}, {split}},
      {"filter_bc", {with(split, &Rendering::filter, Filter::bc)}, {split}},
      {"filter_gradient", {with(shaded, &Rendering::gradient, Gradient::filter)}, {shaded}},
      {"analytic", {with(split, &Rendering::classification, ClassificationMethod::analytic)}, {split}},
      {"preintegrated", {preintegrated}, {split}},
      {"preintegration_table", {in_table}, {with(preintegrated, &Rendering::placement, Placement::entry)}},
      {"clip_box", {with(split, &Rendering::clip_box, clip)}, {split}},
      {"differential", {sampled(Sampling::differential)}, {split}},
      {"footprint", {sampled(Sampling::footprint)}, {split}},
      {"adaptive", {with(split, &Rendering::adaptive, true)}, {split}},
      {"placement_eye", {placed(Placement::eye)}, {split}},
      {"placement_entry", {placed(Placement::entry)}, {split}},
      {"placement_entry_exit", {placed(Placement::entry_exit)}, {split}},
  };
}

/// Of one feature: whether it is where it should be, and where it should not.
std::string fault_of(const FeatureCase& c, const FeatureName& feature, glm::ivec2 size) {
  if (!(need_of(c.needed, size).needed.*feature.in)) return c.feature + " is not needed where it should be";
  const Need left_out = need_of(c.left_out, size);
  if (left_out.features.*feature.in) return c.feature + " is not left out where it should be";
  if (!c.forced_in) return "";
  const Need forced = need_of(*c.forced_in, size);
  const bool is_forced = forced.features.*feature.in && !(forced.needed.*feature.in);
  return is_forced ? "" : c.feature + " is not forced in";
}

}  // namespace

std::vector<FeatureCase> feature_cases() {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=64"));
  std::vector<FeatureCase> cases;
  for (const auto& part : {peak_cases(volume), ray_cases(volume), table_cases(volume), other_cases(volume)})
    cases.insert(cases.end(), part.begin(), part.end());
  return cases;
}

Need need_of(const Frame& frame, glm::ivec2 size) {
  Raycaster raycaster;
  raycaster.force(frame.forced);
  if (frame.in_bricks) raycaster.resources().whole_volume_bytes = 0;
  return raycaster.need(frame.scene, whole_volume_camera(frame.scene.volume->grid, 1), size, frame.counts);
}

std::string fault_of(const std::vector<FeatureCase>& cases, glm::ivec2 size) {
  for (const FeatureName& feature : all_features()) {
    const auto c = std::ranges::find(cases, feature.name, &FeatureCase::feature);
    if (c == cases.end()) return fmt::format("no case measures {}", feature.name);
    if (std::string fault = fault_of(*c, feature, size); !fault.empty()) return fault;
  }
  return "";
}

}  // namespace crest::bench
