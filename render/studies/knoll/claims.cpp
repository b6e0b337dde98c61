#include "render/studies/knoll/claims.h"

#include <fmt/core.h>

#include <algorithm>

#include "render/measure/timing.h"

namespace crest {
namespace {

const Evidence& farthest(const ClaimCheck& check) {
  const auto& all = check.evidence;
  const bool high = (check.verdict == Verdict::worse) == check.paper.less_is_better;
  return high ? *std::ranges::max_element(all, {}, &Evidence::value)
              : *std::ranges::min_element(all, {}, &Evidence::value);
}

std::string title_of(const KnollResults& results, const std::string& scene) {
  const auto found = std::ranges::find(results.scenes, scene, &KnollScene::id);
  return found == results.scenes.end() ? scene : found->title;
}

/// The claim with its verdict, and `why` of the number that decides it.
template <class Why>
ClaimCheck judged(ClaimCheck check, Why why) {
  if (check.evidence.empty()) {
    check.why = "Nothing was measured for it in this run.";
    return check;
  }
  check.verdict = judge(check.paper, check.evidence);
  const Evidence& decisive = farthest(check);
  if (check.verdict == Verdict::holds)
    check.why = fmt::format("From {:.2f} to {:.2f}.", check.least(), check.greatest());
  else
    check.why = fmt::format("{}: {:.2f}. {}", decisive.of, decisive.value, why(decisive));
  return check;
}

const Table1Row* row_titled(const KnollResults& results, const std::string& title) {
  const auto found =
      std::ranges::find(results.table1, title, [](const Table1Row& r) { return r.shots.title; });
  return found == results.table1.end() ? nullptr : &*found;
}

/// What the time of peak finding by another's is made of, and what the paper has for it.
std::string samples_sentence(const KnollResults& results, const Evidence& ratio, const char* other) {
  const Table1Row* row = row_titled(results, ratio.of);
  const Shot &peaks = *row->shots.find("xor-paper"), &sampled = *row->shots.find(other);
  const PaperRow& paper = row->paper;
  const double by_samples = peaks.samples_per_ray / sampled.samples_per_ray;
  return fmt::format(
      "Peak finding reads {:.1f} field values a ray there, {:.2f} times those of {} (the paper: {:g} to "
      "{:g}, {:.2f} "
      "times){}.",
      peaks.samples_per_ray, by_samples, sampled.variant.name, paper.samples_per_ray,
      paper.dvr_samples_per_ray, paper.samples_per_ray / paper.dvr_samples_per_ray,
      ratio.value > by_samples * (1 + claim_tolerance)
          ? fmt::format("; the rest of the time goes to {:.2f} crossings a ray", peaks.crossings_per_ray)
          : "");
}

ClaimCheck ratio_claim(const KnollResults& results, std::string id, std::string claim, ClaimedRange range,
                       const char* other, std::string_view dataset) {
  ClaimCheck check{std::move(id), std::move(claim), "frame time by frame time", range, {}, {}, {}};
  for (const Table1Row& row : results.table1) {
    const Shot *peaks = row.shots.find("xor-paper"), *sampled = row.shots.find(other);
    if (peaks && sampled && row.paper.dataset.starts_with(dataset))
      check.evidence.push_back({row.shots.title, time_ratio(*peaks, *sampled)});
  }
  return judged(std::move(check), [&](const Evidence& e) { return samples_sentence(results, e, other); });
}

ClaimCheck skipping_claim(const KnollResults& results) {
  ClaimCheck check{"macrocells",
                   "Macrocells usually make rendering 1.2 to 5 times as fast",
                   "frame time without skipping by frame time with it",
                   {1.2, 5},
                   {},
                   {},
                   {}};
  std::string dense;
  for (const Table1Row& row : results.table1) {
    const Shot *skipping = row.shots.find("xor-paper"), *all = row.shots.find("xor-paper-all");
    if (!skipping || !all) continue;
    if (skipping->skips)
      check.evidence.push_back({row.shots.title, time_ratio(*all, *skipping)});
    else
      dense += (dense.empty() ? "" : ", ") + row.shots.title;
  }
  check = judged(std::move(check), [&](const Evidence& e) {
    const ShotGroup& shots = row_titled(results, e.of)->shots;
    const double all = shots.find("xor-paper-all")->samples_per_ray,
                 kept = shots.find("xor-paper")->samples_per_ray;
    return fmt::format("Skipping leaves {:.1f} of {:.1f} field values a ray there, {:.1f} times fewer.", kept,
                       all, all / kept);
  });
  if (!dense.empty()) check.why += fmt::format(" Not skipped, since hardly a macrocell is empty: {}.", dense);
  return check;
}

ClaimCheck sampling_claim(const KnollResults& results, std::string id, std::string claim, ClaimedRange range,
                          bool bspline) {
  ClaimCheck check{std::move(id), std::move(claim), "frames a second at the same error", range, {}, {}, {}};
  const auto is_meant = [&](const SamplingRow& row) {
    return row.held == HeldConstant::quality && row.method.ends_with("bspline") == bspline &&
           (bspline || row.scene.ends_with("close"));
  };
  const auto title = [&](const SamplingRow& row) {
    return fmt::format("{}, {}", title_of(results, row.scene), row.shots.title);
  };
  for (const SamplingRow& row : results.table2)
    if (is_meant(row)) check.evidence.push_back({title(row), row.speed_up()});
  return judged(std::move(check), [&](const Evidence& e) {
    const auto row = std::ranges::find_if(
        results.table2, [&](const SamplingRow& r) { return is_meant(r) && title(r) == e.of; });
    const Shot &uniform = row->uniform(), &differential = row->differential();
    const PaperSampling& paper = row->paper;
    const std::string papers = paper.samples_uniform > 0
                                   ? fmt::format(" (the paper, by eye: {:g} and {:g})", paper.samples_uniform,
                                                 paper.samples_differential)
                                   : "";
    return fmt::format(
        "For an RMSE of {:.2g} equal steps take {:.1f} field values a ray{}, differential ones {:.1f}{}. "
        "Unlike the "
        "eye, an RMSE does not ask whether a step is short near the eye or far from it.",
        differential.error.compared.rmse, uniform.samples_per_ray, row->reached ? "" : " and do not reach it",
        differential.samples_per_ray, papers);
  });
}

ClaimCheck four_peaks_claim(const KnollResults& results) {
  ClaimCheck check{"four-peaks",
                   "Finding up to four peaks in a step instead of one costs 20 to 30 %",
                   "frame time by frame time",
                   {1.2, 1.3, true},
                   {},
                   {},
                   {}};
  for (const Table1Row& row : results.table1)
    if (const Shot* single = row.shots.find("single"))
      check.evidence.push_back({row.shots.title, time_ratio(*row.shots.find("xor-paper"), *single)});
  return judged(std::move(check), [&](const Evidence& e) {
    const ShotGroup& shots = row_titled(results, e.of)->shots;
    return fmt::format(
        "{:.2f} crossings a ray are composited instead of {:.2f}, with {:.1f} field values instead of "
        "{:.1f}; "
        "the shader is the same, since up to four surfaces are tested all at once.",
        shots.find("xor-paper")->crossings_per_ray, shots.find("single")->crossings_per_ray,
        shots.find("xor-paper")->samples_per_ray, shots.find("single")->samples_per_ray);
  });
}

ClaimCheck bins_claim(const KnollResults& results) {
  ClaimCheck check{"bins",
                   "128 bins are enough for peak finding",
                   "crossings missed with 128 bins by those with 1024",
                   {1, 1, true},
                   {},
                   {},
                   {}};
  const ShotGroup* bins = results.bins ? &*results.bins : nullptr;
  const Shot *at_128 = bins ? bins->find("peaks-128") : nullptr,
             *at_1024 = bins ? bins->find("peaks-1024") : nullptr;
  if (!at_128 || !at_1024) return judged(std::move(check), [](const Evidence&) { return ""; });
  const auto missed = [](const Shot& shot) { return shot.error.crossings->missed + 1; };  // of none, too
  check.evidence.push_back({at_128->variant.name, missed(*at_128) / missed(*at_1024)});
  check = judged(std::move(check), [&](const Evidence&) {
    return std::string("A candidate of the table counts only where its own crossing is found.");
  });
  check.why +=
      fmt::format(" RMSE {:.3g} with 128 bins, {:.3g} with 1024; {:.2f} times the frame time.",
                  at_128->error.compared.rmse, at_1024->error.compared.rmse, time_ratio(*at_128, *at_1024));
  return check;
}

ClaimCheck build_claim(const KnollResults& results) {
  ClaimCheck check{"build",
                   "A peak table builds twice as fast as a pre-integrated one of the same resolution",
                   "build time by build time",
                   {2, 2},
                   {},
                   {},
                   {}};
  for (const TableBuild& build : results.builds)
    if (build.preintegration_ms > 0)
      check.evidence.push_back({fmt::format("{} bins", build.bins), build.ratio()});
  return judged(std::move(check), [&](const Evidence&) {
    return std::string(
        "A cell of the peak table is a run of the sorted peaks, two numbers that two prefix arrays hold; "
        "one of the pre-integrated table is the product of as many slabs as it reaches over.");
  });
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::better:
      return "better";
    case Verdict::worse:
      return "worse";
    case Verdict::not_measured:
      break;
  }
  return "not measured";
}

double ClaimCheck::least() const { return std::ranges::min_element(evidence, {}, &Evidence::value)->value; }
double ClaimCheck::greatest() const {
  return std::ranges::max_element(evidence, {}, &Evidence::value)->value;
}

Verdict judge(const ClaimedRange& paper, const std::vector<Evidence>& evidence) {
  if (evidence.empty()) return Verdict::not_measured;
  const auto beyond = [&](bool high) {
    return std::ranges::any_of(evidence, [&](const Evidence& e) {
      return high ? e.value > paper.high * (1 + claim_tolerance)
                  : e.value < paper.low * (1 - claim_tolerance);
    });
  };
  if (beyond(paper.less_is_better)) return Verdict::worse;
  return beyond(!paper.less_is_better) ? Verdict::better : Verdict::holds;
}

double time_ratio(const Shot& a, const Shot& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.frame_ms.size(), b.frame_ms.size()); ++i)
    ratios.push_back(a.frame_ms[i] / b.frame_ms[i]);
  return median(ratios);
}

std::vector<ClaimCheck> check_claims(const KnollResults& results) {
  return {
      ratio_claim(results, "xor-post",
                  "Peak finding takes 0.95 to 2.07 times the time of post-classification", {0.95, 2.07, true},
                  "post", ""),
      ratio_claim(results, "xor-post-heptane", "On heptane, 1.6 to 2.07 times", {1.6, 2.07, true}, "post",
                  "heptane"),
      ratio_claim(results, "xor-preintegrated",
                  "Peak finding takes 0.81 to 1.5 times the time of pre-integration", {0.81, 1.5, true},
                  "preintegrated", ""),
      ratio_claim(results, "xor-preintegrated-heptane", "On heptane, 1.2 to 1.5 times", {1.2, 1.5, true},
                  "preintegrated", "heptane"),
      skipping_claim(results),
      sampling_claim(results, "differential",
                     "Close up, differential sampling is up to 3 times as fast at equal quality", {1, 3},
                     false),
      sampling_claim(results, "differential-bspline", "With the B-spline, 1.5 to 3 times as fast", {1.5, 3},
                     true),
      four_peaks_claim(results),
      bins_claim(results),
      build_claim(results),
  };
}

}  // namespace crest
