// What each feature of the ray caster costs: frames of a scene that needs it, and of one that does not, with
// the feature forced in and left out, in turn in one run. Time is that of the frame without it; the columns
// are ratios to that, the medians over all rounds. `again` is that frame against itself: what the run itself
// varies by. `samples` is the ratio of the field evaluations where the feature is needed.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>

#include "app/offscreen_context.h"
#include "tests/benchmark/contestant.h"

namespace crest::bench {
namespace {

constexpr glm::ivec2 size{128, 128};

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

/// Each round in another order, so that none always finds the caches as the same other one left them.
void compete(benchmark::State& state, const FeatureCase& c) {
  std::map<std::string, Contestant> contestants;
  contestants.try_emplace("left_out", c.left_out, size);
  contestants.try_emplace("again", c.left_out, size);
  contestants.try_emplace("needed", c.needed, size);
  if (c.forced_in) contestants.try_emplace("forced_in", *c.forced_in, size);
  std::vector<std::string> order;
  for (const auto& [name, contestant] : contestants) order.push_back(name);

  std::mt19937 random;
  std::map<std::string, std::vector<double>> ratios;
  for (auto _ : state) {
    std::ranges::shuffle(order, random);
    std::map<std::string, double> ms;
    for (const std::string& name : order) ms[name] = contestants.at(name).draw_ms();
    for (const auto& [name, time] : ms) ratios[name].push_back(time / ms["left_out"]);
    state.SetIterationTime(1e-3 * ms["left_out"]);
  }
  for (const std::string& name : order)
    if (name != "left_out") state.counters[name] = median(ratios[name]);
  state.counters["samples"] = contestants.at("needed").samples() / contestants.at("left_out").samples();
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
