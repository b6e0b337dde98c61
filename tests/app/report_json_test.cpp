#include "app/report/report_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/report/report_pictures.h"
#include "json_schema.h"
#include "program.h"
#include "tests/json.h"
#include "tests/paths.h"

namespace crest {
namespace {

using nlohmann::json;

json schema() {
  return test::parse_json(test::content_of(test::source_folder() / "docs/report.schema.json"));
}

Image grey(float value) { return {{2, 2}, std::vector<glm::vec4>(4, glm::vec4(value))}; }

Reference exact_grey(double value) {
  return {{2, 2}, std::vector<glm::dvec4>(4, glm::dvec4(value)), {1, 1, 0, 0}, {0, 0, 0, 1}};
}

/// DVR at three steps, first with an error of 0.5 and at last without one.
Report small_report() {
  Report report;
  auto volume = std::make_shared<Volume>();
  volume->name = "small";
  report.scene.volume = volume;
  report.scene.rendering.mode = Mode::dvr_only;
  report.size = {2, 2};
  report.settings.target = parse_target("rmse=0.1");
  report.subject = {.command = "crest report",
                    .volume = "small",
                    .preset = "",
                    .renderer = "none",
                    .made_at = "2026-01-02T03:04:05Z",
                    .render_command = [](const Method& m, double step) {
                      return std::string(m.id) + std::to_string(step);
                    }};
  report.references = {{Answer::integral, exact_grey(0.5)}, {Answer::crossings, exact_grey(0.25)}};
  for (const double step : {2.0, 1.0, 0.5}) {
    Measurement m;
    m.method = "dvr";
    m.step = step;
    m.frame_ms = 10 / step;
    m.frame_ms_all = m.device_ms_all = {m.frame_ms};
    const Image image = grey(step == 2 ? 1.f : step == 1 ? 0.625f : 0.5f);
    m.errors = {
        {Answer::integral, image_error(report.references[Answer::integral], image, {}, glm::vec3(0))}};
    report.points.push_back(m);
    report.pictures[report.points.size() - 1] = image;
  }
  report.starts = {{"dvr", 4, 100, 3}};
  report.left_out = {{"peaks", "no surface"}};
  return report;
}

TEST(ReportJson, IsAsItsSchemaSays) {
  const json report = test::parse_json(print_json(report_json(small_report())));
  EXPECT_EQ(test::schema_faults(report, schema()), std::vector<std::string>{});
}

// Else the test above could not fail.
TEST(ReportJson, TheSchemaSeesFaults) {
  const json right = test::parse_json(print_json(report_json(small_report())));
  const auto is_refused = [&](const char* pointer, const json& value) {
    json wrong = right;
    wrong[json::json_pointer(pointer)] = value;
    return !test::schema_faults(wrong, schema()).empty();
  };
  EXPECT_TRUE(is_refused("/version", 2));
  EXPECT_TRUE(is_refused("/seconds", "long"));
  EXPECT_TRUE(is_refused("/points/0/frame_ms", -1));
  EXPECT_TRUE(is_refused("/points/0/errors", json::array()));
  EXPECT_TRUE(is_refused("/points/1/errors/0/compared/share", 1.5));
  EXPECT_TRUE(is_refused("/points/1/errors/0/answer", "best"));
  EXPECT_TRUE(is_refused("/answers/0/picture", "/tmp/a.png"));
  EXPECT_TRUE(is_refused("/methods/0/limits", ""));
  EXPECT_TRUE(is_refused("/more", 1));
  json wrong = right;
  wrong.erase("points");
  EXPECT_FALSE(test::schema_faults(wrong, schema()).empty());
}

TEST(ReportJson, HoldsWhatWasMeasuredAndWhatFollows) {
  const Json report = report_json(small_report());
  EXPECT_EQ(report["points"][0]["frame_ms"], 5);
  EXPECT_EQ(report["points"][1]["errors"][0]["compared"]["rmse"], 0.125);
  EXPECT_EQ(report["points"][1]["errors"][0]["compared"]["pixels"], 3);
  EXPECT_EQ(report["points"][1]["errors"][0]["grazing_share"], 0.25);
  EXPECT_EQ(report["points"][0]["errors"][0]["measures"]["missed"].dump(), "null");
  const Json& integral = report["answers"][0];
  EXPECT_EQ(integral["name"], "integral");
  EXPECT_EQ(integral["own"], true);
  EXPECT_EQ(integral["cheapest"], 2);
  EXPECT_EQ(integral["front"]["rmse"], (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(integral["model_difference"].is_null());
  const Json& crossings = report["answers"][1];
  EXPECT_TRUE(crossings["cheapest"].is_null());
  EXPECT_EQ(crossings["model_difference"]["measures"]["rmse"], 0.25);
  EXPECT_EQ(crossings["crossings_per_ray"], 0.5);
  EXPECT_EQ(report["methods"].size(), 1u);
  EXPECT_EQ(report["methods"][0]["first_frame_ms"], 100);
  EXPECT_EQ(report["methods"][0]["limits"], std::string(find_method("dvr")->limits));
  EXPECT_EQ(report["left_out"][0]["what"], "peaks");
  EXPECT_EQ(report["complete"], true);
}

TEST(ReportCsv, HasARowForEachPointAndAnswer) {
  const std::string csv = report_csv(small_report());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
  EXPECT_EQ(csv.substr(0, 12), "method,step,");
  EXPECT_NE(csv.find("\ndvr,1,integral,10,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",nan,nan\n"), std::string::npos);
  const auto commas = [](std::string_view line) { return std::ranges::count(line, ','); };
  std::size_t begin = 0;
  for (std::size_t end; (end = csv.find('\n', begin)) != csv.npos; begin = end + 1)
    EXPECT_EQ(commas(std::string_view(csv).substr(begin, end - begin)), 16);
}

TEST(ErrorPicture, ShowsErrorsByTheirLogarithm) {
  Reference exact = exact_grey(0.5);
  exact.grazing = {0, 0, 0, 1};
  exact.pixels[2] = glm::dvec4(0);
  Image image = grey(0.5f);
  image.pixels[1] = glm::vec4(0.5f, 1.5f, 0.5f, 0.5f);
  image.pixels[2] = glm::vec4(0);
  const Image picture = error_picture(exact, image);
  const ErrorColors colors = error_colors();
  const auto hex = [](glm::vec4 c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(std::lround(255 * c.r)),
                  unsigned(std::lround(255 * c.g)), unsigned(std::lround(255 * c.b)));
    return std::string(text);
  };
  EXPECT_EQ(hex(picture.pixels[0]), colors.scale.front());
  EXPECT_EQ(hex(picture.pixels[1]), colors.scale.back());
  EXPECT_EQ(hex(picture.pixels[2]), colors.not_compared);
  EXPECT_EQ(hex(picture.pixels[3]), colors.grazing);
  image.pixels[1] = glm::vec4(0.5f, 0.5f + float(std::pow(10, -2.5)), 0.5f, 0.5f);
  EXPECT_EQ(hex(error_picture(exact, image).pixels[1]), colors.scale[4]);  // halfway between 1e-5 and 1
}

TEST(PicturedPoints, AreTheTypicalStepAndTheCheapestUnderTheTarget) {
  std::vector<Measurement> points;
  for (const auto& [method, step, error] : {std::tuple("dvr", 2.0, 0.5),
                                            {"dvr", 0.25, 0.01},
                                            {"dvr", 0.5, 0.2},
                                            {"dvr", 0.125, 0.001},
                                            {"peaks", 4.0, 0.3}}) {
    Measurement m;
    m.method = method;
    m.step = step;
    m.frame_ms = 1 / step;
    ImageError e;
    e.compared.pixels = 100;
    e.compared.rmse = error;
    m.errors = {{Answer::integral, e}};
    points.push_back(m);
  }
  EXPECT_EQ(pictured_points(points, parse_target("rmse=0.01")), (std::vector<std::size_t>{1, 2, 4}));
  EXPECT_EQ(pictured_points(points, parse_target("rmse=1e-9")), (std::vector<std::size_t>{2, 4}));
}

}  // namespace
}  // namespace crest
