// Runs the GL tests, the stability table and the benchmarks that lie beside it, what matters most first, and
// leaves what they found in one file of JSON, which is written anew after each part (docs/gpu.md). Each part
// is a program of its own: a driver that crashes or hangs costs that part alone. Usage: gpu_check [--quick]
// [--minutes N] [--programs DIR] [-o FILE] [LAUNCHER...]
#include <fmt/core.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>
#include <thread>

#include "app/options.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "render/measure/timing.h"
#include "tests/gpu/child.h"
#include "tests/gpu/reading/test_output.h"

namespace crest::gpu {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Settings {
  bool quick = false;
  int minutes = 20;
  std::string programs, output = "result.json";
  std::vector<std::string> launcher;  ///< words before each program: a loader with its options
};

/// A test program, as whether it runs whole or in shards. Quick runs take a few tests of each.
struct TestProgram {
  const char *name, *quick_filter;
  int shards;
};
constexpr TestProgram test_programs[] = {
    {"test_resources", "*", 1},
    {"test_vdls", "Layers.SmallSteps*:HomoRegions*", 1},
    {"test_convergence", "PreintegrationOrder.IsTwoInTheStep", 2},
    {"test_raycaster", "*Golden*:Slice*:Targets*", 6},
    {"test_stability", "StabilityTable.NoCase*:StabilityTable.ACase*", 1},
};

class Check {
 public:
  explicit Check(Settings settings) : settings_(std::move(settings)), began_(steady_seconds()) {}
  int run();

 private:
  double seconds() const { return steady_seconds() - began_; }
  /// How long a part may take that has to be over when so much of all the time is.
  double seconds_until(double share) const {
    return std::max(60 * settings_.minutes * share - seconds(), 0.0);
  }
  std::unique_ptr<Child> start(const char* program, const std::vector<std::string>& options, double limit_s);
  void add_part(const char* name, Json part);
  void run_device();
  void run_frames(const char* name, int points, const char* size, double until);
  void run_tests(double until);
  void run_stability(double until);
  void run_benchmark(const char* program, const char* quick_filter, double until);
  void write();

  Settings settings_;
  double began_;
  int started_ = 0;
  bool all_passed_ = true;
  Json result_;
};

/// Lines of JSON that a program printed; others are passed over.
Json json_lines(const std::string& text) {
  Json lines = Json::array();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    Json line =
        Json::parse(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), nullptr, false);
    if (line.is_object()) lines.push_back(std::move(line));
    begin = end + 1;
  }
  return lines;
}

/// The object that a program printed, also where the program was ended before it had closed its last list.
Json printed_object(const std::string& text) {
  const std::size_t begin = text.find('{');
  if (begin == text.npos) return nullptr;
  std::size_t end = text.rfind('}');
  for (int tries = 0; tries < 4 && end != text.npos && end > begin; ++tries, end = text.rfind('}', end - 1))
    for (const char* rest : {"", "]}"}) {
      Json object = Json::parse(text.substr(begin, end + 1 - begin) + rest, nullptr, false);
      if (!object.is_discarded()) return object;
    }
  return nullptr;
}

Json failed_json(const std::vector<FailedTest>& tests) {
  Json list = Json::array();
  for (const FailedTest& test : tests) list.push_back({{"test", test.name}, {"output", test.output}});
  return list;
}

std::unique_ptr<Child> Check::start(const char* program, const std::vector<std::string>& options,
                                    double limit_s) {
  std::vector<std::string> words = settings_.launcher;
  words.push_back((fs::path(settings_.programs) / program).string());
  words.insert(words.end(), options.begin(), options.end());
  const fs::path log = fs::temp_directory_path() / fmt::format("{}-{}.log", program, ++started_);
  return std::make_unique<Child>(std::move(words), log, limit_s);
}

void Check::add_part(const char* name, Json part) {
  const std::string result = part["result"];
  all_passed_ = all_passed_ && result == "passed";
  result_["parts"][name] = std::move(part);
  write();
  fmt::print(stderr, "{:6.0f} s  {}: {}\n", seconds(), name, result);
}

/// passed, failed, or cut off by the time: then what there is counts.
const char* result_of(const Child& child) {
  return child.succeeded() ? "passed" : child.timed_out() ? "not finished" : "failed";
}

Json part_of(const Child& child) {
  Json part{{"result", result_of(child)}, {"seconds", child.seconds()}};
  if (!child.succeeded()) {
    part["end"] = child.end();
    part["output"] = tail_of(child.output());
  }
  return part;
}

void Check::run_device() {
  const auto child = start("bench_frames", {"--device-only"}, 60);
  child->wait();
  const Json lines = json_lines(child->output());
  if (!lines.empty()) result_["device"] = lines[0];
  add_part("device", part_of(*child));
}

void Check::run_frames(const char* name, int points, const char* size, double until) {
  std::vector<std::string> options{"--points", std::to_string(points), "--size", size};
  if (settings_.quick) options.insert(options.end(), {"--frames", "1", "--volume", "plume"});
  const auto child = start("bench_frames", options, seconds_until(until));
  child->wait();
  Json lines = json_lines(child->output()), part = part_of(*child);
  if (!lines.empty()) lines.erase(0);  // the device
  part["presets"] = std::move(lines);
  add_part(name, std::move(part));
}

/// Side by side: they are checked, not timed, and most of their time goes into exact answers on the
/// processor.
void Check::run_tests(double until) {
  struct Job {
    const TestProgram* program;
    std::unique_ptr<Child> child;
  };
  std::deque<std::pair<const TestProgram*, int>> waiting;
  for (const TestProgram& program : test_programs)
    for (int shard = 0; shard < (settings_.quick ? 1 : program.shards); ++shard)
      waiting.emplace_back(&program, shard);
  const std::size_t at_once = std::clamp(std::thread::hardware_concurrency() / 2, 1U, 8U);
  std::vector<Job> running;
  std::map<const TestProgram*, TestOutput> outputs;
  std::map<const TestProgram*, Json> parts;
  while (!waiting.empty() || !running.empty()) {
    while (!waiting.empty() && running.size() < at_once) {
      const auto [program, shard] = waiting.front();
      waiting.pop_front();
      setenv("GTEST_TOTAL_SHARDS", std::to_string(settings_.quick ? 1 : program->shards).c_str(), 1);
      setenv("GTEST_SHARD_INDEX", std::to_string(shard).c_str(), 1);
      const std::string filter = settings_.quick ? program->quick_filter : "*";
      running.push_back({program, start(program->name, {"--gtest_filter=" + filter}, seconds_until(until))});
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::erase_if(running, [&](Job& job) {
      if (!job.child->is_over()) return false;
      const TestOutput output = read_test_output(job.child->output());
      outputs[job.program].add(output);
      Json& part = parts[job.program];
      // What a test crashed in, it failed in; where a program was stopped for time, nobody knows
      const bool crashed = !job.child->succeeded() && !job.child->timed_out();
      if (crashed && output.failed.empty() && output.unfinished.empty())
        part["output"] = tail_of(job.child->output());
      const char* result = result_of(*job.child);
      if (part["result"].is_null() || part["result"] == "passed" || std::string_view(result) == "failed")
        part["result"] = result;
      if (!job.child->succeeded()) part["end"] = job.child->end();
      const TestOutput& all = outputs[job.program];
      part["tests_passed"] = all.passed;
      part["tests_skipped"] = all.skipped;
      part["failed"] = failed_json(all.failed);
      part["unfinished"] = failed_json(all.unfinished);
      if (settings_.quick && all.passed == 0) part["result"] = "failed";  // the filter is out of date
      add_part(job.program->name, part);
      return true;
    });
  }
}

void Check::run_stability(double until) {
  const auto child = start("crest", {"stability", "--json", "--size", settings_.quick ? "16x16" : "64x64"},
                           seconds_until(until));
  child->wait();
  Json part = part_of(*child);
  part["table"] = printed_object(child->output());
  add_part("stability", std::move(part));
}

void Check::run_benchmark(const char* program, const char* quick_filter, double until) {
  std::vector<std::string> options{"--benchmark_format=json", "--benchmark_min_time=0.2"};
  if (settings_.quick)
    options = {"--benchmark_format=json", "--benchmark_min_time=0.001",
               fmt::format("--benchmark_filter={}", quick_filter)};
  const auto child = start(program, options, seconds_until(until));
  child->wait();
  Json part = part_of(*child);
  part["measured"] = printed_object(child->output());
  if (part["measured"].is_null() && child->succeeded()) part["result"] = "failed";  // nothing was measured
  add_part(program, std::move(part));
}

void Check::write() {
  result_["seconds"] = seconds();
  result_["all_passed"] = all_passed_;
  write_file_atomically(settings_.output, result_.dump(1) + "\n");
}

int Check::run() {
  utsname system{};
  uname(&system);
  result_ = {{"quick", settings_.quick},
             {"minutes", settings_.minutes},
             {"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
             {"processors", std::thread::hardware_concurrency()},
             {"launcher", settings_.launcher}};
  write();
  run_device();
  if (settings_.quick) {
    run_frames("frames_16", 16, "64x64", 0.4);
    run_tests(0.8);
    run_stability(0.9);
    run_benchmark("bench_features", "^peaks/", 1);
  } else {
    run_frames("frames_256", 256, "1024x1024", 0.12);
    run_frames("frames_512", 512, "1024x1024", 0.25);
    run_tests(0.6);
    run_stability(0.68);
    run_benchmark("bench_speed", "", 0.78);
    run_frames("frames_256_4k", 256, "3840x2160", 0.82);
    run_frames("frames_512_4k", 512, "3840x2160", 0.87);
    run_frames("frames_1024", 1024, "1024x1024", 0.92);
    run_frames("frames_1024_4k", 1024, "3840x2160", 0.96);
    run_benchmark("bench_features", "", 1);
  }
  return all_passed_ ? 0 : 1;
}

int main_with(int argc, char** argv) {
  Settings settings;
  settings.programs = fs::path(argv[0]).parent_path().string();
  CommandLine line({"The GL tests, the stability table and the benchmarks; leaves result.json", "", ""});
  Options options = line.options();
  options.add_flag("--quick", settings.quick, "Few and small, to try whether all runs");
  options.add("--minutes", settings.minutes, "How long it may take").in(1, 24 * 60).shows_default();
  options.add("--programs", settings.programs, "The folder of the programs").existing_folder();
  options.add("-o,--output", settings.output, "What is written").shows_default();
  options.add("LAUNCHER", settings.launcher, "Words before each program (after --)");
  options.when_read([] {});
  if (!line.read(argc, argv)) return 0;
  return Check(std::move(settings)).run();
}

}  // namespace
}  // namespace crest::gpu

int main(int argc, char** argv) {
  try {
    return crest::gpu::main_with(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gpu_check: %s\n", error.what());
    return 2;
  }
}
