#include <cmath>

#include "page.h"
#include "program.h"
#include "render/files/image.h"
#include "tests/json.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

const Words placements = {"eye", "entry", "entry_exit", "entry_exit_corner"};

class PlacementStudy : public ProgramTest {
 protected:
  Words study_to(const std::string& folder, const Words& options = {}) const {
    return Words{"report", "--study", "placement", "--size", "48x48", "-o", path(folder)} + options;
  }
  json json_in(const std::string& folder) const {
    return test::parse_json(content_of(path(folder + "/placement.json")));
  }
};

const json& named(const json& list, const char* key, const std::string& name) {
  for (const json& item : list)
    if (item[key] == name) return item;
  ADD_FAILURE() << "there is no " << name;
  return list;
}

/// The series of a field, sum and placement.
const json& series_of(const json& plane, const std::string& field, const std::string& sum,
                      const std::string& placement) {
  for (const json& series : plane["series"])
    if (series["field"] == field && series["sum"] == sum && series["placement"] == placement) return series;
  ADD_FAILURE() << "there is no " << field << ", " << sum << ", " << placement;
  return plane;
}

void expect_plane(const json& plane) {
  EXPECT_EQ(plane["series"].size(), 2 * 2 * placements.size());
  for (const json& series : plane["series"])
    for (const json& run : series["runs"]) ASSERT_EQ(run["intensities"].size(), 120U);
  for (const std::string& placement : placements) {
    const double order = series_of(plane, "curved", "absorbing", placement)["rms_order"];
    EXPECT_NEAR(order,
                placement == "entry_exit_corner" ? 2
                : placement == "entry_exit"      ? 1.4
                                                 : 1,
                0.15)
        << placement;
  }
  EXPECT_TRUE(series_of(plane, "linear", "absorbing", "entry_exit_corner")["max_order"].is_null())
      << "an error of rounding has no order";
}

void expect_volumes(const json& volumes) {
  for (const json& volume : volumes) {
    SCOPED_TRACE(volume["id"]);
    EXPECT_EQ(volume["size"], json({48, 48}));
    ASSERT_EQ(volume["placements"].size(), placements.size());
    for (const std::string& name : placements) {
      const json& placement = named(volume["placements"], "placement", name);
      ASSERT_EQ(placement["points"].size(), 5U);
      const json &coarse = placement["points"].front(), &fine = placement["points"].back();
      EXPECT_GT(coarse["step"], fine["step"]);
      EXPECT_GT(coarse["pixels"], 50);
      EXPECT_GT(coarse["rmse"], fine["rmse"]) << name;
      EXPECT_LT(fine["rmse"], 0.02) << name;
      EXPECT_LE(coarse["rmse"], coarse["max"]);
      EXPECT_LT(coarse["dvr_samples_per_ray"], fine["dvr_samples_per_ray"]);
    }
    const auto rmse = [&](const std::string& name) -> double {
      return named(volume["placements"], "placement", name)["points"][1]["rmse"];
    };
    if (volume["id"] == "plume") continue;  // it has next to nothing at its border, where placements differ
    for (const std::string& name : placements) EXPECT_LE(rmse("entry_exit_corner"), rmse(name)) << name;
  }
}

void expect_times(const json& times) {
  ASSERT_EQ(times["placements"].size(), placements.size() + 1);
  int controls = 0;
  for (const json& time : times["placements"]) {
    controls += time["control"].get<bool>();
    EXPECT_GT(time["frame_ms"], 0);
    EXPECT_GT(time["ratio"], 0.1);
    EXPECT_LT(time["ratio"], 10);
    EXPECT_EQ(time["frame_ms_all"].size(), 15U);
  }
  EXPECT_EQ(controls, 1);
}

TEST_F(PlacementStudy, OfItsOwnScenes) {
  const Outcome outcome = run(study_to("new/out", {"--json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json study = json_in("new/out");
  EXPECT_EQ(test::parse_json(outcome.out), study);
  EXPECT_EQ(study["format"], "crest-placement-study");
  expect_plane(study["plane"]);
  ASSERT_EQ(study["volumes"].size(), 4U);
  expect_volumes(study["volumes"]);
  EXPECT_LT(study["distance_from_plane"], 2e-3);
  ASSERT_EQ(study["clip_against_crop"].size(), placements.size());
  for (const json& clip : study["clip_against_crop"]) EXPECT_LT(clip["share"], 0.02);
  expect_times(study["times"]);

  // A line for each ray of each run, and the same numbers as the JSON has
  const std::string csv = content_of(path("new/out/placement.csv"));
  std::size_t rays = 0;
  for (const json& series : study["plane"]["series"]) rays += series["runs"].size() * 120;
  EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), rays + 1);
  EXPECT_TRUE(csv.starts_with("field,sum,placement,rate,ray,angle_degrees,intensity,exact\nlinear,"));
}

TEST_F(PlacementStudy, ItsPageStandsAloneAndItsPicturesAreThere) {
  ASSERT_EQ(run(study_to("out")).exit_code, 0);
  json data = expect_standalone_page(content_of(path("out/placement.html")));
  std::size_t pictures = 0;
  const auto expect_picture = [&](const std::string& name) {
    ++pictures;
    EXPECT_EQ(read_image(path("out/" + name)).size, glm::ivec2(48)) << name;
    EXPECT_TRUE(data["pictures"][name].get<std::string>().starts_with("data:image/png;base64,")) << name;
  };
  for (const json& volume : data["volumes"]) {
    expect_picture(volume["exact_picture"]);
    for (const json& placement : volume["placements"]) {
      expect_picture(placement["picture"]);
      expect_picture(placement["error_picture"]);
    }
  }
  EXPECT_EQ(pictures, 4 * (1 + 2 * placements.size()));
  EXPECT_EQ(data["pictures"].size(), pictures);
  data.erase("pictures");
  EXPECT_EQ(data, json_in("out"));
}

TEST_F(PlacementStudy, OfAVolume) {
  const Words gyroid = {"builtin:gyroid?n=20", "--preset", "smooth-haze"};
  ASSERT_EQ(run(study_to("out", gyroid)).exit_code, 0);
  const json study = json_in("out");
  const json& border = named(study["volumes"], "id", "border");
  EXPECT_EQ(border["dims"], json({20, 20, 20}));
  EXPECT_EQ(study["times"]["scene"], "border");
  expect_volumes(study["volumes"]);
  // Its exact picture is the one that the same scene has
  output_of(Words{"render"} + gyroid +
            Words{"--mode", "DVR_ONLY", "--engine", "reference", "--size", "48x48", "-o", path("exact.png")});
  EXPECT_EQ(read_image(path("exact.png")).pixels, read_image(path("out/images/border-exact.png")).pixels);
}

TEST_F(PlacementStudy, StoppedItLeavesNothing) {
  const Words words{"report", "--study", "placement", "--size", "400x400", "-o", path("new/out")};
  expect_error(1, words,
               {"crest: " + path("new/out") + ": stopped before the study was done; nothing is written\n"},
               interrupted_after(2));
}

TEST_F(PlacementStudy, WrongCommandLines) {
  const Words plain = {"report", "--study", "placement", "-o", path("out")};
  for (const char* size : {"0x0", "-1x4", "many"})
    expect_error(2, plain + Words{"--size", size}, {"--size", "512x512"});
  expect_error(2, plain + Words{"--size", "20000x4"}, {"20000x4", "1..16384"});
  for (const char* budget : {"0s", "-1", "abc", "", "1e9", "10 s"})
    expect_error(2, study_to("out", {"--budget", budget}), {"--budget"});
  expect_error(2, study_to("out", {"--budget", "10s"}), {"--budget", "--study"});
  expect_error(2, study_to("out", {"--target-error", "rmse=0.1"}), {"--target-error"});
  expect_error(2, study_to("out", {"--preset", "onion"}), {"VOLUME", "preset"});
  expect_error(2, study_to("out", {"--set", "rendering.step=1"}), {"VOLUME"});
  expect_error(2, {"report", "--study", "placement"}, {"--output"});
  expect_error(2, {"report", "--study", "placement", "-o", ""}, {"--output"});
  expect_error(2, {"report", "--study", "", "-o", path("out")}, {"--study"});
  expect_error(2, {"report", "--study", "Placement", "-o", path("out")}, {"Placement", "placement"});
  expect_error(1, study_to("out", {path("missing.nrrd")}), {"missing.nrrd"});
  expect_error(1, study_to("out", {"builtin:gyroid?n=9", "--preset", "missing"}), {"missing"});
  expect_error(2, study_to("out", {"builtin:gyroid?n=9", "--mode", "bogus"}), {"bogus"});
  write("file", "");
  expect_error(1, study_to("file"), {"file", "folder"});
  expect_error(1, study_to("file/below"), {"file", "folder"});
}

}  // namespace
}  // namespace crest::test
