// What each feature of the ray caster costs: frames of a scene that needs it, and of one that does not, with
// the feature forced in and left out, in turn in one run. Columns are ratios to the frame without it, the
// medians over all rounds; `again` is that frame against itself: what the run itself varies by.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/offscreen_context.h"
#include "render/camera.h"
#include "render/measure/timing.h"
#include "render/raycaster/raycaster.h"
#include "tests/benchmark/feature_cases.h"

namespace crest::bench {
namespace {

constexpr glm::ivec2 size{128, 128};

/// A frame with a ray caster of its own, so that it keeps its textures and tables.
class Contestant {
 public:
  explicit Contestant(const Frame& frame)
      : scene_(frame.scene), camera_(whole_volume_camera(scene_.volume->grid)), target_(size, frame.counts) {
    raycaster_.force(frame.forced);
    draw_ms();  // uploads and compiles
  }
  double draw_ms() {
    return finished_ms([&] { raycaster_.draw(scene_, camera_, target_); });
  }

 private:
  Scene scene_;
  Camera camera_;
  gl::RenderTarget target_;
  Raycaster raycaster_;
};

/// The other features that come with it, or go.
std::string features_that_differ(const FeatureCase& c) {
  const auto needed = need_of(c.needed, size).list.in, left_out = need_of(c.left_out, size).list.in;
  std::string text;
  const auto add = [&](char sign, const auto& features, const auto& without) {
    for (const std::string& feature : features)
      if (feature != c.feature && std::ranges::find(without, feature) == without.end())
        text += std::string(text.empty() ? "" : " ") + sign + feature;
  };
  add('+', needed, left_out);
  add('-', left_out, needed);
  return text;
}

void compete(benchmark::State& state, const FeatureCase& c) {
  std::vector<Contestant> contestants;
  for (const Frame& frame : {c.left_out, c.left_out, c.needed}) contestants.emplace_back(frame);
  if (c.forced_in) contestants.emplace_back(*c.forced_in);
  std::array<std::vector<double>, 4> ratios;  // to the first contestant
  std::size_t round = 0;
  for (auto _ : state) {
    std::array<double, 4> ms{};
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const std::size_t turn = (round + i) % contestants.size();
      ms[turn] = contestants[turn].draw_ms();
    }
    for (std::size_t i = 0; i < contestants.size(); ++i) ratios[i].push_back(ms[i] / ms[0]);
    state.SetIterationTime(1e-3 * ms[0]);
    ++round;
  }
  state.counters["again"] = median(ratios[1]);
  state.counters["needed"] = median(ratios[2]);
  if (c.forced_in) state.counters["forced_in"] = median(ratios[3]);
  state.SetLabel(features_that_differ(c));
}

int run(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  char tabular[] = "--benchmark_counters_tabular=true";
  arguments.insert(arguments.begin() + 1, tabular);
  int count = int(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

  const OffscreenContext context;
  const std::vector<FeatureCase> cases = feature_cases();
  if (const std::string fault = fault_of(cases, size); !fault.empty()) {
    std::fprintf(stderr, "bench_features: %s\n", fault.c_str());
    return 1;
  }
  benchmark::AddCustomContext("renderer", context.renderer());
  for (const FeatureCase& c : cases)
    benchmark::RegisterBenchmark(c.feature.c_str(), [&c](benchmark::State& state) { compete(state, c); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
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
    std::fprintf(stderr, "bench_features: %s\n", error.what());
    return 1;
  }
}
