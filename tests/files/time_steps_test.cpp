#include "render/files/time_steps.h"

#include <fmt/core.h>

#include <filesystem>

#include "files.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"

namespace crest::test {
namespace {

/// 2x2x2 points, value first + i at point i.
std::string cube(int first) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += char(first + i);
  return bytes;
}

class TimeStepFiles : public FileTest {
 protected:
  /// The names of a pattern's files.
  std::vector<std::string> names(const std::string& pattern) const {
    std::vector<std::string> names;
    for (const auto& file : numbered_files(path(pattern))) names.push_back(file.filename().string());
    return names;
  }
  /// Steps 2, 10 and 11, of values from 30, 10 and 50 on.
  std::string write_list() const {
    write("step_10_2x2x2_uint8.raw", cube(10));
    write("step_2_2x2x2_uint8.raw", cube(30));
    write("step_11_2x2x2_uint8.raw", cube(50));
    return path("step_*_2x2x2_uint8.raw");
  }
  static OpenChoice choice_of(const std::string& source) {
    try {
      load_volume(source);
    } catch (const ChoiceNeeded& needed) {
      return needed.choice;
    }
    ADD_FAILURE() << source << " needs no choice";
    return {};
  }
};

TEST_F(TimeStepFiles, AreThoseWithANumberInAPatternsPlace) {
  for (const char* name : {"a2.vti", "a10.vti", "a010.vti", "a1.vti", "a.vti", "ax.vti", "a-1.vti", "a1b.vti",
                           "b1.vti", "a3.vti.old"})
    write(name, "");
  std::filesystem::create_directory(path("a4.vti"));
  EXPECT_EQ(names("a*.vti"), (std::vector<std::string>{"a1.vti", "a2.vti", "a010.vti", "a10.vti"}));
  EXPECT_TRUE(names("a*.vtk").empty());
  EXPECT_TRUE(names("a1.vti").empty());
  EXPECT_TRUE(names("*a*.vti").empty()) << "which of the two is the number is not said";
  EXPECT_TRUE(numbered_files("/no/such/folder/a*.vti").empty());
}

TEST_F(TimeStepFiles, AreFoundFromOneOfThem) {
  for (int i = 8; i < 12; ++i) write(fmt::format("run2_t{}_64x64.raw", i), "");
  write("run3_t8_64x64.raw", "");
  write("lonely7.raw", "");
  const auto list = numbered_list_of(path("run2_t8_64x64.raw"));
  ASSERT_TRUE(list);
  EXPECT_EQ(list->pattern.filename(), "run2_t*_64x64.raw");
  EXPECT_EQ(list->count, 4U);
  EXPECT_FALSE(numbered_list_of(path("lonely7.raw")));
}

TEST_F(TimeStepFiles, AreVolumesOfOneSource) {
  const std::string pattern = write_list();
  EXPECT_TRUE(is_volume_there(pattern));
  const float first[] = {30, 10, 50};
  for (int step = 0; step < 3; ++step) {
    const Volume volume = load_volume(fmt::format("{}?frame={}", pattern, step));
    EXPECT_EQ(volume.values[0], first[step]);
    EXPECT_EQ(volume.frames, 3);
    EXPECT_EQ(volume.frame, step);
  }
  EXPECT_EQ(load_volume(pattern + "?frame=1").name, "step_10_2x2x2_uint8.raw");
  EXPECT_EQ(load_volume(pattern + "?frame=1").file.path, path("step_10_2x2x2_uint8.raw"));
  expect_error(pattern + "?frame=3", {"frame=3"});
  EXPECT_FALSE(is_volume_there(path("other_*.raw")));
  expect_error(path("other_*.raw"), {"other_*.raw", "a number for the *"});
}

TEST_F(TimeStepFiles, MustBeChosenOrAreTheFirst) {
  const std::string pattern = write_list();
  expect_error(pattern, {"3 files", "?frame=0", "--frame 0"});
  const OpenChoice choice = choice_of(pattern);
  EXPECT_EQ(choice.kind, ChoiceKind::frame);
  EXPECT_EQ(choice.count, 3U);
  EXPECT_EQ(chosen_source(choice, 2), pattern + "?frame=2");
  EXPECT_EQ(load_first_step(pattern).values[0], 30.F);
  EXPECT_EQ(load_first_step(pattern + "?frame=2").values[0], 50.F);
}

TEST_F(TimeStepFiles, TakeTheQueryEach) {
  for (int i = 0; i < 2; ++i) write(fmt::format("v{}.bin", i), cube(10 * i));
  const std::string query = "size=2x2x2&type=uint8", pattern = path("v*.bin");
  EXPECT_EQ(load_volume(pattern + "?frame=1&" + query).values[0], 10.F);
  EXPECT_EQ(load_first_step(pattern + "?" + query).values[0], 0.F);
  EXPECT_EQ(source_of_step(pattern + "?frame=0&" + query, 1), pattern + "?frame=1&" + query);
  // Without it, it is asked for, of all of them
  OpenChoice asked;
  try {
    load_first_step(pattern);
  } catch (const ChoiceNeeded& needed) {
    asked = needed.choice;
  }
  EXPECT_EQ(asked.kind, ChoiceKind::raw_layout);
  EXPECT_EQ(asked.path, pattern);
  EXPECT_TRUE(asked.query.empty());
  EXPECT_EQ(first_file(asked.path), path("v0.bin"));
}

TEST_F(TimeStepFiles, OfOneFileAreItsFrames) {
  const std::string header = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 2 2 3\nencoding: raw\n\n";
  const std::string file = write("film.nrrd", header + cube(20) + cube(5) + cube(90));
  expect_error(file, {"3 frames", "?frame=0", "--frame 0"});
  const Volume first = load_first_step(file);
  EXPECT_EQ(first.values[0], 20.F);
  EXPECT_EQ(first.frames, 3);
  EXPECT_EQ(first.frame, 0);
  EXPECT_EQ(load_volume(source_of_step(file, 2)).frame, 2);
  EXPECT_EQ(range_of_steps(file, first), (ValueRange{5, 97}));
  // A list of such files has two numbers for a step
  write("film1.nrrd", header + cube(0) + cube(0) + cube(0));
  write("film2.nrrd", header + cube(0) + cube(0) + cube(0));
  expect_error(path("film*.nrrd") + "?frame=1", {"film2.nrrd", "3 frames"});
}

TEST_F(TimeStepFiles, HaveARangeTogether) {
  const std::string pattern = write_list();
  const Volume one = load_first_step(pattern);
  EXPECT_EQ(one.statistics.range, (ValueRange{30, 37}));
  EXPECT_EQ(range_of_steps(pattern, one), (ValueRange{10, 57}));
  write("step_12_2x2x2_uint8.raw", "x");
  EXPECT_THROW(range_of_steps(pattern, load_first_step(pattern)), Error) << "a damaged one";
}

TEST_F(TimeStepFiles, GiveWayToAFileOfThatName) {
  write("a1_2x2x2_uint8.raw", cube(1));
  const std::string file = write("a*_2x2x2_uint8.raw", cube(70));
  const Volume volume = load_volume(file);
  EXPECT_EQ(volume.values[0], 70.F);
  EXPECT_EQ(volume.frames, 1);
}

}  // namespace
}  // namespace crest::test
