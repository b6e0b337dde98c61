#include <fmt/core.h>

#include <thread>

#include "app/report/placement_study.h"
#include "app/report/report_pictures.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

Json order_json(const std::optional<OrderFit>& fit) { return fit ? Json(fit->order) : Json(); }

Json to_json(const PlaneErrors& e) {
  return {{"max", e.max},           {"rms", e.rms},   {"least", e.least},
          {"greatest", e.greatest}, {"rays", e.rays}, {"unsampled", e.unsampled}};
}

Json to_json(const PlaneSeries& series) {
  Json json{{"field", series.field},
            {"sum", name_of(series.sum)},
            {"placement", name_of(series.placement)},
            {"max_order", order_json(series.max_order)},
            {"rms_order", order_json(series.rms_order)},
            {"runs", Json::array()}};
  for (const PlaneMeasurement& m : series.measurements)
    json["runs"].push_back({{"rate", m.rate},
                            {"errors", to_json(m.errors)},
                            {"dense_errors", to_json(m.dense_errors)},
                            {"intensities", m.intensities}});
  return json;
}

Json to_json(const PlaneStudy& plane) {
  Json json{{"rays", paper_rays}, {"dense_rays", dense * paper_rays}, {"spacing", Square::spacing}};
  for (int i = 0; i < paper_rays; ++i) json["angles_degrees"].push_back(fan_angle_degrees(i));
  for (const PlaneStudy::Field& field : plane.fields)
    json["fields"].push_back({{"name", field.name}, {"exact", field.exact}});
  for (const PlaneSeries& series : plane.series) json["series"].push_back(to_json(series));
  return json;
}

Json to_json(const VolumePlacement& placement, const std::string& id) {
  Json json{{"placement", name_of(placement.placement)},
            {"order", order_json(placement.order)},
            {"picture", placement_picture_name(id, placement.placement)},
            {"error_picture", placement_error_picture_name(id, placement.placement)}};
  for (const auto& [step, error, samples] : placement.points) {
    Json point{{"step", step}, {"pixels", error.compared.pixels}, {"dvr_samples_per_ray", samples}};
    point["rmse"] = error.compared.rmse;
    point["max"] = error.compared.max;
    point["share"] = error.compared.share;
    point["flip"] = error.compared.flip;
    json["points"].push_back(point);
  }
  return json;
}

Json to_json(const VolumeStudy& study) {
  const auto& [id, title, note, scene, camera] = study.scene;
  const glm::ivec3 dims = scene.volume->grid.dims;
  Json json{{"id", id},
            {"title", title},
            {"note", note},
            {"dims", {dims.x, dims.y, dims.z}},
            {"size", {study.size.x, study.size.y}},
            {"camera", camera_to_json(camera, Fields::all)},
            {"clip_box", nullptr},
            {"exact_picture", placement_exact_picture_name(id)}};
  if (const auto& box = scene.rendering.clip_box)
    json["clip_box"] = {{"min", {box->min.x, box->min.y, box->min.z}},
                        {"max", {box->max.x, box->max.y, box->max.z}}};
  for (const VolumePlacement& placement : study.placements)
    json["placements"].push_back(to_json(placement, id));
  return json;
}

Json time_json(const PlacementReport& report) {
  Json json{{"scene", report.timed_scene},
            {"step", report.timed_step},
            {"size", {report.timed_size.x, report.timed_size.y}}};
  for (const PlacementTime& time : report.times)
    json["placements"].push_back({{"placement", name_of(time.placement)},
                                  {"control", time.is_control},
                                  {"frame_ms", time.median_ms},
                                  {"ratio", time.ratio},
                                  {"dvr_samples_per_ray", time.dvr_samples_per_ray},
                                  {"frame_ms_all", time.frame_ms}});
  return json;
}

}  // namespace

Json placement_json(const PlacementReport& report) {
  Json json{{"format", "crest-placement-study"},
            {"version", 1},
            {"command", report.command},
            {"made_at", report.made_at},
            {"renderer", report.renderer},
            {"processors", std::thread::hardware_concurrency()},
            {"pictured_step", pictured_step},
            {"plane", to_json(report.plane)},
            {"distance_from_plane", report.distance_from_plane}};
  for (const VolumeStudy& volume : report.volumes) json["volumes"].push_back(to_json(volume));
  for (const ClipDifference& clip : report.clip_against_crop)
    json["clip_against_crop"].push_back({{"placement", name_of(clip.placement)},
                                         {"max", clip.max},
                                         {"share", clip.share},
                                         {"pixels", clip.pixels}});
  json["times"] = time_json(report);
  json["error_scale"] = error_scale_json();
  return json;
}

std::string placement_csv(const PlacementReport& report) {
  std::string text = "field,sum,placement,rate,ray,angle_degrees,intensity,exact\n";
  for (const PlaneSeries& series : report.plane.series)
    for (const PlaneMeasurement& m : series.measurements)
      for (const PlaneStudy::Field& field : report.plane.fields)
        for (int ray = 0; field.name == series.field && ray < paper_rays; ++ray)
          text += fmt::format("{},{},{},{},{},{},{},{}\n", series.field, name_of(series.sum),
                              name_of(series.placement), m.rate, ray, fan_angle_degrees(ray),
                              m.intensities[std::size_t(ray)], field.exact[std::size_t(ray)]);
  return text;
}

}  // namespace crest
