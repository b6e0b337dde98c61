#include "app/report/knoll_scenes.h"

#include <fmt/core.h>

#include <algorithm>

#include "knoll_presets_embedded.h"
#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/files/load.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr std::string_view heptane = "heptane.nii.gz", aneurism = "aneurism.nrrd", bonsai = "bonsai.nii.gz",
                           plume = "builtin:plume?n=96", vessels = "builtin:vessels?n=96",
                           noise = "builtin:noise?n=96&high=6";
constexpr std::string_view no_heptane = "A built-in plume stands in for the heptane fire.",
                           no_aneurism = "Built-in vessels stand in for the aneurism.",
                           no_zebrafish = "Band-limited noise stands in for the zebrafish's optic tract.",
                           no_fireset = "A built-in plume stands in for the fireset.",
                           bonsai_for_backpack = "A CT scan of a bonsai stands in for the backpack.",
                           no_backpack = "Band-limited noise stands in for the backpack.";

const BoxView close{{0.45, -1.15, 0.35}, {0, 0, 0.1}, {0, 0, 1}, 45};
const BoxView fire_along_x{{0.6, 3.3, 0.5}, {0, 0, 0}, {-1, 0, 0}, 36};  // the file's fire rises so
const BoxView fire_along_z{{0.5, -3.3, 0.6}, {0, 0, 0}, {0, 0, 1}, 36};

const KnollSceneRow rows[] = {
    {"heptane-3",
     "heptane (fig. 3)",
     {"heptane (f. 3)", "302x302x302", 190, 120, 7.1, 11.6, 8.8},
     heptane,
     plume,
     "",
     no_heptane,
     "near-dirac",
     "",
     &fire_along_x,
     &fire_along_z},
    {"heptane-5b",
     "heptane (fig. 5b)",
     {"heptane (f. 5b)", "302x302x302", 117, 58, 8.2, 17.0, 12.3},
     heptane,
     plume,
     "",
     no_heptane,
     "close-peaks",
     "",
     &fire_along_x,
     &fire_along_z},
    {"heptane-5c",
     "heptane (fig. 5c)",
     {"heptane (f. 5c)", "302x302x302", 230, 54, 10.6, 18.0, 12.7},
     heptane,
     plume,
     "",
     no_heptane,
     "smooth-peaks",
     "",
     &fire_along_x,
     &fire_along_z},
    {"zebrafish",
     "zebrafish (fig. 4)",
     {"zebrafish (f. 4)", "900x500x930", 1030, 165, 2.1, 2.0, 1.7},
     "",
     noise,
     "",
     no_zebrafish,
     "noisy-band",
     ""},
    {"aneurism-close",
     "aneurism, close (fig. 6)",
     {"aneurism (f. 6)", "256x256x256", 561, 342, 5.3, 8.6, 7.0},
     aneurism,
     vessels,
     "",
     no_aneurism,
     "vessels",
     "",
     &close,
     &close},
    {"aneurism-bspline",
     "aneurism, B-spline (fig. 7)",
     {"+BS filter (f. 7)", "256x256x256", 157, 82, 1.8, 2.7, 2.5},
     aneurism,
     vessels,
     "",
     no_aneurism,
     "vessels",
     "filter=bspline"},
    {"fireset-close",
     "fireset, close (fig. 6)",
     {"fireset (f. 6)", "512x256x512", 336, 193, 6.6, 9.5, 7.3},
     "",
     "builtin:plume?n=96&seed=3",
     "",
     no_fireset,
     "fireset",
     "",
     nullptr,
     &close},
    {"backpack-far",
     "backpack (fig. 7)",
     {"backpack (f. 7)", "512x512x373", 1078, 633, 2.1, 2.9, 2.1},
     bonsai,
     noise,
     bonsai_for_backpack,
     no_backpack,
     "scanned-layers",
     ""},
    {"aneurism-far", "aneurism, far (fig. 7)", {}, aneurism, vessels, "", no_aneurism, "vessels", ""},
    {"many-peaks", "twelve close peaks", {}, "", noise, "", "Not of the paper.", "many-peaks", ""},
};

/// An embedded preset of the study, or one of the library.
Preset study_preset(std::string_view name) {
  for (const auto& file : knoll_presets::embedded_files())
    if (file.name == fmt::format("report/knoll/{}.json", name)) return parse_preset(file.text, file.name);
  return load_preset(std::string(name));
}

}  // namespace

std::span<const KnollSceneRow> knoll_scene_rows() { return rows; }

const KnollSceneRow& knoll_scene_row(std::string_view id) {
  return *std::ranges::find(rows, id, &KnollSceneRow::id);
}

KnollScenes::KnollScenes(std::filesystem::path folder, double aspect)
    : folder_(std::move(folder)), aspect_(aspect) {
  if (!folder_.empty() && !std::filesystem::is_directory(folder_))
    throw Error(fmt::format("{}: is no folder; --data is the folder of the real volumes", folder_.string()));
}

std::shared_ptr<const Volume> KnollScenes::load(const std::string& source) {
  auto& volume = volumes_[source];
  if (!volume) volume = std::make_shared<const Volume>(load_volume(source));
  return volume;
}

KnollScene KnollScenes::make(const KnollSceneRow& row) {
  KnollScene scene;
  scene.id = row.id;
  scene.title = row.title;
  scene.preset = row.preset;
  const bool is_real = !row.file.empty() && !folder_.empty() && std::filesystem::exists(folder_ / row.file);
  scene.volume = is_real ? (folder_ / row.file).string() : std::string(row.builtin);
  scene.note = is_real ? row.note_on_file : row.note_on_builtin;
  const auto volume = load(scene.volume);
  Preset preset = study_preset(row.preset);
  preset.rendering = with_settings(preset.rendering, row.settings);
  scene.scene = make_scene(volume, preset);
  const BoxView* view = is_real ? row.view_of_file : row.view_of_builtin;
  scene.camera = view ? camera_in_box(volume->grid, *view) : whole_volume_camera(volume->grid, aspect_);
  return scene;
}

Preset preset_of(const KnollScene& scene, const Variant& variant) {
  const Scene measured = measured_scene(scene, variant);
  Preset preset;
  preset.name = fmt::format("{}, {}", scene.title, variant.name);
  preset.transfer_function = measured.tf;
  preset.rendering = measured.rendering;
  preset.camera = scene.camera;
  return preset;
}

}  // namespace crest
