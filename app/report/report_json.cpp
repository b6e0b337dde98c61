#include "app/report/report_json.h"

#include <fmt/core.h>

#include <algorithm>
#include <thread>

#include "app/report/report_pictures.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/preset_json.h"
#include "render/measure/flip.h"
#include "render/measure/method_convergence.h"
#include "render/measure/model_difference.h"
#include "render/measure/pareto.h"

namespace crest {
namespace {

constexpr std::string_view report_format = "crest-report";
constexpr int report_version = 1;

Json to_json(const PixelErrors& e) {
  return {{"pixels", e.pixels}, {"rmse", e.rmse},   {"max", e.max},
          {"p999", e.p999},     {"share", e.share}, {"flip", e.flip}};
}

Json to_json(const ImageError& e) {
  Json json{{"compared", to_json(e.compared)},
            {"grazing", to_json(e.grazing)},
            {"grazing_share", e.grazing_share()},
            {"crossings", nullptr}};
  if (e.crossings)
    json["crossings"] = {
        {"exact", e.crossings->exact}, {"missed", e.crossings->missed}, {"invented", e.crossings->invented}};
  for (const ErrorMeasure& measure : error_measures())
    json["measures"][measure.id] = measure.value(e);  // NaN, for what is not known, is written as null
  return json;
}

Json to_json(const Measurement& m, const Report& report, bool has_picture) {
  Json json{{"method", m.method},
            {"step", m.step > 0 ? Json(m.step) : Json()},
            {"why", name_of(m.why)},
            {"frame_ms", m.frame_ms},
            {"device_ms", m.device_ms},
            {"samples_per_ray", m.samples_per_ray},
            {"dvr_samples_per_ray", m.dvr_samples_per_ray},
            {"crossings_per_ray", m.crossings_per_ray},
            {"crossings_left_out_per_ray", m.crossings_left_out_per_ray},
            {"group", m.group},
            {"anchor_ms", m.anchor_ms},
            {"frame_ms_all", m.frame_ms_all},
            {"device_ms_all", m.device_ms_all},
            {"picture", has_picture ? Json(picture_name(m)) : Json()},
            {"errors", Json::array()}};
  for (const auto& [answer, error] : m.errors) {
    Json entry{{"answer", name_of(answer)}};
    entry.update(to_json(error));
    entry["picture"] = has_picture ? Json(error_picture_name(m, answer)) : Json();
    json["errors"].push_back(entry);
  }
  if (report.subject.render_command)
    json["command"] = report.subject.render_command(*find_method(m.method), m.step);
  return json;
}

Json index_or_null(const std::optional<std::size_t>& index) { return index ? Json(*index) : Json(); }

/// One exact answer: its picture, what lies on its front in each measure, and the cheapest under the target.
Json answer_json(const Report& report, const ExactAnswer& answer, const Reference& exact) {
  double crossings = 0;
  for (const std::uint32_t count : exact.crossings) crossings += count;
  Json json{{"name", name_of(answer)},
            {"own", answer == exact_answers_of(report.scene.rendering).front()},
            {"picture", exact_picture_name(answer)},
            {"crossings_per_ray", crossings / double(exact.pixels.size())},
            {"cheapest", index_or_null(cheapest_under(report.points, answer, report.settings.target))}};
  for (const ErrorMeasure& measure : error_measures())
    json["front"][measure.id] = pareto_front(report.points, answer, measure);
  json["model_difference"] = nullptr;
  if (const auto difference = model_difference(report.references, answer, report.scene.rendering)) {
    json["model_difference"] = to_json(*difference);
    json["model_difference"]["picture"] = difference_picture_name(answer);
  }
  return json;
}

Json convergence_json(const MethodConvergence& convergence) {
  Json json{{"answer", name_of(convergence.answer)},
            {"order", nullptr},
            {"cheapest", index_or_null(convergence.cheapest)},
            {"steady", convergence.steady}};
  if (const auto& fit = convergence.fit) {
    json["order"] = fit->order;
    json["fitted_from"] = fit->coarsest;
    json["fitted_to"] = fit->finest;
    json["fitted_points"] = fit->points;
  }
  return json;
}

Json method_json(const Report& report, const Method& method,
                 const std::vector<MethodConvergence>& convergences) {
  Json json{
      {"id", method.id}, {"name", method.name}, {"settings", method.settings}, {"limits", method.limits}};
  const auto start = std::ranges::find(report.starts, method.id, &MethodStart::method);
  json["first_frame_ms"] = start == report.starts.end() ? Json() : Json(start->first_frame_ms);
  json["edit_ms"] = start == report.starts.end() ? Json() : Json(start->edit_ms);
  json["started_at_step"] = start == report.starts.end() ? Json() : Json(start->step);
  json["convergence"] = Json::array();
  for (const MethodConvergence& convergence : convergences)
    if (convergence.method == method.id) json["convergence"].push_back(convergence_json(convergence));
  return json;
}

Json subject_json(const Report& report) {
  const Grid& grid = report.scene.volume->grid;
  return {{"volume", report.subject.volume},
          {"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
          {"preset", report.subject.preset},
          {"size", {report.size.x, report.size.y}},
          {"mode", name_of(report.scene.rendering.mode)},
          {"camera", camera_to_json(report.camera, Fields::all)},
          {"max_peaks", report.scene.rendering.max_peaks},
          {"peak_bins", report.scene.rendering.peak_bins}};
}

Json settings_json(const Report& report) {
  const SweepSettings& settings = report.settings;
  return {{"budget_seconds", settings.budget_seconds ? Json(*settings.budget_seconds) : Json()},
          {"target", {{"measure", settings.target.measure->id}, {"most", settings.target.most}}},
          {"frames", settings.frames},
          {"steps", sweep_steps()},
          {"shading", "none"},
          {"early_termination", 0},
          {"flip_pixels_per_degree", default_pixels_per_degree},
          {"rounding_rmse", rounding_rmse}};
}

}  // namespace

Json report_json(const Report& report) {
  Json json{{"format", report_format},
            {"version", report_version},
            {"command", report.subject.command},
            {"made_at", report.subject.made_at},
            {"complete", !report.stopped},
            {"seconds", report.seconds},
            {"reference_seconds", report.reference_seconds},
            {"renderer", report.subject.renderer},
            {"processors", std::thread::hardware_concurrency()}};
  json["scene"] = subject_json(report);
  json["settings"] = settings_json(report);
  for (const ErrorMeasure& measure : error_measures())
    json["measures"].push_back({{"id", measure.id}, {"name", measure.name}});
  json["answers"] = Json::array();
  for (const auto& [answer, exact] : report.references)
    json["answers"].push_back(answer_json(report, answer, exact));
  const auto convergences = convergence_of(report.points, report.settings.target);
  json["methods"] = Json::array();
  for (const Method& method : methods())
    if (std::ranges::any_of(report.points, [&](const auto& m) { return m.method == method.id; }))
      json["methods"].push_back(method_json(report, method, convergences));
  json["points"] = Json::array();
  for (std::size_t i = 0; i < report.points.size(); ++i)
    json["points"].push_back(to_json(report.points[i], report, report.pictures.contains(i)));
  json["error_scale"] = error_scale_json();
  json["left_out"] = Json::array();
  for (const LeftOut& left_out : report.left_out)
    json["left_out"].push_back({{"what", left_out.what}, {"why", left_out.why}});
  return json;
}

std::string report_csv(const Report& report) {
  std::string text =
      "method,step,answer,frame_ms,device_ms,samples_per_ray,dvr_samples_per_ray,crossings_per_ray,"
      "compared_pixels,grazing_pixels";
  for (const ErrorMeasure& measure : error_measures()) text += fmt::format(",{}", measure.id);
  text += "\n";
  for (const Measurement& m : report.points)
    for (const auto& [answer, error] : m.errors) {
      const std::string step = m.step > 0 ? fmt::format("{}", m.step) : "";
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}", m.method, step, name_of(answer), m.frame_ms,
                          m.device_ms, m.samples_per_ray, m.dvr_samples_per_ray, m.crossings_per_ray,
                          error.compared.pixels, error.grazing.pixels);
      for (const ErrorMeasure& measure : error_measures()) text += fmt::format(",{}", measure.value(error));
      text += "\n";
    }
  return text;
}

}  // namespace crest
