#include <gtest/gtest.h>

#include <algorithm>

#include "presets/peaks.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

std::vector<Peak> peaks_of(const std::string& name) {
  return shown_peaks(find_peaks(load_preset(name).transfer_function));
}

std::size_t spikes_in(const std::vector<Peak>& peaks) {
  return std::size_t(std::count_if(peaks.begin(), peaks.end(), [](const Peak& p) { return p.spike; }));
}

TEST(Library, PresetsFitAnyVolumeAndSayWhichTheyAreFor) {
  EXPECT_GE(library().size(), 8u);
  for (const LibraryPreset& entry : library()) {
    const Preset preset = load_preset(std::string(entry.name));
    EXPECT_EQ(write_preset(preset), entry.text)
        << entry.name << " is not in the form in which presets are saved";
    EXPECT_EQ(preset.transfer_function.domain, Domain::normalized) << entry.name;
    EXPECT_EQ(preset.transfer_function.unit, LengthUnit::voxel) << entry.name;
    EXPECT_GE(preset.transfer_function.range().min, 0) << entry.name;
    EXPECT_LE(preset.transfer_function.range().max, 1) << entry.name;
    EXPECT_FALSE(preset.name.empty()) << entry.name;
    EXPECT_FALSE(preset.tags.empty()) << entry.name;
    EXPECT_NE(preset.notes.find("builtin:"), std::string::npos) << entry.name;
    EXPECT_FALSE(preset.camera) << entry.name << ": the whole volume is in view";
    EXPECT_EQ(preset.unknown + preset.rendering.unknown + preset.transfer_function.unknown, "") << entry.name;
  }
}

TEST(Library, TheDiracShellIsNearlyADiracImpulse) {
  const auto peaks = peaks_of("dirac-shell");
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_TRUE(peaks[0].spike);
  EXPECT_NEAR(peaks[0].width, 1e-4, 1e-12);
  EXPECT_EQ(peaks[0].opacity, 0.9);
}

TEST(Library, TheFourPeaksAreCloseAndNarrow) {
  const auto peaks = peaks_of("four-peaks");
  ASSERT_EQ(peaks.size(), 4u);
  EXPECT_EQ(spikes_in(peaks), 4u);
  EXPECT_LT(peaks[3].value - peaks[0].value, 0.1);
}

TEST(Library, TheSmoothHazeHasNoSpikes) {
  const auto peaks = peaks_of("smooth-haze");
  EXPECT_EQ(peaks.size(), 1u);
  EXPECT_EQ(spikes_in(peaks), 0u);
}

TEST(Library, TheTrueSpikeHasNoWidth) {
  const auto peaks = peaks_of("true-spike");
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_EQ(peaks[0].width, 0);
  EXPECT_TRUE(peaks[0].spike);
}

TEST(Library, TheStepIsASurfaceThoughNoPeak) {
  const auto peaks = peaks_of("step-surface");
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_FALSE(peaks[0].detected);
}

TEST(Library, TheOnionHasEightShellsAndTheFireSpansDecades) {
  EXPECT_EQ(spikes_in(peaks_of("onion")), 8u);
  const auto fire = peaks_of("fire");
  EXPECT_EQ(spikes_in(fire), 5u);
  EXPECT_GT(fire.back().value, 100 * fire.front().value);
}

}  // namespace
}  // namespace crest
