#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "app/report/knoll_study.h"
#include "render/studies/knoll/variants.h"

namespace crest {
namespace {

/// Some work that is done whole or left out.
struct Task {
  std::string what;
  std::function<void()> work;
};

struct Measuring {
  KnollLab& lab;
  KnollScenes& scenes;
  KnollResults results;

  double s_k() const { return s_k_of_paper(lab.settings().size.x); }
  KnollScene scene(std::string_view id) {
    const auto found = std::ranges::find(results.scenes, id, &KnollScene::id);
    if (found != results.scenes.end()) return *found;
    return results.scenes.emplace_back(scenes.make(knoll_scene_row(id)));
  }
  void add_table1_row(const KnollSceneRow& row);
  void add_bins();
  void add_builds();
  void add_sampling(HeldConstant held, std::string_view scene, const Variant& method, PaperSampling paper);
};

/// Equal steps that are as many as the differential ones, with a table for that step.
Variant table_of_equal_samples(KnollLab& lab, const KnollScene& scene, const Variant& differential) {
  const auto samples = [&](const Variant& variant) { return lab.counts(scene, variant).dvr_samples; };
  const double wanted = samples(differential);
  double step = 1;
  for (int turn = 0; turn < 2 && wanted > 0; ++turn)
    step = std::clamp(step * samples(preintegrated_table_variant(step)) / wanted, shortest_uniform_step,
                      longest_uniform_step);
  return preintegrated_table_variant(step);
}

void Measuring::add_table1_row(const KnollSceneRow& row) {
  const KnollScene of = scene(row.id);
  std::vector<Variant> variants = table1_variants(s_k());
  variants.push_back(table_of_equal_samples(lab, of, variants.front()));
  if (row.id == "zebrafish") variants.push_back(surfaces_variant(s_k()));
  if (row.id == "heptane-5b") variants.push_back(single_peak_variant(s_k()));
  if (row.id == "heptane-5c")
    variants.insert(variants.end(), {magnified_variant(s_k()), surfaces_variant(s_k())});
  const auto is_pictured = [&](const Variant& variant) { return is_in_figures(of.id, variant.id); };
  results.table1.push_back({row.paper, lab.shoot_group(of.id, of.title, of, variants, is_pictured)});
}

void Measuring::add_bins() {
  const KnollScene of = scene("many-peaks");
  results.bins =
      lab.shoot_group("bins", of.title, of, bins_variants(s_k()), [](const Variant&) { return false; });
}

void Measuring::add_builds() {
  const Scene of = scene("many-peaks").scene;
  results.builds = time_table_builds(of.tf, of.volume->statistics.range, of.volume->grid.smallest_spacing(),
                                     std::span(studied_bins).subspan(2));
}

void Measuring::add_sampling(HeldConstant held, std::string_view id, const Variant& method,
                             PaperSampling paper) {
  const bool with_pictures = is_in_figures(sampling_group_id(held, id, method.id), "uniform");
  SamplingRow row = compare_sampling(lab, scene(id), held, method, with_pictures);
  row.paper = paper;
  results.table2.push_back(std::move(row));
}

/// Table 2, as printed: a row's columns are post-classification, peak finding, and that with the B-spline.
struct PaperTable2Row {
  HeldConstant held;
  const char* scene;
  PaperSampling columns[3];
};
constexpr PaperTable2Row paper_table2[] = {
    {HeldConstant::quality,
     "aneurism-close",
     {{2.0, 6.4, 1433, 483}, {2.4, 4.2, 1419, 700}, {0.42, 0.80, 1854, 964}}},
    {HeldConstant::quality,
     "fireset-close",
     {{1.1, 3.1, 2123, 772}, {2.2, 4.6, 1441, 527}, {0.42, 0.77, 1568, 576}}},
    {HeldConstant::quality,
     "aneurism-far",
     {{5.8, 13, 343, 113}, {4.3, 7.1, 471, 174}, {0.86, 1.8, 372, 157}}},
    {HeldConstant::quality,
     "backpack-far",
     {{2.7, 2.4, 640, 748}, {1.6, 1.6, 1794, 1865}, {0.36, 0.43, 822, 720}}},
    {HeldConstant::frame_rate,
     "aneurism-close",
     {{7.4, 8.7, 361, 342}, {5.6, 5.3, 580, 561}, {1.0, 1.1, 770, 827}}},
    {HeldConstant::frame_rate,
     "fireset-close",
     {{4.8, 5.1, 396, 380}, {3.6, 4.1, 509, 528}, {0.96, 0.96, 408, 494}}},
};
/// Of fig. 7's caption.
constexpr PaperSampling paper_post_bspline{1.0, 2.7, 0, 0};

std::vector<Task> table2_tasks(Measuring& m, HeldConstant held) {
  std::vector<Task> tasks;
  const auto add = [&](const char* scene, const Variant& method, const PaperSampling& paper) {
    tasks.push_back({fmt::format("table 2, {}: {}, {}",
                                 held == HeldConstant::quality ? "equal quality" : "equal frame rate", scene,
                                 method.name),
                     [&m, held, scene, method, paper] { m.add_sampling(held, scene, method, paper); }});
  };
  for (const PaperTable2Row& row : paper_table2) {
    if (row.held != held) continue;
    const auto methods = sampling_methods();
    for (std::size_t i = 0; i < methods.size(); ++i) add(row.scene, methods[i], row.columns[i]);
    if (row.scene == std::string_view("aneurism-far"))
      add(row.scene, post_bspline_method(), paper_post_bspline);
  }
  return tasks;
}

/// The most informative first.
std::vector<Task> all_tasks(Measuring& m) {
  std::vector<Task> tasks;
  for (const KnollSceneRow& row : knoll_scene_rows())
    if (!row.paper.dataset.empty())
      tasks.push_back({fmt::format("table 1: {}", row.title), [&m, &row] { m.add_table1_row(row); }});
  tasks.push_back({"the tables' build times", [&m] { m.add_builds(); }});
  tasks.push_back({"the tables' bins", [&m] { m.add_bins(); }});
  for (const HeldConstant held : {HeldConstant::quality, HeldConstant::frame_rate})
    for (Task& task : table2_tasks(m, held)) tasks.push_back(std::move(task));
  return tasks;
}

}  // namespace

KnollResults measure_knoll(KnollLab& lab, KnollScenes& scenes, std::optional<double> budget_seconds,
                           const std::function<void(const std::string&)>& tell) {
  using Clock = std::chrono::steady_clock;
  Measuring measuring{lab, scenes, {}};
  const auto begin = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  double last_task = 0;
  for (const Task& task : all_tasks(measuring)) {
    const double now = seconds();
    if (budget_seconds && now + last_task >= *budget_seconds) {
      measuring.results.left_out.push_back({task.what, "the budget had no time for it"});
      continue;
    }
    tell(task.what);
    task.work();
    last_task = seconds() - now;
  }
  return std::move(measuring.results);
}

}  // namespace crest
