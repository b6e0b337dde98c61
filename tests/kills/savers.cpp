#include "savers.h"

#include <cstdlib>
#include <random>

#include "app/recent_files.h"
#include "app/recovery_file.h"
#include "app/report/report_files.h"
#include "app/studio_settings.h"
#include "presets/json.h"
#include "presets/preset_file.h"
#include "render/files/folder_cache.h"
#include "render/files/image.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;

Preset preset_of(int version) {
  std::mt19937 random(unsigned(version) + 1U);
  std::uniform_real_distribution<double> unit(0, 1);
  Preset preset;
  preset.name = "version " + std::to_string(version);
  preset.transfer_function.points.clear();
  for (int i = 0; i < 40; ++i) {
    ControlPoint point;
    point.value = i / 39.0;
    point.color = {unit(random), unit(random), unit(random)};
    point.opacity = unit(random);
    preset.transfer_function.points.push_back(point);
  }
  return preset;
}

/// Noise, which does not get small in a file.
Image noise(int version) {
  std::mt19937 random(unsigned(version) + 1U);
  std::uniform_real_distribution<float> unit(0, 1);
  Image image{{48, 48}, std::vector<glm::vec4>(48 * 48)};
  for (glm::vec4& pixel : image.pixels) pixel = glm::vec4(unit(random), unit(random), unit(random), 1);
  return image;
}

Report report_of(int version) {
  Report report;
  auto volume = std::make_shared<Volume>();
  volume->name = "version " + std::to_string(version);
  report.scene.volume = volume;
  report.scene.rendering.mode = Mode::dvr_only;
  report.size = {48, 48};
  report.subject = {.command = "crest report",
                    .volume = volume->name,
                    .preset = "",
                    .renderer = "none",
                    .made_at = "2026-01-02T03:04:05Z",
                    .render_command = [](const Method&, double) { return std::string("crest render"); }};
  constexpr std::size_t pixels = 48 * 48;
  const Reference exact{{48, 48},
                        std::vector<glm::dvec4>(pixels, glm::dvec4(0.5)),
                        std::vector<std::uint32_t>(pixels),
                        std::vector<std::uint8_t>(pixels)};
  report.references = {{Answer::integral, exact}};
  Measurement point;
  point.method = "dvr";
  point.step = 1;
  point.errors = {{Answer::integral, image_error(exact, noise(version), {}, glm::vec3(0))}};
  report.points.push_back(point);
  report.pictures[0] = noise(version);
  return report;
}

void save_unsaved_changes(const fs::path& folder, int version) {
  auto left = RecoveryFile::left_behind(folder);
  const RecoveryFile file = left.empty() ? RecoveryFile(folder) : std::move(left.front());
  KeptDocument kept;
  kept.document.preset = preset_of(version);
  kept.time = std::chrono::system_clock::time_point(std::chrono::seconds(version));
  file.write(kept);
}

void save_recent(const fs::path& folder, int version) {
  ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  RecentFiles().add("/volumes/" + std::string(3000, char('a' + version)));
}

}  // namespace

std::vector<Saver> savers() {
  return {
      {"preset", [](const fs::path& folder, int v) { save_preset(folder / "a.json", preset_of(v)); }},
      {"picture",
       [](const fs::path& folder, int v) {
         write_image(folder / "a.png", noise(v), glm::vec3(0), write_preset(preset_of(v)));
       }},
      {"report", [](const fs::path& folder, int v) { write_report(report_of(v), folder); }},
      {"cache", [](const fs::path& folder,
                   int v) { write_cached(folder / "a.cached", std::string(20000, char('0' + v)), 1 << 20); }},
      {"recent files", save_recent},
      {"unsaved changes", save_unsaved_changes},
      {"settings",
       [](const fs::path& folder, int v) {
         StudioSettings settings;
         settings.theme = v % 2 ? Theme::light : Theme::dark;
         write_settings(folder / "settings.json", settings);
       }},
  };
}

}  // namespace crest::test
