#include <fmt/core.h>

#include <cmath>
#include <thread>

#include "app/report/random_study.h"
#include "presets/json.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

Json step_json(double step) { return step > 0 ? Json(step) : Json(); }

Json crossings_json(const std::optional<ImageError::Crossings>& crossings) {
  if (!crossings) return {};
  return {{"exact", crossings->exact}, {"missed", crossings->missed}, {"invented", crossings->invented}};
}

Json to_json(const RandomScene& scene, int index, const RandomSceneStudy& study) {
  const Grid& grid = scene.scene.volume->grid;
  Json json{{"index", index},
            {"field", scene.field},
            {"features", scene.features},
            {"view", scene.view},
            {"labels", scene.labels},
            {"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
            {"points", scene.scene.tf.points.size()},
            {"camera", camera_to_json(scene.camera, Fields::all)},
            {"picture", random_picture_name(index)},
            {"left_out", Json::array()}};
  for (const LeftOut& left_out : study.left_out)
    json["left_out"].push_back({{"what", left_out.what}, {"why", left_out.why}});
  return json;
}

Json to_json(const StepSummary& s) {
  return {{"step", step_json(s.step)},
          {"scenes", s.scenes},
          {"pixels", s.pixels},
          {"wrong", s.wrong},
          {"within", s.within()},
          {"worst_scene", s.worst_scene < 0 ? Json() : Json(s.worst_scene)},
          {"worst_within", s.worst_scene < 0 ? Json() : Json(s.worst_within)},
          {"rmse", s.rmse},
          {"max", s.max},
          {"outliers", s.outliers},
          {"crossings", crossings_json(s.crossings)}};
}

Json to_json(const MethodSummary& summary) {
  Json json{{"method", summary.method}, {"answer", name_of(summary.answer)}, {"orders", Json::array()}};
  for (const StepSummary& step : summary.steps) json["steps"].push_back(to_json(step));
  for (const auto& order : summary.orders) json["orders"].push_back(order ? Json(*order) : Json());
  return json;
}

Json to_json(const SceneGroup& group) {
  Json json{{"id", group.id}, {"title", group.title}, {"scenes", group.scenes}, {"summaries", Json::array()}};
  for (const MethodSummary& summary : group.summaries) json["summaries"].push_back(to_json(summary));
  const MethodSummary* best = best_sampled(group.summaries);
  json["best_sampled"] = best ? Json(best->method) : Json();
  return json;
}

Json to_json(const RandomMeasurement& m) {
  const PixelErrors& e = m.error.compared;
  return {{"scene", m.scene},
          {"method", m.method},
          {"step", step_json(m.step)},
          {"answer", name_of(m.answer)},
          {"pixels", e.pixels},
          {"grazing_pixels", m.error.grazing.pixels},
          {"wrong", m.wrong},
          {"within", e.pixels == 0 ? Json() : Json(1 - e.share)},
          {"rmse", e.rmse},
          {"max", e.max},
          {"outliers", m.outliers},
          {"worst_pixel", {m.worst.x, m.worst.y}},
          {"crossings", crossings_json(m.error.crossings)}};
}

std::string percent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.3f}", 100 * share); }

/// A line of the table: a method against an answer.
std::string line_of(const MethodSummary& summary) {
  constexpr std::size_t columns = std::size(random_study_steps);
  const auto& steps = summary.steps;
  std::string text = fmt::format("{:<17} {:<31}", summary.method, name_of(summary.answer));
  for (std::size_t i = 0; i < columns; ++i)
    text += fmt::format(" {:>8}", i < steps.size() ? percent(steps[i].within()) : "");
  const StepSummary& last = steps.back();
  text += last.worst_scene < 0 ? fmt::format(" {:>8} {:>5}", "-", "-")
                               : fmt::format(" {:>8} {:>5}", percent(last.worst_within), last.worst_scene);
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    const bool is_known = i < summary.orders.size() && summary.orders[i];
    text += fmt::format(" {:>5}", is_known ? fmt::format("{:.1f}", *summary.orders[i]) : "-");
  }
  for (std::size_t i = 0; i < columns; ++i)
    text += fmt::format(" {:>5}", i < steps.size() ? fmt::format("{}", steps[i].outliers) : "");
  if (const auto& crossings = steps.back().crossings)
    text += fmt::format(" {:>11}", fmt::format("{}/{}", crossings->missed, crossings->invented));
  return text + "\n";
}

std::string best_of(const SceneGroup& group) {
  const MethodSummary* best = best_sampled(group.summaries);
  if (!best) return "";
  std::string text = fmt::format("Best of the sampled methods of PEAK_XOR_DVR: {}:", best->method);
  for (const StepSummary& step : best->steps)
    text += fmt::format(" {} % at 1/{:g}{}", percent(step.within()), 1 / step.step,
                        &step == &best->steps.back() ? "\n" : ",");
  return text;
}

std::string head_of_table() {
  return fmt::format("{:<17} {:<31} {:>8} {:>8} {:>8} {:>8} {:>5} {:>5} {:>5} {:>5} {:>5} {:>5} {:>11}\n",
                     "method", "against", "1/2", "1/8", "1/32", "worst", "scene", "order", "order", "1/2",
                     "1/8", "1/32", "missed/inv.");
}

/// Methods without steps should be right everywhere: where one is not, the pixel that is off furthest.
std::string faults_of(const RandomReport& report) {
  std::string text;
  for (const RandomSceneStudy& study : report.studies)
    for (const RandomMeasurement& m : study.measurements) {
      if (m.step > 0 || m.wrong == 0) continue;
      text += fmt::format(
          "{} is wrong in scene {} of seed {}: {} of {} pixels off by more than 1/255, "
          "by {:.3g} at ({}, {}) against {}\n",
          m.method, m.scene, report.seed, m.wrong, m.error.compared.pixels, m.error.compared.max, m.worst.x,
          m.worst.y, name_of(m.answer));
    }
  return text.empty() ? "Methods without steps: no pixel is off by more than 1/255.\n" : text;
}

}  // namespace

Json random_json(const RandomReport& report) {
  Json json{{"format", "crest-random-study"},
            {"version", 1},
            {"command", report.command},
            {"made_at", report.made_at},
            {"renderer", report.renderer},
            {"processors", std::thread::hardware_concurrency()},
            {"seconds", report.seconds},
            {"seed", report.seed},
            {"size", {report.size.x, report.size.y}},
            {"steps", random_study_steps},
            {"outlier_difference", outlier_difference},
            {"scenes_of_seed", random_scene_count}};
  for (const Method& method : methods())
    json["methods"].push_back(
        {{"id", method.id}, {"name", method.name}, {"settings", method.settings}, {"limits", method.limits}});
  for (int i = 0; i < int(report.scenes.size()); ++i)
    json["scenes"].push_back(to_json(report.scenes[std::size_t(i)], i, report.studies[std::size_t(i)]));
  for (const SceneGroup& group : groups_of(report)) json["groups"].push_back(to_json(group));
  for (const RandomSceneStudy& study : report.studies)
    for (const RandomMeasurement& m : study.measurements) json["measurements"].push_back(to_json(m));
  return json;
}

std::string random_csv(const RandomReport& report) {
  std::string text =
      "seed,scene,field,features,view,method,step,answer,pixels,grazing_pixels,within,rmse,max,outliers,"
      "crossings,missed,invented,worst_x,worst_y\n";
  for (const RandomSceneStudy& study : report.studies)
    for (const RandomMeasurement& m : study.measurements) {
      const RandomScene& scene = report.scenes[std::size_t(m.scene)];
      const PixelErrors& e = m.error.compared;
      const auto& c = m.error.crossings;
      text += fmt::format(
          "{},{},{},{},{},{},{},\"{}\",{},{},{},{},{},{},{},{},{}\n", report.seed, m.scene, scene.field,
          scene.features, scene.view, m.method, m.step > 0 ? fmt::format("{}", m.step) : "",
          name_of(m.answer), e.pixels, m.error.grazing.pixels, 1 - e.share, e.rmse, e.max, m.outliers,
          c ? fmt::format("{},{},{}", c->exact, c->missed, c->invented) : ",,", m.worst.x, m.worst.y);
    }
  return text;
}

std::string random_table(const RandomReport& report) {
  std::string text;
  for (const SceneGroup& group : groups_of(report)) {
    if (group.id == "all" || group.scenes == 0) continue;
    text += fmt::format(
        "{} ({} of seed {}): % of the pixels within 1/255 at each step, the worst scene and the order from "
        "step "
        "to step; pixels off by more than {}; crossings\n",
        group.title, group.scenes, report.seed, outlier_difference);
    text += head_of_table();
    for (const MethodSummary& summary : group.summaries) text += line_of(summary);
    text += best_of(group) + "\n";
  }
  return text + faults_of(report);
}

}  // namespace crest
