#include <map>
#include <regex>

#include "program.h"
#include "tests/paths.h"

namespace crest::test {
namespace {

using Words = std::vector<std::string>;
class CommandLine : public ProgramTest {
 protected:
  /// A picture that works, of 16x16 pixels, for options to be added to.
  Words render = {"render", "builtin:sphere?n=8", "--size", "16x16", "-o", path("a.png")};
};

TEST_F(CommandLine, HelpTellsEachOption) {
  const Words scene = {"--preset", "--mode", "--engine",     "--step", "--eye",  "--target",
                       "--up",     "--fov",  "--projection", "--set",  "VOLUME", "--fit-range"};
  const Words picture = {"--output", "--size", "--frames", "--device", "--json"};
  const std::map<std::string, Words> commands = {
      {"window", scene + Words{"--shaders", "--log-frames", "--log-layout"}},
      {"render", scene + picture},
      {"compare", scene + picture},
      {"peaks", {"PRESET", "--volume", "--bins", "--json"}},
      {"info", {"VOLUME", "--bins", "--by-value", "--suggest-peaks", "--json"}},
      {"export",
       {"PRESET", "--to", "paraview", "csv", "--output", "--volume", "--samples", "--size", "--preview",
        "--json"}},
      {"import", {"FILE", "--output", "--name", "--list", "--take", "--onto", "--volume", "--json"}},
      {"match",
       {"PRESET", "--from", "--to", "--output", "--by", "histogram", "range", "least-squares", "--json"}},
      {"list", {"volumes", "formats", "methods", "presets", "devices"}}};
  const std::string help = output_of({"--help"});
  for (const char* part : {"--version", "Exit codes"}) EXPECT_NE(help.find(part), std::string::npos) << part;
  for (const auto& [command, options] : commands) {
    EXPECT_NE(help.find("\n  " + command), std::string::npos) << command;
    const std::string own_help = output_of({command, "--help"});
    for (const std::string& option : options + Words{"--help"})
      EXPECT_NE(own_help.find(option), std::string::npos) << command << ' ' << option;
  }
}

TEST_F(CommandLine, VersionIsThatOfTheChangesWithTheCommit) {
  std::smatch version, change;
  const std::string told = output_of({"--version"}), changes = content_of(source_folder() / "CHANGELOG.md");
  ASSERT_TRUE(
      std::regex_match(told, version, std::regex("crest (\\d+\\.\\d+\\.\\d+)( \\([0-9a-f]{7,}\\+?\\))?\n")))
      << told;
  ASSERT_TRUE(std::regex_search(changes, change, std::regex("\n## (\\d+\\.\\d+\\.\\d+)\\b")));
  EXPECT_EQ(version[1], change[1]);
}

TEST_F(CommandLine, ListsTellWhatThereIs) {
  const std::map<std::string, Words> lists = {
      {"volumes",
       {"builtin:marschner-lobb", "builtin:sphere", "builtin:linear", "builtin:trilinear", "builtin:gyroid",
        "builtin:plume", "builtin:vessels", "builtin:noise", "n=64"}},
      {"formats",
       {"NRRD", "MetaImage", "NIfTI", "DICOM", "MRC", "VTK", "RAW", "image stack", "paraview", "csv"}},
      {"methods", {"--mode both", "--mode DVR_ONLY", "--mode PEAK_ONLY", "--mode PEAK_XOR_DVR"}},
      {"presets", {"dirac-shell", "four-peaks", "noisy-band", "smooth-haze", "true-spike", "step-surface"}},
      {"devices", {"0 "}}};
  for (const auto& [what, parts] : lists) {
    const std::string text = output_of({"list", what});
    for (const std::string& part : parts)
      EXPECT_NE(text.find(part), std::string::npos) << what << ' ' << part;
  }
}

TEST_F(CommandLine, WordsThatThereAreNot) {
  expect_error(2, render + Words{"--bogus"}, {"--bogus"});
  expect_error(2, render + Words{"more"}, {"more"});
  expect_error(2, {"render"}, {"VOLUME"});
  expect_error(2, {"render", "builtin:sphere"}, {"--output"});
  expect_error(2, {"bogus", "x.nrrd", "-o", "a.png"}, {"x.nrrd"});
  expect_error(2, {"bogus"}, {"bogus", "neither a command nor a file"});
  expect_error(2, {"list"}, {"WHAT"});
  expect_error(2, {"list", "bogus"}, {"bogus", "volumes", "devices"});
  expect_error(2, {"export", "onion", "--to", "bogus", "-o", path("x")}, {"bogus", "paraview", "csv"});
  expect_error(2, {"export", "onion", "-o", path("x")}, {"--to"});
  expect_error(2, render + Words{"--mode", "bogus"}, {"--mode", "bogus", "PEAK_XOR_DVR"});
  expect_error(2, render + Words{"--engine", "bogus"}, {"--engine", "bogus", "raycaster"});
  expect_error(1, render + Words{"--preset", "bogus"}, {"bogus", "no such file", "onion"});
  expect_error(2, render + Words{"--set", "rendering.classification=preintegrated_table"},
               {"rendering.placement", "steps of one length", "entry_exit_corner"});
  expect_error(1, {"info", "builtin:bogus"}, {"bogus", "sphere"});
  expect_error(1, {"info", "builtin:sphere?n=8&m=2"}, {"\"m\"", "radius"});
  expect_error(1, render + Words{"--device", "99"}, {"--device 99"});
}

TEST_F(CommandLine, TellsTheWordThatWasMeant) {
  expect_error(2, render + Words{"--prset", "onion"}, {"--prset", "did you mean --preset?"});
  expect_error(2, render + Words{"--prset=onion"}, {"--prset", "did you mean --preset?"});
  expect_error(2, {"compare", "builtin:sphere", "-o", "a.png", "--turntable", "3"},
               {"--turntable", "an option of render, which compare has not"});
  expect_error(2, {"rendr", "builtin:sphere", "-o", "a.png"}, {"rendr", "did you mean render?"});
  expect_error(2, {"rendr"}, {"rendr", "did you mean render?"});
  expect_error(2, render + Words{"--mode", "peak_only"}, {"--mode", "did you mean PEAK_ONLY?"});
  expect_error(2, render + Words{"--engine", "raycastr"}, {"--engine", "did you mean raycaster?"});
  expect_error(2, render + Words{"--set", "rendering.sampling=unifrom"}, {"did you mean uniform?"});
  expect_error(2, render + Words{"--set", "rendering.stpe=1"}, {"did you mean step?"});
  expect_error(1, render + Words{"--preset", "dirac-shel"}, {"did you mean dirac-shell?"});
  expect_error(2, {"export", "onion", "--to", "paraveiw", "-o", path("x")}, {"did you mean paraview?"});
  expect_error(2, {"report", "--study", "knol", "-o", path("x")}, {"--study", "did you mean knoll?"});
  expect_error(1, {"info", "builtin:shpere"}, {"did you mean sphere?"});
  expect_error(1, {"info", "builtin:sphere?radios=1"}, {"did you mean radius?"});
}

TEST_F(CommandLine, OptionsBeforeACommandAreNotLost) {
  expect_error(2, Words{"--mode", "DVR_ONLY"} + render, {"--mode", "render"});
  expect_error(2, Words{"builtin:gyroid"} + render, {"VOLUME", "render"});
}

TEST_F(CommandLine, Sizes) {
  render.resize(2);
  for (const char* size :
       {"0x0", "0x16", "abc", "16", "16x", "16x16x16", "-16x16", "1e3x2", " 16x16", "99999999999x1"})
    expect_error(2, render + Words{"-o", path("a.png"), "--size", size}, {"--size", "512x512"});
  for (const char* size : {"99999x1", "1x16385"})
    expect_error(2, render + Words{"-o", path("a.png"), "--size", size}, {"--size", size, "1..16384"});
}

TEST_F(CommandLine, NumbersOfOptions) {
  expect_error(2, render + Words{"--step", "-1"}, {"--step", "-1 is not at least 0.001"});
  for (const char* tiny : {"0", "1e-9", "1e-300"})
    expect_error(2, render + Words{"--step", tiny}, {"--step", "is not at least 0.001"});
  for (const char* text : {"nan", "inf", "fast", "0x10"})
    expect_error(2, render + Words{"--step", text}, {"--step", text, "not a number"});
  expect_error(2, render + Words{"--step", "1,500"}, {"--step", "1,500", "two ways"});
  expect_error(2, render + Words{"--step", "1/0"}, {"--step", "1/0", "divides by zero"});
  expect_error(2, render + Words{"--step", "1e999"}, {"--step"});
  for (const char* count : {"0", "-1", "1.5", "many", "0x10", "010"})
    expect_error(2, render + Words{"--frames", count}, {"--frames"});
  expect_error(2, {"info", "builtin:sphere?n=8", "--bins", "0"}, {"--bins"});
  expect_error(2, {"peaks", "onion", "--bins", "4097"}, {"--bins"});
  expect_error(2, {"export", "onion", "--to", "csv", "-o", path("x"), "--samples", "1"}, {"--samples"});
}

TEST_F(CommandLine, EmptyValuesAreNoValues) {
  for (const char* option : {"--mode", "--step", "--size", "--preset", "--eye", "--set", "--error-bound"})
    expect_error(2, render + Words{option, ""}, {option, "empty"});
  expect_error(2, {"export", "onion", "--to", "csv", "-o", ""}, {"--output", "empty"});
  expect_error(2, render + Words{"--device", "-1"}, {"--device"});
  for (const char* command : {"info", "peaks"}) expect_error(2, {command, ""}, {"empty"});
}

TEST_F(CommandLine, Cameras) {
  expect_error(1, render + Words{"--eye", "1,1,1", "--target", "1,1,1"}, {"eye and target", "same point"});
  expect_error(1, render + Words{"--eye", "1e300,1,1"}, {"camera.eye", "too far away"});
  expect_error(2, render + Words{"--fov", "30", "--fov", "40"}, {"--fov", "more than once"});
  expect_error(2, render + Words{"--projection", "isometric"}, {"--projection", "perspective, parallel"});
  for (const char* fov : {"0", "180", "-30", "nan"}) expect_error(2, render + Words{"--fov", fov}, {"--fov"});
  for (const char* eye : {"1,2", "1,2,3,4", "1,2,x", "nan,0,0", "1;2;3", "1,2,3],\"up\":[0"})
    expect_error(2, render + Words{"--eye", eye}, {"--eye", "camera.eye"});
  // Up along the view, or none: another is taken, and there is a picture.
  for (const char* up : {"0,0,1", "0,0,0"})
    EXPECT_EQ(run(render + Words{"--eye", "0,0,-5", "--target", "0,0,0", "--up", up}).exit_code, 0) << up;
}

TEST_F(CommandLine, NegativeCoordinatesAreNoOptions) {
  ASSERT_EQ(run(render + Words{"--eye", "-1,2,3"}).err, "");
  const std::string apart = content_of(path("a.png"));
  ASSERT_EQ(run(render + Words{"--eye=-1,2,3"}).err, "");
  EXPECT_EQ(content_of(path("a.png")), apart);
  ASSERT_EQ(run(render + Words{"--eye", "1,2,3"}).err, "");
  EXPECT_NE(content_of(path("a.png")), apart);
}

TEST_F(CommandLine, FieldsSetByTheirPaths) {
  EXPECT_EQ(run({"render", "--set", "rendering.step=1", "builtin:sphere?n=8", "--size", "16x16", "-o",
                 path("a.png"), "--set", "rendering.shading=gradient"})
                .err,
            "");
  expect_error(2, render + Words{"--set", "bogus"}, {"--set", "PATH=VALUE"});
  expect_error(2, render + Words{"--set", "rendering.stp=1"}, {"--set", "\"stp\"", "step"});
  expect_error(2, render + Words{"--set", "transfer_function.points[9].opacity=1"}, {"points", "elements"});
  expect_error(2, render + Words{"--set", "transfer_function.points[0].opacity=1.2"},
               {"transfer_function.points[0].opacity: 1.2 is not in [0, 1]"});
}

TEST_F(CommandLine, WithoutADisplayThereIsAPicture) {
  const std::string text = output_of({});
  EXPECT_EQ(names(), Words{"crest-modes.png"});
  EXPECT_NE(text.find("No display"), std::string::npos) << text;
  EXPECT_NE(text.find(path("crest-modes.png")), std::string::npos) << text;
  EXPECT_NE(text.find("DISPLAY"), std::string::npos) << text;
}

TEST_F(CommandLine, OutputThatCannotBePrintedIsAnError) {
  for (const Words& arguments : {Words{"info", "builtin:sphere?n=8"}, Words{"peaks", "onion"},
                                 Words{"list", "presets"}, Words{"--help"}, Words{"--version"}}) {
    // The outer redirection is the test's own; this one, within, is the full disk.
    const Outcome outcome = run(arguments, "exec >/dev/full;");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "crest: cannot write to the standard output: No space left on device\n");
  }
}

TEST_F(CommandLine, ClosedStreamsAreNoCrash) {
  EXPECT_EQ(run({"info", path("none")}, "exec 2>&-;").exit_code, 1);
  EXPECT_EQ(run({"info", path("none")}, "exec 2>/dev/full;").exit_code, 1);
  EXPECT_EQ(run({"list", "presets"}, "exec 0<&- 2>&-;").exit_code, 0);
  const Outcome closed = run({"list", "presets"}, "exec >&-;");
  EXPECT_EQ(closed.exit_code, 1);
  EXPECT_TRUE(closed.err.starts_with("crest: cannot write to ")) << closed.err;
}

TEST_F(CommandLine, NamesReachTheTerminalEscaped) {
  expect_error(1, {"info", path("\x1b[31m\xff.nrrd")}, {"\\x1b[31m\\xff.nrrd"});
  const Outcome odd = run({"export", "onion", "--to", "csv", "--volume", "builtin:noise?n=8", "--json", "-o",
                           path("\x7f\xc2\x9b\xe2\x80\xae.csv")});
  EXPECT_NE(odd.out.find("\\u007f\\u009b\\u202e.csv"), std::string::npos) << odd.out;
  EXPECT_EQ(odd.out.find_first_of("\x7f\xc2\xe2"), std::string::npos) << odd.out;
  const Outcome outcome = run({"info", std::string(100000, 'x')});
  EXPECT_LT(outcome.err.size(), 3000U);
}

TEST_F(CommandLine, APresetIsNotWrittenOver) {
  const std::string preset = write("p.json", content_of(source_folder() / "presets/library/onion.json"));
  expect_error(2, {"export", preset, "--to", "csv", "-o", preset}, {"--output", "p.json", "would be lost"});
  expect_error(2, {"export", preset, "--to", "csv", "-o", path("./p.json")}, {"--output", "would be lost"});
  expect_error(2, {"match", preset, "--from", "builtin:noise", "--to", "builtin:gyroid", "-o", preset},
               {"--output", "p.json", "would be lost"});
}

TEST_F(CommandLine, AVolumeIsNotWrittenOver) {
  const std::string volume = write("v.png", "a picture"), other = path("./v.png");
  expect_error(2, {"match", "onion", "--from", volume, "--to", "builtin:gyroid", "-o", other},
               {"--output", "v.png", "would be lost"});
  expect_error(2, {"info", volume, "--by-value", other}, {"--by-value", "v.png", "would be lost"});
  for (const char* command : {"render", "compare"})
    expect_error(2, {command, volume, "-o", other}, {"--output", "v.png", "would be lost"});
  EXPECT_EQ(content_of(volume), "a picture");
}

TEST_F(CommandLine, NoInputIsWrittenOverAndNoOutputTwice) {
  const std::string volume = write("v.png", "a picture"), preset = write("p.json", "a preset");
  const std::string table = write("t.csv", "a table"), to = path("out.png"), other = path("./out.png");
  expect_error(2, {"export", "onion", "--to", "csv", "--volume", volume, "-o", volume},
               {"--output", "v.png", "would be lost"});
  expect_error(2, {"export", "onion", "--to", "csv", "--volume", volume, "-o", to, "--preview", volume},
               {"--preview", "v.png", "would be lost"});
  expect_error(2, {"import", table, "--volume", volume, "-o", volume}, {"--output", "would be lost"});
  expect_error(2, {"render", "builtin:sphere", "--preset", volume, "-o", volume}, {"would be lost"});
  expect_error(2, {"window", volume, "--preset", preset, "--log-frames", preset},
               {"--log-frames", "p.json", "would be lost"});
  expect_error(2, {"export", "onion", "--to", "png", "--volume", volume, "-o", to, "--preview", other},
               {"--preview", "out.png is what --output writes"});
  expect_error(2, {"render", "builtin:sphere", "--exact", "-o", to, "--error-bound", other},
               {"--error-bound", "out.png is what --output writes"});
  expect_error(2, {"window", "--log-frames", to, "--log-layout", other}, {"--log-layout", "--log-frames"});
}

TEST_F(CommandLine, NeitherIsAnImageOfAStack) {
  std::filesystem::create_directory(path("stack"));
  for (const char* name : {"stack/s-001.png", "stack/s-002.png"}) write(name, "an image");
  const Words drawn{"render", path("stack"), "--preset", "onion"};
  expect_error(2, drawn + Words{"-o", path("stack/s-001.png")}, {"s-001.png", "would be lost"});
  expect_error(2, drawn + Words{"-o", path("stack/s.png"), "--turntable", "100"},
               {"s-001.png", "would be lost"});
  expect_error(2, drawn + Words{"-o", path("p.png"), "--exact", "--error-bound", path("stack/s-002.png")},
               {"--error-bound", "would be lost"});
}

}  // namespace
}  // namespace crest::test
