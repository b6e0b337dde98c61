#include "presets/preset_changes.h"

#include <gtest/gtest.h>

#include <functional>

#include "presets/point_changes.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

using Sentences = std::vector<std::string>;

Preset hill() {
  Preset preset;
  for (const auto& [value, opacity] :
       {std::pair{0.0, 0.0}, {20.0, 0.2}, {50.0, 0.8}, {70.0, 0.1}, {100.0, 0.5}}) {
    ControlPoint point;
    point.value = value;
    point.opacity = opacity;
    preset.transfer_function.points.push_back(point);
  }
  return preset;
}

/// What is said of an edit of the hill.
Sentences after(const std::function<void(Preset&)>& edit) {
  Preset edited = hill();
  edit(edited);
  return preset_changes(hill(), edited);
}
Sentences after_points(const std::function<void(std::vector<ControlPoint>&)>& edit) {
  return after([&](Preset& preset) { edit(preset.transfer_function.points); });
}

ControlPoint at(double value, double opacity) {
  ControlPoint point;
  point.value = value;
  point.opacity = opacity;
  return point;
}

TEST(PresetChanges, NothingIsSaidOfEqualPresets) {
  EXPECT_EQ(after([](Preset&) {}), Sentences{});
}

TEST(PresetChanges, PointsThatMove) {
  EXPECT_EQ(after_points([](auto& p) { p[2].value = 55; }), Sentences{"Move the point at 50 to 55"});
  EXPECT_EQ(after_points([](auto& p) { p[1].value = 22, p[4].value = 90; }), Sentences{"Move 2 points"});
  EXPECT_EQ(after_points([](auto& p) { p[2].opacity = 0.9; }),
            Sentences{"Change the opacity at 50 from 0.8 to 0.9"});
  EXPECT_EQ(after_points([](auto& p) { p[2].opacity = 0.9, p[3].opacity = 0; }),
            Sentences{"Change the opacity of 2 points"});
  EXPECT_EQ(after_points([](auto& p) { p[2] = at(60, 0.8), p[3] = at(60.5, 0.1); }),
            Sentences{"Move the peak at 50 to 60"});
}

TEST(PresetChanges, APointThatPassesAnotherIsOnePoint) {
  EXPECT_EQ(after_points([](auto& p) {
              p.erase(p.begin() + 1);
              p.insert(p.begin() + 2, at(60, 0.2));
            }),
            Sentences{"Move the point at 20 to 60"});
}

TEST(PresetChanges, ASpikeThatMovesIsNamedByItsValue) {
  Preset before = hill();
  auto& points = before.transfer_function.points;
  points.insert(points.begin() + 3, {at(60, 0.45), at(60, 1), at(60, 0.45)});
  Preset moved = before;
  for (std::size_t i = 3; i < 6; ++i) moved.transfer_function.points[i].value = 62;
  EXPECT_EQ(preset_changes(before, moved), Sentences{"Move the spike at 60 to 62"});
}

TEST(PresetChanges, PointsThatComeAndGo) {
  EXPECT_EQ(after_points([](auto& p) { p.insert(p.begin() + 2, at(30, 0.4)); }),
            Sentences{"Add the point at 30"});
  EXPECT_EQ(after_points([](auto& p) {
              p.insert(p.begin() + 4, {at(80, 0.2), at(85, 0.9), at(90, 0.3)});
            }),
            Sentences{"Add a peak at 85"});
  EXPECT_EQ(after_points([](auto& p) {
              p.insert(p.begin() + 4, {at(85, 0.3), at(85, 0.9), at(85, 0.3)});
            }),
            Sentences{"Add a spike at 85"});
  EXPECT_EQ(after_points([](auto& p) { p.erase(p.begin() + 1, p.begin() + 3); }),
            Sentences{"Delete a peak at 50"});
  EXPECT_EQ(after_points([](auto& p) { p.erase(p.begin() + 3); }), Sentences{"Delete the point at 70"});
  EXPECT_EQ(after_points([](auto& p) { p.erase(p.begin(), p.begin() + 2); }), Sentences{"Delete 2 points"});
  EXPECT_EQ(after_points([](auto& p) {
              p = {at(1, 0), at(2, 1), at(3, 0)};
            }),
            Sentences{"Replace 5 points by 3"});
}

TEST(PresetChanges, ColoursAndSurfaces) {
  EXPECT_EQ(after_points([](auto& p) { p[1].color = {1, 0, 0}; }), Sentences{"Change the colour at 20"});
  EXPECT_EQ(after_points([](auto& p) {
              for (auto& point : p) point.color = {1, 0, 0};
            }),
            Sentences{"Change the colour of 5 points"});
  EXPECT_EQ(after_points([](auto& p) {
              p[1].surface = {SurfaceMode::on, 0.5};
            }),
            Sentences{"Change the surface at 20 from auto to on, opacity 0.5"});
}

TEST(PresetChanges, ADragIsOneSentenceAndWhatElseChangedAnother) {
  EXPECT_EQ(after_points([](auto& p) { p[2] = at(55, 0.9); }),
            Sentences{"Move the point at 50 to 55, with its opacity"});
  EXPECT_EQ(after_points([](auto& p) {
              p[2] = at(55, 0.8), p[2].color = {1, 0, 0};
            }),
            (Sentences{"Move the point at 50 to 55", "Change the colour at 55"}));
}

TEST(PresetChanges, Settings) {
  EXPECT_EQ(after([](Preset& p) { p.rendering.step = 0.25; }), Sentences{"Change step from 0.5 to 0.25"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.mode = Mode::peak_xor_dvr; }),
            Sentences{"Change mode from both to PEAK_XOR_DVR"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.adaptive = true; }), Sentences{"Switch adaptive on"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.vdls.leaves = 16; }), Sentences{"Change leaves from 32 to 16"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.root_filter = Filter::bspline; }),
            Sentences{"Change filter of surfaces from that of the samples to bspline"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.clip_box = ClipBox{}; }), Sentences{"Set the clip box"});
  EXPECT_EQ(after([](Preset& p) { p.rendering.background = {1, 1, 1}; }), Sentences{"Change the background"});
  EXPECT_EQ(after([](Preset& p) { p.transfer_function.unit_distance = 3; }),
            Sentences{"Change unit distance from 1 to 3"});
  EXPECT_EQ(after([](Preset& p) { p.camera = Camera{}; }), Sentences{"Move the camera"});
  EXPECT_EQ(after([](Preset& p) {
              p.camera = Camera{};
              p.camera->projection = Projection::parallel;
            }),
            Sentences{"Switch to parallel projection"});
  EXPECT_EQ(after([](Preset& p) { p.name = "Hill", p.notes = "a\nb", p.tags = {"CT"}; }),
            (Sentences{"Name it Hill", "Change the notes", "Change the tags"}));
}

TEST(PresetChanges, AConversionIsOneThing) {
  EXPECT_EQ(after([](Preset& p) {
              p.transfer_function.domain = Domain::normalized;
              for (auto& point : p.transfer_function.points) point.value /= 100;
            }),
            Sentences{"Convert to normalized values"});
}

TEST(PresetChanges, EveryPresetOfTheLibraryIsToldFromEveryOther) {
  for (const LibraryPreset& one : library())
    for (const LibraryPreset& other : library()) {
      const Preset a = parse_preset(one.text, "a"), b = parse_preset(other.text, "b");
      EXPECT_EQ(preset_changes(a, b).empty(), one.name == other.name) << one.name << " to " << other.name;
    }
}

/// Undoing the alignment on one side must give the other.
TEST(AlignPoints, LeavesTheSamePointsOnBothSides) {
  const auto without = [](std::vector<ControlPoint> points, std::vector<std::size_t> gone) {
    std::sort(gone.rbegin(), gone.rend());
    for (const std::size_t i : gone) points.erase(points.begin() + std::ptrdiff_t(i));
    return points;
  };
  std::uint32_t seed = 1;
  const auto random = [&](std::uint32_t n) { return (seed = seed * 1664525 + 1013904223) / 65536 % n; };
  for (int round = 0; round < 300; ++round) {
    std::vector<ControlPoint> a, b;
    for (int i = 0; i < 12; ++i) {
      const ControlPoint point = at(i / 2, double(random(3)) / 2);
      if (random(4) > 0) a.push_back(point);
      if (random(4) > 0) b.push_back(point);
    }
    PointAlignment alignment = align_points(a, b);
    for (const auto& [i, j] : alignment.changed) alignment.removed.push_back(i), alignment.added.push_back(j);
    EXPECT_EQ(without(a, alignment.removed), without(b, alignment.added));
  }
}

TEST(AlignPoints, ManyThousandPointsTakeNoTime) {
  std::vector<ControlPoint> a, b;
  for (int i = 0; i < 200'000; ++i) a.push_back(at(i, 0.5)), b.push_back(at(i + 0.5, 0.25));
  EXPECT_EQ(align_points(a, b).changed.size(), a.size());  // the table of all pairs would be 160 GB
}

}  // namespace
}  // namespace crest
