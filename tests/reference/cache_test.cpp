#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/reference/cache.h"
#include "render/scene/camera.h"
#include "tests/reference/rays.h"

namespace crest::testing {
namespace {

namespace fs = std::filesystem;
constexpr glm::ivec2 size{16, 12};

std::shared_ptr<Volume> wave_volume() {
  return std::make_shared<Volume>(
      *volume_of({5, 4, 6}, [](int i, int j, int k) { return (i * 3 + j * 5 + k * 7) % 8; }));
}

class ReferenceCache : public ::testing::Test {
 protected:
  ReferenceCache() {
    std::string name = (fs::temp_directory_path() / "crest-cache-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder = name;
    TransferFunction tf = colored(tf_of({{0, 0}, {3, 0.1}, {4, 0.8}, {5, 0.1}, {8, 0.3}}), {{1, 0.5, 0.25}});
    scene = scene_of(wave_volume(), tf);
    camera = whole_volume_camera(scene.volume->grid, 1);
  }
  ~ReferenceCache() override {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }

  CachedReference render(std::uintmax_t limit = default_cache_bytes) const {
    return render_reference_cached(folder, limit, scene, camera, size, Answer::integral_and_crossings);
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
  }
  std::string only_file() const {
    EXPECT_EQ(files().size(), 1u);
    return files().at(0).string();
  }

  fs::path folder;
  Scene scene;
  Camera camera;
};

void expect_same(const Reference& a, const Reference& b) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.crossings, b.crossings);
  EXPECT_EQ(a.grazing, b.grazing);
}

TEST_F(ReferenceCache, GivesBackWhatWasRendered) {
  folder /= "made/when needed";
  const CachedReference first = render(), second = render();
  EXPECT_FALSE(first.from_cache);
  EXPECT_TRUE(second.from_cache);
  expect_same(first.reference, second.reference);
  expect_same(first.reference, render_reference(scene, camera, size, Answer::integral_and_crossings));
  EXPECT_GT(*std::ranges::max_element(first.reference.crossings), 1u);
}

TEST_F(ReferenceCache, AnyOtherContentIsAnotherPicture) {
  render();
  const Scene same = scene;
  const Camera same_camera = camera;
  const std::vector<std::function<void()>> changes = {
      [&] { scene.tf.points[2].value = std::nextafter(4.0, 5.0); },
      [&] { scene.tf.points[2].opacity += 1e-15; },
      [&] { scene.tf.points[2].color.g += 1e-12; },
      [&] { scene.tf.points[2].surface.mode = SurfaceMode::off; },
      [&] { scene.tf.points[2].surface.opacity = 0.5; },
      [&] { scene.tf.unit_distance *= 2; },
      [&] { scene.tf.min_prominence = 0.9; },
      [&] { scene.tf.plateau_width = 0.5; },
      [&] { scene.tf.spike_width = 0.5; },
      [&] {
        scene.rendering.clip_box = ClipBox{{1, 1, 1}, {2, 2, 2}, {}};
      },
      [&] { scene.rendering.filter = Filter::bspline; },
      [&] { scene.rendering.root_filter = Filter::bspline; },
      [&] { scene.rendering.filter = Filter::bc; },
      [&] {
        scene.rendering.filter = Filter::bc;
        scene.rendering.bc_b = std::nextafter(scene.rendering.bc_b, 1.0);
      },
      [&] {
        scene.rendering.filter = Filter::bc;
        scene.rendering.bc_c += 1e-15;
      },
      [&] { camera.eye.x += 1e-13; },
      [&] { camera.target.y += 1e-13; },
      [&] { camera.up.z = 0.5; },
      [&] { camera.fov_y_degrees = 31; },
      [&] {
        auto volume = wave_volume();
        volume->values.floats()[50] = std::nextafter(volume->values[50], 9.0f);
        scene.volume = volume;
      },
      [&] {
        auto volume = wave_volume();
        std::swap(volume->grid.dims.x, volume->grid.dims.y);
        scene.volume = volume;
      },
      [&] {
        auto volume = wave_volume();
        volume->grid.spacing.x = 1.5;
        scene.volume = volume;
      },
      [&] {
        auto volume = wave_volume();
        volume->grid.origin.z = 1e-9;
        scene.volume = volume;
      }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    scene = same;
    camera = same_camera;
    changes[i]();
    EXPECT_FALSE(render().from_cache) << "change " << i;
  }
  scene = same;
  camera = same_camera;
  const auto is_cached = [&](glm::ivec2 s, Answer answer, double tolerance) {
    return render_reference_cached(folder, default_cache_bytes, scene, camera, s, answer, tolerance)
        .from_cache;
  };
  EXPECT_FALSE(is_cached({12, 16}, Answer::integral_and_crossings, default_tolerance));
  EXPECT_FALSE(is_cached(size, Answer::base_and_crossings, default_tolerance));
  EXPECT_FALSE(is_cached(size, Answer::integral_and_crossings, 1e-9));
  EXPECT_TRUE(is_cached(size, Answer::integral_and_crossings, default_tolerance));
}

TEST_F(ReferenceCache, WhatHasNoPartInItChangesNothing) {
  render();
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.engine = Engine::reference;
  scene.rendering.step = 0.125;
  scene.rendering.shading = Shading::gradient;
  scene.rendering.early_termination = 0.1;
  scene.rendering.background = glm::dvec3(1);
  scene.rendering.filter = Filter::linear_exact;  // the same field
  scene.rendering.root_filter = Filter::linear;
  scene.rendering.bc_b = 0.5;  // of another filter
  scene.rendering.gradient = Gradient::filter;
  scene.volume = wave_volume();
  EXPECT_TRUE(render().from_cache);
}

TEST_F(ReferenceCache, ADamagedFileIsRenderedAgain) {
  const Reference exact = render().reference;
  const std::string content = read_file(only_file(), 1 << 20);
  std::vector<std::string> damaged = {"", content.substr(0, 100), content.substr(0, content.size() - 1),
                                      content + '\0', std::string(content.size(), '\0')};
  for (std::size_t place = 0; place < content.size(); place += content.size() / 20) {
    damaged.push_back(content);
    damaged.back()[place] = char(damaged.back()[place] ^ 1);
  }
  damaged.push_back(content);
  damaged.back().back() = char(damaged.back().back() ^ 1);
  for (std::size_t i = 0; i < damaged.size(); ++i) {
    write_file_atomically(only_file(), damaged[i]);
    const CachedReference again = render();
    EXPECT_FALSE(again.from_cache) << "damage " << i;
    expect_same(again.reference, exact);
    EXPECT_TRUE(render().from_cache) << "it was not mended after damage " << i;
  }
}

TEST_F(ReferenceCache, AFileUnderTheNameOfAnotherIsNotTaken) {
  render();
  const std::string other = only_file(), content = read_file(other, 1 << 20);
  fs::remove(other);
  scene.tf.points[2].color.r = 0.5;
  const Reference exact = render().reference;
  write_file_atomically(only_file(), content);
  const CachedReference again = render();
  EXPECT_FALSE(again.from_cache);
  expect_same(again.reference, exact);
}

TEST_F(ReferenceCache, KeepsToItsLimit) {
  const auto render_red = [&](double r, std::uintmax_t limit) {
    scene.tf.points[2].color.r = r;
    return render(limit).from_cache;
  };
  const auto used = [&](const fs::path& file, int hours_ago) {
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours_ago));
  };
  render_red(0.1, default_cache_bytes);
  const fs::path first = only_file();
  const std::uintmax_t bytes = fs::file_size(first), room_for_two = 2 * bytes + 100;
  used(first, 5);
  render_red(0.2, room_for_two);
  ASSERT_EQ(files().size(), 2u);
  used(files()[0] == first ? files()[1] : files()[0], 3);
  EXPECT_TRUE(render_red(0.1, room_for_two));  // so it was used last
  write_file_atomically(folder / "notes.txt", std::string(10 * bytes, 'x'));

  EXPECT_FALSE(render_red(0.3, room_for_two));
  EXPECT_EQ(files().size(), 3u);  // with the one that is not the cache's
  EXPECT_TRUE(render_red(0.1, room_for_two));
  EXPECT_TRUE(render_red(0.3, room_for_two));
  EXPECT_FALSE(render_red(0.2, bytes / 2));  // was dropped; and one that is too large drops no other
  EXPECT_TRUE(render_red(0.1, room_for_two));
  EXPECT_TRUE(render_red(0.3, room_for_two));
  EXPECT_FALSE(render_red(0.2, room_for_two));
}

TEST_F(ReferenceCache, NoFolderIsNoError) {
  const Reference exact = render().reference;
  const fs::path in_a_file = only_file();
  for (const fs::path& none : {fs::path(), in_a_file, in_a_file / "below", fs::path("/proc/none")}) {
    folder = none;
    for (int i = 0; i < 2; ++i) {
      const CachedReference rendered = render();
      EXPECT_FALSE(rendered.from_cache) << none;
      expect_same(rendered.reference, exact);
    }
  }
}

TEST_F(ReferenceCache, AFolderThatCannotBeWrittenIsNoError) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(render().from_cache);
  EXPECT_FALSE(render().from_cache);
}

TEST_F(ReferenceCache, NothingIsKeptOfWhatWasStoppedOrFailed) {
  const auto stop = [](double) { return false; };
  EXPECT_THROW(render_reference_cached(folder, default_cache_bytes, scene, camera, size, Answer::integral,
                                       default_tolerance, stop),
               Cancelled);
  camera.target = camera.eye;
  EXPECT_THROW(render(), Error);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace crest::testing
