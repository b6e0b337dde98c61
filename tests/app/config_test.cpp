#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "app/file_watch.h"
#include "presets/json.h"
#include "program.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;

class Config : public ProgramTest {
 protected:
  Config() { std::filesystem::create_directory(path("crest")); }
  void configure(const std::string& json) const { write("crest/config.json", json); }
  Outcome run_configured(const Words& arguments) const { return run(arguments, here); }
  /// "WIDTHxHEIGHT" of a picture that a run with the config file makes.
  std::string size_of_picture(const Words& arguments) const {
    const Outcome outcome =
        run_configured(Words{"render", "builtin:sphere?n=8", "-o", path("a.png")} + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string png = content_of(path("a.png"));
    const auto number = [&](std::size_t at) {
      return std::to_string(256 * static_cast<unsigned char>(png.at(at)) +
                            static_cast<unsigned char>(png.at(at + 1)));
    };
    return number(18) + "x" + number(22);  // of the IHDR chunk
  }
  void expect_refused(const std::string& json, const Words& parts) const {
    configure(json);
    expect_error(1, {"list", "presets"}, Words{"config.json"} + parts, here);
  }

  const std::string here = "XDG_CONFIG_HOME=" + path("");
};

TEST_F(Config, IsForWhatTheCommandLineLeavesOut) {
  configure(R"({"size": "20x10"})");
  EXPECT_EQ(size_of_picture({}), "20x10");
  EXPECT_EQ(size_of_picture({"--size", "8x8"}), "8x8");
  EXPECT_EQ(size_of_picture({"--no-config"}), "512x512");
  configure("faulty");
  EXPECT_EQ(run_configured({"--no-config", "list", "presets"}).exit_code, 0) << "also before a command";
}

TEST_F(Config, ASectionIsNearerThanWhatIsForAll) {
  configure(R"({"render": {"size": "12x6"}, "size": "20x10", "compare": {"size": "4x4"}})");
  EXPECT_EQ(size_of_picture({}), "12x6");
}

TEST_F(Config, TakesListsFlagsAndNumbers) {
  configure(R"({"render": {"set": ["rendering.step=2"], "json": true, "frames": 2, "size": "8x8"}})");
  const Outcome outcome = run_configured({"render", "builtin:sphere?n=8", "-o", path("a.png")});
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.err;
  EXPECT_EQ(json["frame_ms_all"].size(), 1U) << "two frames, the first of which does not count";
}

TEST_F(Config, YieldsToWhatIsTypedAgainstIt) {
  const Words render = {"render", "builtin:sphere?n=8", "--preset", "onion", "--size", "8x8"};
  const auto draw = [&](const Words& words) {
    const Outcome outcome = run_configured(render + words + Words{"-o", path("a.png")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  configure(R"({"render": {"exact": true, "json": true, "turntable": 3, "step": "1", "budget": "40"}})");
  draw({"--auto"});
  EXPECT_EQ(names(), (Words{"a.png", "crest"})) << "one picture, not a turn";
  EXPECT_EQ(run_configured(render + Words{"-o", "-"}).out.substr(0, 4), "\x89PNG");
  configure(R"({"render": {"auto": true, "target-error": "share=0.1", "watch": true}})");
  draw({"--step", "1", "--watch=false"});
  EXPECT_EQ(run_configured(render + Words{"-o", "-"}).out.substr(0, 4), "\x89PNG") << "and ends";
  configure(R"({"json": true})");
  EXPECT_EQ(run_configured(Words{"compare"} + Words(render.begin() + 1, render.end()) + Words{"-o", "-"})
                .out.substr(0, 4),
            "\x89PNG");
  configure(R"({"render": {"exact": true}})");
  expect_error(2, render + Words{"--auto", "--exact", "-o", path("a.png")}, {"--auto", "--exact"}, here);
}

TEST_F(Config, SetsWhatAStudyTakesAndNothingElse) {
  configure(R"({"report": {"seed": "7", "budget": "1s", "size": "16x16"}, "preset": "onion"})");
  const Outcome outcome = run_configured({"report", "builtin:sphere?n=8", "--json", "-o", path("r")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;  // a seed is for chance
  EXPECT_EQ(outcome.out.find("--seed"), std::string::npos);
  EXPECT_NE(outcome.out.find("--preset onion"), std::string::npos);
  const Outcome study = run_configured({"report", "--study", "placement", "--budget", "x", "-o", path("s")});
  EXPECT_EQ(study.err.find("no preset"), std::string::npos) << "it has scenes of its own: " << study.err;
}

TEST_F(Config, AFrameIsNotOfABuiltInVolume) {
  configure(R"({"frame": "1", "size": "8x8"})");
  EXPECT_EQ(run_configured({"render", "builtin:sphere?n=8", "-o", path("a.png")}).exit_code, 0);
  expect_error(1, {"render", "builtin:sphere?n=8", "--frame", "1", "-o", path("a.png")}, {"\"frame\""}, here);
}

TEST_F(Config, IsInTheCommandThatAReportTells) {
  configure(R"({"report": {"size": "16x16", "budget": "1s"}})");
  const Outcome outcome = run_configured({"report", "builtin:sphere?n=8", "--json", "-o", path("r")});
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.err;
  EXPECT_NE(json.dump().find("--size 16x16 --budget 1s"), std::string::npos);
}

TEST_F(Config, RefusesWhatThereIsNot) {
  expect_refused(R"({"sise": "1x1"})", {"sise", "did you mean size?", "--no-config"});
  expect_refused(R"({"rendr": {}})", {"rendr", "did you mean render?"});
  expect_refused(R"({"render": {"turntabel": 3}})", {"render.turntabel", "did you mean turntable?"});
  expect_refused(R"({"render": {"output": "a.png"}})", {"render.output"});
  expect_refused(R"({"render": {"VOLUME": "a.nrrd"}})", {"render.VOLUME"});
  expect_refused(R"({"render": {"no-config": true}})", {"render.no-config"});
  expect_refused(R"({"render": {"json": 1}})", {"render.json", "neither true nor false"});
  expect_refused(R"({"render": {"frames": 1.5}})", {"render.frames", "1.5"});
  expect_refused(R"({"render": {"frames": 0}})", {"render.frames", "not in [1, 100000]"});
  expect_refused(R"({"device": "first"})", {"device", "first", "whole number"});
  expect_refused(R"({"mode": "dvr_only"})", {"mode", "did you mean DVR_ONLY?"});
  expect_refused(R"({"set": "rendering.step=1"})", {"set", "array"});
  expect_refused(R"({"": 1})", {"no such option"});
  expect_refused("[", {"parse error"});
  expect_refused("[]", {"not an object"});
  EXPECT_EQ(run_configured({"--help"}).exit_code, 0) << "one can look up what is right";
}

class Pipes : public ProgramTest {};

TEST_F(Pipes, APresetComesInAndAPictureGoesOut) {
  const Words render = {"render", "builtin:sphere?n=8", "--size", "16x16"};
  ASSERT_EQ(run(render + Words{"--preset", "onion", "-o", path("a.png")}).err, "");
  ASSERT_EQ(run(render + Words{"--preset", "onion", "-o", path("a"), "--format", "png"}).err, "");
  write("onion.json", content_of(source_folder() / "presets" / "library" / "onion.json"));
  const Outcome piped = run(render + Words{"--preset", "-", "-o", "-"}, "<onion.json");
  EXPECT_EQ(piped.err, "");
  EXPECT_EQ(piped.out, content_of(path("a.png")));
  EXPECT_EQ(content_of(path("a")), content_of(path("a.png")));
  EXPECT_EQ(run(render + Words{"--format", "exr", "-o", "-"}).out.substr(0, 4), "\x76\x2f\x31\x01");
  EXPECT_EQ(names(), (Words{"a", "a.png", "onion.json"}));
}

TEST_F(Pipes, OneThingForAStream) {
  const Words render = {"render", "builtin:sphere?n=8", "--size", "16x16", "-o", "-"};
  expect_error(2, render + Words{"--json"}, {"--json", "standard output"});
  expect_error(2, render + Words{"--turntable", "3"}, {"--turntable", "one picture"});
  expect_error(2, render + Words{"--watch"}, {"--watch"});
  expect_error(2, {"render", "builtin:sphere?n=8", "-o", path("a.png"), "--watch", "--preset", "-"},
               {"--watch", "standard input"});
  expect_error(2, {"report", "builtin:sphere?n=8", "--preset", "-", "-o", path("r")},
               {"--preset", "standard input"});
  expect_error(1, render + Words{"--preset", "-"}, {"the standard input", "parse error"}, "</dev/null");
}

TEST(FileWatch, TellsAChangeOnceWhenItRests) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("crest-watch-" + std::to_string(getpid()));
  const auto write_with = [&](const std::string& text, int second) {
    std::ofstream(file) << text;
    std::filesystem::last_write_time(file, std::filesystem::file_time_type(std::chrono::seconds(second)));
  };
  write_with("a", 1);
  FileWatch watch;
  EXPECT_FALSE(watch.has_changed({file}));
  EXPECT_FALSE(watch.has_changed({file}));
  write_with("a", 2);
  EXPECT_FALSE(watch.has_changed({file})) << "perhaps still being written";
  EXPECT_TRUE(watch.has_changed({file}));
  EXPECT_FALSE(watch.has_changed({file}));
  write_with("ab", 2);
  EXPECT_FALSE(watch.has_changed({file}));
  EXPECT_TRUE(watch.has_changed({file})) << "another size";
  std::filesystem::remove(file);
  EXPECT_FALSE(watch.has_changed({file}));
  EXPECT_FALSE(watch.has_changed({file})) << "gone";
  EXPECT_FALSE(watch.has_changed({file, file})) << "other files than before";
}

class Watch : public ProgramTest {
 protected:
  /// Starts it, changes the preset once the first picture is there, ends it when the second one is.
  Outcome change_preset(const std::string& to) const {
    return run_shell("timeout 300 '" + crest_program().string() +
                     "' render 'builtin:sphere?n=8' --size 16x16 --preset p.json -o a.png --watch 2>log & "
                     "lines() { until [ \"$(grep -c crest: log)\" -ge $1 ] || ! kill -0 $! 2>/dev/null; do "
                     "sleep 0.05; done; }; "
                     "lines 1; cp a.png first.png; " +
                     to + "; lines 2; kill $!; wait $!; echo $?; cat log");
  }
};

TEST_F(Watch, DrawsAgainWhenThePresetChanges) {
  const auto library = source_folder() / "presets" / "library";
  write("p.json", content_of(library / "onion.json"));
  write("q.json", content_of(library / "smooth-haze.json"));
  const Outcome outcome = change_preset("cat q.json > p.json");
  EXPECT_TRUE(outcome.out.starts_with("0\n")) << outcome.out << outcome.err;
  EXPECT_NE(content_of(path("a.png")), content_of(path("first.png")));
  EXPECT_EQ(
      run({"render", "builtin:sphere?n=8", "--size", "16x16", "--preset", "q.json", "-o", "b.png"}).exit_code,
      0);
  EXPECT_EQ(content_of(path("a.png")), content_of(path("b.png")));
}

TEST_F(Watch, AFaultyPresetIsToldAndThePictureStays) {
  write("p.json", content_of(source_folder() / "presets" / "library" / "onion.json"));
  const Outcome outcome = change_preset("echo '{' > p.json");
  EXPECT_NE(outcome.out.find("p.json: parse error"), std::string::npos) << outcome.out;
  EXPECT_EQ(content_of(path("a.png")), content_of(path("first.png")));
}

TEST_F(Watch, NeedsAFile) {
  expect_error(2, {"render", "builtin:sphere?n=8", "--preset", "onion", "-o", "a.png", "--watch"},
               {"--watch"});
}

}  // namespace
}  // namespace crest::test
