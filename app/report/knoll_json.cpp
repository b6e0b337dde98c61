#include <fmt/core.h>

#include <thread>

#include "app/report/knoll_study.h"
#include "app/report/report_pictures.h"
#include "presets/json.h"
#include "presets/preset_json.h"
#include "render/studies/knoll/variants.h"

namespace crest {
namespace {

Json to_json(const ImageError& error) {
  Json json{{"pixels", error.compared.pixels}, {"rmse", error.compared.rmse},
            {"max", error.compared.max},       {"p999", error.compared.p999},
            {"share", error.compared.share},   {"flip", error.compared.flip}};
  json["grazing_share"] = error.grazing_share();
  json["crossings"] = nullptr;
  if (const auto& c = error.crossings)
    json["crossings"] = {{"exact", c->exact}, {"missed", c->missed}, {"invented", c->invented}};
  return json;
}

Json to_json(const Shot& shot) {
  Json json{{"variant", shot.variant.id},
            {"name", shot.variant.name},
            {"settings", shot.variant.settings},
            {"samples_per_ray", shot.samples_per_ray},
            {"dvr_samples_per_ray", shot.dvr_samples_per_ray},
            {"crossings_per_ray", shot.crossings_per_ray},
            {"skips", shot.skips},
            {"peak_bins", shot.peak_bins},
            {"fps", shot.fps()},
            {"frame_ms", shot.median_ms},
            {"ratio", shot.ratio},
            {"answer", name_of(shot.answer)},
            {"error", to_json(shot.error)},
            {"model_difference", nullptr},
            {"frame_ms_all", shot.frame_ms}};
  if (shot.model_difference) json["model_difference"] = *shot.model_difference;
  return json;
}

Json to_json(const ShotGroup& group) {
  Json json{{"id", group.id}, {"title", group.title}, {"scene", group.scene}, {"shots", Json::array()}};
  for (const Shot& shot : group.shots) json["shots"].push_back(to_json(shot));
  return json;
}

Json to_json(const KnollScene& scene) {
  const glm::ivec3 dims = scene.scene.volume->grid.dims;
  return {{"id", scene.id},
          {"title", scene.title},
          {"volume", scene.volume},
          {"note", scene.note},
          {"dims", {dims.x, dims.y, dims.z}},
          {"preset", knoll_preset_name(scene)},
          {"transfer_function", scene.preset},
          {"camera", camera_to_json(scene.camera, Fields::all)}};
}

Json to_json(const Table1Row& row) {
  Json json = to_json(row.shots);
  json["paper"] = {{"dataset", row.paper.dataset},
                   {"dimensions", row.paper.dimensions},
                   {"samples_per_ray", row.paper.samples_per_ray},
                   {"dvr_samples_per_ray", row.paper.dvr_samples_per_ray},
                   {"fps_peaks", row.paper.fps_peaks},
                   {"fps_post", row.paper.fps_post},
                   {"fps_preintegrated", row.paper.fps_preintegrated}};
  const Shot& peaks = *row.shots.find("xor-paper");
  json["ratios"] = {{"peaks_to_post", time_ratio(peaks, *row.shots.find("post"))},
                    {"peaks_to_preintegrated", time_ratio(peaks, *row.shots.find("preintegrated"))}};
  return json;
}

Json to_json(const SamplingRow& row) {
  return {{"held", row.held == HeldConstant::quality ? "quality" : "frame rate"},
          {"scene", row.scene},
          {"method", row.method},
          {"title", row.shots.title},
          {"group", row.shots.id},
          {"reached", row.reached},
          {"speed_up", row.speed_up()},
          {"paper",
           {{"fps_uniform", row.paper.fps_uniform},
            {"fps_differential", row.paper.fps_differential},
            {"samples_uniform", row.paper.samples_uniform},
            {"samples_differential", row.paper.samples_differential}}},
          {"step", row.uniform().rendering.step},
          {"uniform", to_json(row.uniform())},
          {"differential", to_json(row.differential())}};
}

Json to_json(const ClaimCheck& check) {
  Json json{{"id", check.id},
            {"claim", check.claim},
            {"quantity", check.quantity},
            {"paper",
             {{"low", check.paper.low},
              {"high", check.paper.high},
              {"less_is_better", check.paper.less_is_better}}},
            {"measured", nullptr},
            {"verdict", name_of(check.verdict)},
            {"why", check.why},
            {"evidence", Json::array()}};
  if (!check.evidence.empty()) json["measured"] = {{"low", check.least()}, {"high", check.greatest()}};
  for (const Evidence& e : check.evidence) json["evidence"].push_back({{"of", e.of}, {"value", e.value}});
  return json;
}

Json figures_json(const KnollResults& results) {
  Json figures = Json::array();
  for (const KnollFigure& figure : knoll_figures()) {
    Json panels = Json::array();
    for (const KnollPanel& panel : figure.panels)
      if (find_shot(results, panel.group, panel.variant))
        panels.push_back({{"label", panel.label},
                          {"group", panel.group},
                          {"variant", panel.variant},
                          {"paper_fps", panel.paper_fps},
                          {"picture", knoll_picture_name(panel)},
                          {"error_picture", knoll_error_picture_name(panel)}});
    figures.push_back(
        {{"figure", figure.number}, {"title", figure.title}, {"note", figure.note}, {"panels", panels}});
  }
  return figures;
}

std::string csv_rows(std::string_view part, const ShotGroup& group) {
  std::string text;
  for (const Shot& s : group.shots)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", part, group.scene, group.id,
                        s.variant.id, s.variant.settings, s.samples_per_ray, s.dvr_samples_per_ray,
                        s.crossings_per_ray, s.fps(), s.ratio, name_of(s.answer), s.error.compared.rmse,
                        s.error.compared.max, s.error.compared.share,
                        s.error.crossings ? fmt::format("{}", s.error.crossings->missed) : "");
  return text;
}

}  // namespace

Json knoll_json(const KnollReport& report) {
  const KnollResults& results = report.results;
  Json json{{"format", "crest-knoll-study"},
            {"version", 1},
            {"command", report.command},
            {"made_at", report.made_at},
            {"renderer", report.renderer},
            {"processors", std::thread::hardware_concurrency()},
            {"size", {report.size.x, report.size.y}},
            {"paper_width", paper_width},
            {"s_k", s_k_of_paper(report.size.x)},
            {"seconds", report.seconds},
            {"scenes", Json::array()},
            {"claims", Json::array()},
            {"table1", Json::array()},
            {"table2", Json::array()},
            {"bins", nullptr},
            {"builds", Json::array()},
            {"figures", figures_json(results)},
            {"left_out", Json::array()},
            {"error_scale", error_scale_json()}};
  for (const KnollScene& scene : results.scenes) json["scenes"].push_back(to_json(scene));
  for (const ClaimCheck& check : check_claims(results)) json["claims"].push_back(to_json(check));
  for (const Table1Row& row : results.table1) json["table1"].push_back(to_json(row));
  for (const SamplingRow& row : results.table2) json["table2"].push_back(to_json(row));
  if (results.bins) json["bins"] = to_json(*results.bins);
  for (const TableBuild& build : results.builds)
    json["builds"].push_back(
        {{"bins", build.bins}, {"peak_ms", build.peak_ms}, {"preintegration_ms", build.preintegration_ms}});
  for (const LeftOut& part : results.left_out)
    json["left_out"].push_back({{"what", part.what}, {"why", part.why}});
  return json;
}

std::string knoll_csv(const KnollReport& report) {
  std::string text =
      "part,scene,group,variant,settings,samples_per_ray,dvr_samples_per_ray,crossings_per_ray,fps,ratio,"
      "answer,"
      "rmse,max,share,missed\n";
  for (const Table1Row& row : report.results.table1) text += csv_rows("table 1", row.shots);
  for (const SamplingRow& row : report.results.table2) text += csv_rows("table 2", row.shots);
  if (report.results.bins) text += csv_rows("bins", *report.results.bins);
  return text;
}

}  // namespace crest
