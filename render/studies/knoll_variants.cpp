#include "render/studies/knoll_variants.h"

#include <fmt/format.h>

namespace crest {
namespace {

constexpr const char* published = "mode=PEAK_XOR_DVR peak_form=paper sampling=differential s_k=4";

}  // namespace

std::vector<Variant> table1_variants() {
  return {{"post", "post-classification", "mode=DVR_ONLY sampling=differential s_k=4"},
          {"xor-paper", "peak finding, as published", published},
          {"xor", "peak finding, divided steps", "mode=PEAK_XOR_DVR sampling=differential s_k=4"},
          {"preintegrated", "pre-integration, antiderivatives",
           "mode=DVR_ONLY classification=preintegrated sampling=differential s_k=4"},
          {"xor-paper-all", "peak finding, as published, nothing skipped",
           fmt::format("{} skipping=false", published)}};
}

Variant preintegrated_table_variant(double step) {
  return {"preintegrated-table", fmt::format("pre-integration, table, equal steps of {:.3g}", step),
          fmt::format("mode=DVR_ONLY classification=preintegrated_table placement=entry step={}", step)};
}

Variant surfaces_variant() {
  return {"peaks-paper", "surfaces alone", "mode=PEAK_ONLY peak_form=paper sampling=differential s_k=4"};
}

Variant single_peak_variant() {
  return {"single", "a single peak a step", fmt::format("{} max_peaks=1", published)};
}

Variant magnified_variant() { return {"peaks-x16", "peaks with 16 times the opacity", published, 16}; }

std::vector<Variant> sampling_methods() {
  return {{"post", "post-classification", "mode=DVR_ONLY"},
          {"xor", "peak finding", "mode=PEAK_XOR_DVR"},
          {"xor-bspline", "peak finding, B-spline", "mode=PEAK_XOR_DVR filter=bspline"}};
}

Variant post_bspline_method() {
  return {"post-bspline", "post-classification, B-spline", "mode=DVR_ONLY filter=bspline"};
}

std::vector<Variant> bins_variants() {
  std::vector<Variant> variants;
  for (const int bins : studied_bins)
    variants.push_back({fmt::format("peaks-{}", bins), fmt::format("peak table, {} bins", bins),
                        fmt::format("{} peak_bins={}", published, bins)});
  for (const int bins : studied_bins)
    variants.push_back(
        {fmt::format("preintegrated-{}", bins), fmt::format("pre-integration table, {} bins", bins),
         fmt::format("mode=DVR_ONLY classification=preintegrated_table placement=entry step=0.5 "
                     "preintegration_bins={}",
                     bins)});
  return variants;
}

}  // namespace crest
