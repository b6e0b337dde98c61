#include <fmt/core.h>

#include <thread>

#include "app/report/report_pictures.h"
#include "app/report/vdls_study.h"
#include "presets/json.h"

namespace crest {
namespace {

Json to_json(const VdlsReport::Difference& difference) {
  return {{"same_gradients", difference.same_gradients}, {"gradient_volume", difference.gradient_volume}};
}

Json to_json(const VdlsTiming& timing) {
  return {{"setup", timing.setup},          {"views", timing.frame_ms.size()},
          {"frame_ms", timing.mean_ms()},   {"frames_per_second", timing.frames_per_second()},
          {"samples", timing.samples},      {"samples_per_second", timing.samples_per_second()},
          {"frame_ms_all", timing.frame_ms}};
}

Json to_json(const std::vector<VdlsTiming>& timings) {
  Json json = Json::array();
  for (const VdlsTiming& timing : timings) json.push_back(to_json(timing));
  return json;
}

Json to_json(const VdlsScale& scale, const std::string& setup, const LineFit& fit) {
  const Growth growth = growth_of(fit);
  return {{"scale", scale.name},
          {"power", scale.power},
          {"setup", setup},
          {"fixed_ms", fit.fixed_ms},
          {"ms_per_unit", fit.ms_per_unit},
          {"fixed_share", fit.fixed_share},
          {"largest_residual", fit.largest_residual},
          {"growth", growth == Growth::proportional ? "proportional"
                     : growth == Growth::linear     ? "linear"
                                                    : "other"}};
}

Json to_json(const VdlsSeries& series) {
  Json json{{"id", series.id}, {"title", series.title}, {"x_title", series.x_title}};
  for (const VdlsSeries::Point& point : series.points)
    json["points"].push_back({{"x", point.x}, {"label", point.label}, {"timings", to_json(point.timings)}});
  for (const VdlsScale& scale : series.scales)
    for (std::size_t i = 0; i < series.points.front().timings.size(); ++i)
      json["fits"].push_back(
          to_json(scale, series.points.front().timings[i].setup, fit_line(series, i, scale.power)));
  return json;
}

Json to_json(const VdlsReport::Quadtree& quadtree) {
  Json json{{"title", quadtree.title}, {"picture", quadtree.picture}, {"nodes", Json::array()}};
  for (const ScreenNode& node : quadtree.nodes)
    json["nodes"].push_back({node.begin.x, node.begin.y, node.side, node.layers});
  return json;
}

Json to_json(const VdlsReport::Quality& quality) {
  return {{"name", quality.name},          {"samples_per_voxel", quality.samples_per_voxel},
          {"picture", quality.picture},    {"error_picture", quality.error_picture},
          {"rmse", quality.error.rmse},    {"max", quality.error.max},
          {"share", quality.error.share},  {"flip", quality.error.flip},
          {"pixels", quality.error.pixels}};
}

}  // namespace

Json vdls_json(const VdlsReport& report) {
  Json json{{"format", "crest-vdls-study"},
            {"version", 1},
            {"command", report.command},
            {"made_at", report.made_at},
            {"renderer", report.renderer},
            {"processors", std::thread::hardware_concurrency()},
            {"size", {report.size.x, report.size.y}}};
  for (const VdlsReport::Row& row : report.table)
    json["table"].push_back({{"id", row.id},
                             {"title", row.title},
                             {"dims", {row.dims.x, row.dims.y, row.dims.z}},
                             {"vdls_bytes", row.vdls_bytes},
                             {"raycaster_bytes", row.raycaster_bytes},
                             {"largest_difference", to_json(row.difference)},
                             {"timings", to_json(row.timings)}});
  for (const VdlsSeries& series : report.series) json["series"].push_back(to_json(series));
  for (const auto& quadtree : report.quadtrees) json["quadtrees"].push_back(to_json(quadtree));
  for (const auto& filter : report.filters)
    json["filters"].push_back({{"name", filter.name}, {"largest_difference", to_json(filter.difference)}});
  json["phantom"] = report.phantom;
  for (const auto& quality : report.quality) json["quality"].push_back(to_json(quality));
  json["error_scale"] = error_scale_json();
  return json;
}

}  // namespace crest
