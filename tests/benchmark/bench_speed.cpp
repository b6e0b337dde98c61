// What speed is worth: frames that are drawn turn by turn in one run, as ratios of their times, beside the
// ratio that is aimed at. `ratio` is the median over all rounds; `again` that of the frame compared with to
// itself, which is what the run varies by. With CREST_DATA set to a folder of real volumes, aneurism is among
// them.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>

#include "app/offscreen_context.h"
#include "presets/error.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/classify/peak_table.h"
#include "render/files/load.h"
#include "render/volume/builtin.h"
#include "render/volume/macrocells.h"
#include "tests/benchmark/contestant.h"
#include "tests/benchmark/fetch_loop.h"

namespace crest::bench {
namespace {

constexpr glm::ivec2 size{256, 256};

/// A frame, and what its time is compared with.
struct Race {
  std::string name;
  Frame frame, other;
  double aim;  ///< the ratio is at most this
  std::filesystem::path other_shaders = {};
};

Frame frame_of(const char* volume, const char* preset, Mode mode, Shading shading = Shading::none) {
  Scene scene = make_scene(std::make_shared<const Volume>(make_builtin(volume)), load_preset(preset));
  scene.rendering.mode = mode;
  scene.rendering.shading = shading;
  return {scene};
}

/// The same with a setting changed.
template <class Value>
Frame with(Frame frame, Value Rendering::*setting, const std::type_identity_t<Value>& value) {
  frame.scene.rendering.*setting = value;
  return frame;
}

Race xor_race(const std::string& name, const char* volume, const char* preset, double aim,
              Shading shading = Shading::none, bool skipping = true) {
  const auto frame = [&](Mode mode) {
    return with(frame_of(volume, preset, mode, shading), &Rendering::skipping, skipping);
  };
  return {"PEAK_XOR_DVR to DVR_ONLY, " + name, frame(Mode::peak_xor_dvr), frame(Mode::dvr_only), aim};
}

/// The exact march to half a voxel's samples of the same scene.
Race analytic_race(const std::string& name, const char* volume, const char* preset, Mode mode, double aim) {
  return {fmt::format("analytic {} to DVR_ONLY, {}", name_of(mode), name),
          with(frame_of(volume, preset, mode), &Rendering::classification, ClassificationMethod::analytic),
          frame_of(volume, preset, Mode::dvr_only), aim};
}

Race skipping_race(const std::string& name, const Frame& frame) {
  return {"with skipping to without, " + name, frame, with(frame, &Rendering::skipping, false), 0.2};
}

/// Haze where the field is above a threshold, so that more or less of the macrocells show something.
Race share_race(const std::shared_ptr<const Volume>& noise, double threshold, ClassificationMethod method) {
  Scene scene = make_scene(noise, load_preset("smooth-haze"));
  scene.tf.domain = Domain::data;
  const auto point = [](double value, double opacity) {
    return ControlPoint{
        .value = value, .color = glm::dvec3(1), .opacity = opacity, .surface = {}, .unknown = {}};
  };
  scene.tf.points = {point(threshold, 0), point(threshold + 0.1, 0.2),
                     point(noise->statistics.range.max, 0.2)};
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::none;
  scene.rendering.classification = method;
  const Macrocells cells = build_macrocells(*noise, {}, macrocell_side(noise->grid, noise->statistics));
  const auto shown = std::ranges::count_if(cells.max, [&](float most) { return most > threshold; });
  Frame skipping{scene};
  skipping.forced.features.skipping = true;
  return {fmt::format("with skipping to without, {}, {:.0f} % of the macrocells show", name_of(method),
                      100.0 * double(shown) / double(cells.count())),
          skipping, with({scene}, &Rendering::skipping, false), 1};
}

std::optional<Frame> real_vessels() {
  const char* folder = std::getenv("CREST_DATA");
  if (!folder) return std::nullopt;
  try {
    auto volume = std::make_shared<const Volume>(load_volume(std::string(folder) + "/aneurism.nrrd"));
    return Frame{make_scene(std::move(volume), load_preset("vessels-shell"))};
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_speed: aneurism is left out: %s\n", error.what());
    return std::nullopt;
  }
}

std::vector<Race> races(const std::filesystem::path& fetch_loop) {
  const char* spike = "plume?n=96";
  const Frame haze = with(frame_of("noise?n=96", "smooth-haze", Mode::dvr_only), &Rendering::skipping, false);
  Frame forced = frame_of("noise?n=96", "smooth-haze", Mode::dvr_only);
  forced.forced.features.skipping = true;
  std::vector<Race> list{
      xor_race("a spike", spike, "dirac-shell", 1.1),
      xor_race("a spike, nothing skipped", spike, "dirac-shell", 1.1, Shading::none, false),
      xor_race("a spike, shaded", spike, "dirac-shell", 1.1, Shading::gradient),
      xor_race("eight shells", "sphere?n=96", "onion", 1.5),
      xor_race("noise", "noise?n=96", "noisy-band", 1.5),
      xor_race("gyroid, four peaks", "gyroid?n=96", "four-peaks", 1.5),
      xor_race("marschner-lobb, four peaks", "marschner-lobb?n=96", "four-peaks", 1.5),
      {"DVR to a loop that only reads the volume", haze, haze, 2, fetch_loop},
      {"skipping forced in where all shows", forced, haze, 1.1},
      skipping_race("vessels", frame_of("vessels?n=128", "vessels-shell", Mode::peak_xor_dvr)),
      skipping_race("vessels, shaded",
                    frame_of("vessels?n=128", "vessels-shell", Mode::peak_xor_dvr, Shading::gradient)),
  };
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr}) {
    list.push_back(analytic_race("haze", "noise?n=96", "smooth-haze", mode, 2.5));
    list.push_back(analytic_race("noise", "noise?n=96", "noisy-band", mode, 2.5));
    list.push_back(analytic_race("gyroid, four peaks", "gyroid?n=96", "four-peaks", mode, 2.5));
    list.push_back(
        analytic_race("marschner-lobb, four peaks", "marschner-lobb?n=96", "four-peaks", mode, 2.5));
    list.push_back(analytic_race("eight shells", "sphere?n=96", "onion", mode, 2.5));
    list.push_back(analytic_race("a spike", spike, "dirac-shell", mode, 1.2));
    list.push_back(analytic_race("vessels", "vessels?n=128", "vessels-shell", mode, 1.2));
  }
  const auto noise = std::make_shared<const Volume>(make_builtin("noise?n=96"));
  for (const auto method : {ClassificationMethod::post, ClassificationMethod::analytic})
    for (const double threshold : {0.4, 0.6, 0.8, 1.0, 1.3, 1.6})
      list.push_back(share_race(noise, threshold, method));
  if (const auto real = real_vessels()) list.push_back(skipping_race("aneurism", *real));
  return list;
}

/// Each round in another order, so that none always finds the caches as the same other one left them.
void compete(benchmark::State& state, const Race& race) {
  Contestant contestants[] = {
      {race.frame, size}, {race.other, size, race.other_shaders}, {race.other, size, race.other_shaders}};
  std::vector<std::size_t> order{0, 1, 2};
  std::mt19937 random;
  std::vector<double> ratios, again;
  for (auto _ : state) {
    std::ranges::shuffle(order, random);
    double ms[3];
    for (const std::size_t i : order) ms[i] = contestants[i].draw_ms();
    ratios.push_back(ms[0] / ms[1]);
    again.push_back(ms[2] / ms[1]);
    state.SetIterationTime(1e-3 * ms[0]);
  }
  state.counters["ratio"] = median(ratios);
  state.counters["aim"] = race.aim;
  state.counters["again"] = median(again);
}

/// An edit of a TF of 64 points over a volume of 64^3 macrocells: peaks, their table, the TF's, occupancy. In
/// `large_tables` these have all the entries and bins that they may have.
void edit(benchmark::State& state, bool large_tables) {
  Frame frame = frame_of("sphere?n=256", "onion", Mode::peak_xor_dvr);
  auto& points = frame.scene.tf.points;
  const double low = points.front().value, high = points.back().value;
  points.clear();
  for (int i = 0; i < 64; ++i) {
    ControlPoint point;
    point.value = low + (high - low) * i / 63;
    point.opacity = i % 4 == 0 ? 0.9 : 0.02;
    points.push_back(point);
  }
  frame.scene.rendering.skipping = true;
  frame.scene.rendering.peak_bins = large_tables ? largest_bins : frame.scene.rendering.peak_bins;
  frame.forced.large_tables = large_tables;
  Contestant contestant(frame, size);
  std::vector<double> all;
  for (auto _ : state) {
    const double opacity = 0.9 - 1e-5 * double(all.size() + 1);  // never seen before
    all.push_back(contestant.edit_ms([&](TransferFunction& tf) { tf.points[32].opacity = opacity; }));
    state.SetIterationTime(1e-3 * std::max(all.back(), 1e-3));
  }
  state.counters["ms"] = median(all);
  state.counters["aim"] = 2;
}

int run(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  char tabular[] = "--benchmark_counters_tabular=true";
  arguments.insert(arguments.begin() + 1, tabular);
  int count = int(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

  const OffscreenContext context;
  const ChangedShaders fetching = fetch_loop();
  const std::vector<Race> list = races(fetching.folder());
  benchmark::AddCustomContext("renderer", context.renderer());
  const auto add = [](const std::string& name, auto work) {
    benchmark::RegisterBenchmark(name.c_str(), work)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  for (const Race& race : list) add(race.name, [&race](benchmark::State& state) { compete(state, race); });
  add("an edit of 64 points", [](benchmark::State& state) { edit(state, false); });
  add("an edit of 64 points, 4096 bins", [](benchmark::State& state) { edit(state, true); });
  benchmark::RunSpecifiedBenchmarks();
  benchmark::ClearRegisteredBenchmarks();
  return 0;
}

}  // namespace
}  // namespace crest::bench

int main(int argc, char** argv) {
  try {
    return crest::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_speed: %s\n", error.what());
    return 1;
  }
}
