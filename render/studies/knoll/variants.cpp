#include "render/studies/knoll/variants.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace crest {
namespace {

std::string differential(std::string_view settings, double s_k) {
  return fmt::format("{} sampling=differential s_k={}", settings, s_k);
}

/// Peak finding as published.
std::string published(double s_k) { return differential("mode=PEAK_XOR_DVR peak_form=paper", s_k); }

}  // namespace

double s_k_of_paper(int width) { return 4.0 * width / paper_width; }

std::vector<Variant> table1_variants(double s_k) {
  return {
      {"post", "post-classification", differential("mode=DVR_ONLY", s_k)},
      {"xor-paper", "peak finding, as published", published(s_k)},
      {"xor", "peak finding, divided steps", differential("mode=PEAK_XOR_DVR", s_k)},
      {"preintegrated", "pre-integration, antiderivatives",
       differential("mode=DVR_ONLY classification=preintegrated", s_k)},
      {"xor-paper-all", "peak finding, as published, nothing skipped", published(s_k) + " skipping=false"}};
}

Variant preintegrated_table_variant(double step) {
  return {"preintegrated-table", fmt::format("pre-integration, table, equal steps of {:.3g}", step),
          fmt::format("mode=DVR_ONLY classification=preintegrated_table placement=entry step={}", step)};
}

Variant surfaces_variant(double s_k) {
  return {"peaks-paper", "surfaces alone", differential("mode=PEAK_ONLY peak_form=paper", s_k)};
}

Variant single_peak_variant(double s_k) {
  return {"single", "a single peak a step", published(s_k) + " max_peaks=1"};
}

Variant magnified_variant(double s_k) {
  return {"peaks-x16", "peaks with 16 times the opacity", published(s_k), 16};
}

std::vector<Variant> sampling_methods() {
  return {{"post", "post-classification", "mode=DVR_ONLY"},
          {"xor", "peak finding", "mode=PEAK_XOR_DVR"},
          {"xor-bspline", "peak finding, B-spline", "mode=PEAK_XOR_DVR filter=bspline"}};
}

Variant post_bspline_method() {
  return {"post-bspline", "post-classification, B-spline", "mode=DVR_ONLY filter=bspline"};
}

std::vector<Variant> bins_variants(double s_k) {
  std::vector<Variant> variants;
  for (const int bins : studied_bins)
    variants.push_back({fmt::format("peaks-{}", bins), fmt::format("peak table, {} bins", bins),
                        fmt::format("{} peak_bins={}", published(s_k), bins)});
  for (const int bins : studied_bins)
    variants.push_back(
        {fmt::format("preintegrated-{}", bins), fmt::format("pre-integration table, {} bins", bins),
         fmt::format("mode=DVR_ONLY classification=preintegrated_table placement=entry step=0.5 "
                     "preintegration_bins={}",
                     bins)});
  return variants;
}

}  // namespace crest
