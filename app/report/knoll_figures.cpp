#include <fmt/core.h>

#include <algorithm>

#include "app/report/knoll_study.h"

namespace crest {

std::vector<KnollFigure> knoll_figures() {
  return {
      {"3",
       "A near-Dirac peak in red and a smooth feature in blue",
       "The integral of so narrow a peak is next to nothing, and pre-integration that is exact in a bin "
       "shows no more of it. The "
       "paper's shows a surface there, whose opacity it calls skewed.",
       {{"peak finding", "heptane-3", "xor-paper", 7.1},
        {"post-classification", "heptane-3", "post", 11.6},
        {"pre-integration", "heptane-3", "preintegrated", 8.8},
        {"pre-integration by a table", "heptane-3", "preintegrated-table", 0}}},
      {"4",
       "Narrow bands in entropic data",
       "",
       {{"peak finding", "zebrafish", "xor-paper", 2.1},
        {"pre-integration", "zebrafish", "preintegrated", 2.0},
        {"surfaces alone", "zebrafish", "peaks-paper", 4.3}}},
      {"5, left",
       "A single peak a step, and up to four",
       "",
       {{"a: single", "heptane-5b", "single", 10.7}, {"b: multiple", "heptane-5b", "xor-paper", 8.2}}},
      {"5, right",
       "The bias of always sampling at peaks",
       "The paper shows c and e to be nearly the same. By how much the exact answers of both differ is told "
       "below the error of c.",
       {{"c: peak finding", "heptane-5c", "xor-paper", 11.7},
        {"d: peaks × 16", "heptane-5c", "peaks-x16", 13.6},
        {"e: post-classification", "heptane-5c", "post", 20.5},
        {"f: surfaces alone", "heptane-5c", "peaks-paper", 15.6}}},
      {"6, top",
       "Close up at the same frame rate: aneurism, uniform and differential",
       "",
       {{"post-classification, uniform", "aneurism-close-post-frame-rate", "uniform", 7.4},
        {"post-classification, differential", "aneurism-close-post-frame-rate", "differential", 8.7},
        {"peak finding, uniform", "aneurism-close-xor-frame-rate", "uniform", 5.6},
        {"peak finding, differential", "aneurism-close-xor-frame-rate", "differential", 5.3},
        {"B-spline, uniform", "aneurism-close-xor-bspline-frame-rate", "uniform", 1.0},
        {"B-spline, differential", "aneurism-close-xor-bspline-frame-rate", "differential", 1.1}}},
      {"6, bottom",
       "Close up at the same frame rate: fireset, uniform and differential",
       "",
       {{"post-classification, uniform", "fireset-close-post-frame-rate", "uniform", 4.8},
        {"post-classification, differential", "fireset-close-post-frame-rate", "differential", 5.1},
        {"peak finding, uniform", "fireset-close-xor-frame-rate", "uniform", 3.6},
        {"peak finding, differential", "fireset-close-xor-frame-rate", "differential", 4.1},
        {"B-spline, uniform", "fireset-close-xor-bspline-frame-rate", "uniform", 0.96},
        {"B-spline, differential", "fireset-close-xor-bspline-frame-rate", "differential", 0.96}}},
      {"7",
       "Far views at the same quality, uniform and differential",
       "",
       {{"a: aneurism, B-spline, uniform", "aneurism-far-post-bspline-quality", "uniform", 1.0},
        {"b: aneurism, B-spline, differential", "aneurism-far-post-bspline-quality", "differential", 2.7},
        {"c: backpack, uniform", "backpack-far-xor-quality", "uniform", 1.6},
        {"d: backpack, differential", "backpack-far-xor-quality", "differential", 1.6}}},
  };
}

std::string knoll_picture_name(const KnollPanel& panel) {
  return fmt::format("images/{}-{}.png", panel.group, panel.variant);
}

std::string knoll_error_picture_name(const KnollPanel& panel) {
  return fmt::format("images/{}-{}-error.png", panel.group, panel.variant);
}

std::string knoll_preset_name(const KnollScene& scene) { return fmt::format("presets/{}.json", scene.id); }

bool is_in_figures(std::string_view group, std::string_view variant) {
  return std::ranges::any_of(knoll_figures(), [&](const KnollFigure& figure) {
    return std::ranges::any_of(figure.panels,
                               [&](const KnollPanel& p) { return p.group == group && p.variant == variant; });
  });
}

const Shot* find_shot(const KnollResults& results, std::string_view group, std::string_view variant) {
  for (const Table1Row& row : results.table1)
    if (row.shots.id == group) return row.shots.find(variant);
  for (const SamplingRow& row : results.table2)
    if (row.shots.id == group) return row.shots.find(variant);
  return nullptr;
}

}  // namespace crest
