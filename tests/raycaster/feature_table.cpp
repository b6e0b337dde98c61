#include "tests/raycaster/feature_table.h"

#include "presets/names.h"

namespace crest::testing {
namespace {

Parameter<Features> flag(const char* name, bool Features::*feature) {
  return {
      name,
      {{"no", [=](Features& f) { f.*feature = false; }}, {"yes", [=](Features& f) { f.*feature = true; }}}};
}

Value<Features> dvr(const char* name, bool in, bool preintegrated, bool table) {
  return {name, [=](Features& f) {
            f.dvr = in;
            f.preintegrated = preintegrated;
            f.preintegration_table = table;
          }};
}

Value<Features> surfaces(const char* name, bool in, bool list, bool table) {
  return {name, [=](Features& f) {
            f.peaks = in;
            f.peak_list = list;
            f.peak_table = table;
          }};
}

Value<Features> peak_form(const char* name, bool split, bool exclusive) {
  return {name, [=](Features& f) {
            f.extrema = split && f.peaks;
            f.split = split && f.peaks && f.dvr;
            f.exclusive = exclusive;
          }};
}

Value<Features> sampling(std::string name, bool differential, bool footprint, Placement placement) {
  return {std::move(name), [=](Features& f) {
            f.differential = differential;
            f.footprint = footprint;
            f.placement = placement;
          }};
}

Parameter<Features> samplings() {
  Parameter<Features> parameter{"sampling", {}};
  for (const auto& [placement, name] : names_of<Placement>())
    parameter.values.push_back(sampling(std::string(name), false, false, placement));
  parameter.values.push_back(sampling("differential", true, false, Placement::entry_exit_corner));
  parameter.values.push_back(sampling("footprint", false, true, Placement::entry_exit_corner));
  return parameter;
}

Parameter<Features> filters() {
  Parameter<Features> parameter{"filter", {}};
  for (const auto& [filter, name] : names_of<Filter>())
    parameter.values.push_back({std::string(name), [=](Features& f) {
                                  if (!f.own_root_filter) f.root_filter = filter;
                                  f.filter = filter;
                                }});
  return parameter;
}

Parameter<Features> root_filters() {
  Parameter<Features> parameter{"root filter", {{"the filter", [](Features& f) {
                                                   f.own_root_filter = false;
                                                   f.root_filter = f.filter;
                                                 }}}};
  for (const auto& [filter, name] : names_of<Filter>())
    parameter.values.push_back({std::string(name), [=](Features& f) {
                                  f.own_root_filter = true;
                                  f.root_filter = filter;
                                }});
  return parameter;
}

Value<Features> gradient(const char* name, bool shading, bool by_filter) {
  return {name, [=](Features& f) {
            f.shading = shading;
            f.filter_gradient = by_filter;
          }};
}

Parameter<Features> blend_modes() {
  Parameter<Features> parameter{"illumination", {}};
  for (const auto& [blend_mode, name] : names_of<BlendMode>())
    parameter.values.push_back({std::string(name), [=](Features& f) { f.blend_mode = blend_mode; }});
  return parameter;
}

/// With what a ray has whether it is sampled or solved.
std::vector<Parameter<Features>> with_those_of_any_ray(std::vector<Parameter<Features>> parameters) {
  parameters.push_back(
      {"gradient",
       {gradient("none", false, false), gradient("central", true, false), gradient("filter", true, true)}});
  parameters.push_back(flag("early termination", &Features::early_termination));
  parameters.push_back(flag("skipping", &Features::skipping));
  parameters.push_back(flag("empty cells", &Features::empty_cells));
  parameters.push_back(flag("bricks", &Features::bricks));
  parameters.push_back(flag("whole values", &Features::whole_values));
  parameters.push_back(flag("long rays", &Features::long_rays));
  parameters.push_back(flag("statistics", &Features::statistics));
  return parameters;
}

std::vector<Parameter<Features>> parameters() {
  return {
      {"DVR",
       {dvr("none", false, false, false), dvr("samples", true, false, false),
        dvr("antiderivatives", true, true, false), dvr("table", true, true, true)}},
      {"surfaces",
       {surfaces("none", false, false, false), surfaces("single", true, false, false),
        surfaces("list", true, true, false), surfaces("table", true, false, true)}},
      {"peak form",
       {peak_form("split", true, false), peak_form("paper", false, false),
        peak_form("paper, exclusive", false, true)}},
      samplings(),
      filters(),
      root_filters(),
      blend_modes(),
      flag("several surfaces", &Features::several_peaks),
      flag("adaptive", &Features::adaptive),
  };
}

const std::vector<Rule> rules{
    {"DVR", {"none"}, "surfaces", {"single", "list", "table"}},
    {"DVR", {"none"}, "peak form", {"split", "paper"}},
    {"DVR", {"none"}, "root filter", {"the filter"}},
    {"DVR", {"table"}, "sampling", {"entry"}},
    {"DVR", {"table"}, "adaptive", {"no"}},
    {"surfaces", {"none"}, "peak form", {"split"}},
    {"surfaces", {"none"}, "root filter", {"the filter"}},
    {"surfaces", {"none"}, "several surfaces", {"no"}},
    {"root filter", {"linear"}, "filter", {"linear_exact", "bspline", "bc"}},
    {"root filter", {"linear_exact"}, "filter", {"linear", "bspline", "bc"}},
    {"root filter", {"bspline"}, "filter", {"linear", "linear_exact", "bc"}},
    {"root filter", {"bc"}, "filter", {"linear", "linear_exact", "bspline"}},
    {"illumination", {"lookup", "iso_surface", "maximum", "minimum", "mean"}, "DVR", {"samples"}},
    {"illumination", {"lookup", "iso_surface", "maximum", "minimum", "mean"}, "surfaces", {"none"}},
    {"illumination", {"maximum", "minimum", "mean"}, "skipping", {"no"}},
    {"illumination", {"maximum", "minimum", "mean"}, "gradient", {"none"}},
};

}  // namespace

Pairwise<Features> analytic_feature_table() {
  const auto shown = [](const char* name, bool in_dvr, bool in_peaks) -> Value<Features> {
    return {name, [=](Features& f) {
              f.analytic = true;
              f.dvr = in_dvr;
              f.peaks = in_peaks;
            }};
  };
  const auto trilinear = [](const char* name, Filter filter) -> Value<Features> {
    return {name, [=](Features& f) { f.filter = f.root_filter = filter; }};
  };
  const Parameter<Features> modes{"shown",
                                  {shown("DVR", true, false), shown("peaks", false, true),
                                   shown("both", true, true), shown("neither", false, false)}};
  const Parameter<Features> fields{
      "filter", {trilinear("linear", Filter::linear), trilinear("linear_exact", Filter::linear_exact)}};
  return {with_those_of_any_ray({modes, fields}), {}};
}

Pairwise<Features> feature_table() { return {with_those_of_any_ray(parameters()), rules}; }

}  // namespace crest::testing
