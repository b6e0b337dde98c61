#include "app/frame_log.h"

#include <algorithm>

#include "presets/json.h"
#include "presets/names.h"

namespace crest {
namespace {

nlohmann::ordered_json summarise(std::vector<double> values) {
  if (values.empty()) return {{"count", 0}};
  std::ranges::sort(values);
  const auto quantile = [&](double q) { return values[std::size_t(q * double(values.size() - 1) + 0.5)]; };
  return {
      {"count", values.size()}, {"median", quantile(0.5)}, {"p95", quantile(0.95)}, {"max", values.back()}};
}

}  // namespace

void FrameLog::add_versions(Clock::time_point frame_begin,
                            const std::array<std::uint64_t, picture_count>& wanted,
                            const std::array<std::uint64_t, picture_count>& shown) {
  const auto now = Clock::now();
  for (std::size_t i = 0; i < view_count; ++i) {
    if (wanted[i] != last_wanted_[i]) waiting_[i][wanted[i]] = frame_begin;
    last_wanted_[i] = wanted[i];
    while (!waiting_[i].empty() && waiting_[i].begin()->first <= shown[i]) {
      const auto since = now - waiting_[i].begin()->second;
      latency_ms_[i].push_back(std::chrono::duration<double, std::milli>(since).count());
      waiting_[i].erase(waiting_[i].begin());
    }
  }
}

std::string FrameLog::summary() const {
  nlohmann::ordered_json json;
  json["frame_ms"] = summarise(frame_ms_);
  json["processor_ms"] = summarise(processor_ms_);
  for (std::size_t i = 0; i < view_count; ++i)
    json["edit_to_view_ms"][std::string(name_of(view_modes[i]))] = summarise(latency_ms_[i]);
  return json.dump(2) + "\n";
}

}  // namespace crest
