#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace crest {

/// A scene of the study of view-dependent layer sampling.
struct VdlsScene {
  std::string id, title;  ///< for file names; for people
  Scene scene;            ///< DVR_ONLY, one sample a voxel, shaded by the gradient
};

/// Six volumes as in the paper's Table 2: a gyroid of 32^3 and Marschner and Lobb's function at 64^3, and a
/// hydrogen atom, a head, an engine and a bonsai from `folder`, where files of these names are there; else
/// the built-in volumes that are nearest.
std::vector<VdlsScene> vdls_scenes(const std::filesystem::path& folder);

/// One of them, or one alike: opaque surfaces from `threshold`, a share of the volume's range, on.
VdlsScene surface_scene(std::string id, std::string title, std::shared_ptr<const Volume> volume,
                        double threshold);

/// A built-in volume, by its query, in such a scene.
VdlsScene builtin_surface_scene(const std::string& query);

/// Opaque in one part of the volume's range, from and to as shares, and transparent elsewhere.
TransferFunction opaque_range(ValueRange field, double from, double to);

/// The paper's R = G = B = alpha = D, where D runs from 0 to 1 over the volume's range.
TransferFunction grey_ramp(ValueRange field);

/// A phantom of 64^3: shells of a sphere in haze, unshaded.
VdlsScene phantom_scene();

/// Random directions, the same for the same seed, from so far that the whole volume is in view.
std::vector<Camera> random_views(const Grid& grid, int count, std::uint64_t seed);

}  // namespace crest
