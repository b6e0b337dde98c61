#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "presets/transfer_function.h"

namespace crest {

/// Which contributions a ray collects (Knoll et al. 2009, section 4.3).
enum class Mode { both, peak_xor_dvr, peak_only, dvr_only };
/// How a step that holds crossings is integrated: as published, or divided at its crossings.
enum class PeakForm { split, paper };
enum class Engine { raycaster, vdls, reference };
/// Where a ray's samples lie (Steneteg et al., Listings 1 to 4): one step apart, at whole steps from the eye
/// or midpoints of whole steps from the entry, as long as they lie within, so that their segments stick out
/// or fall short by up to half a step; or in equal segments from entry to exit, rounded down (none in a
/// corner shorter than a step) or up.
enum class Placement { eye, entry, entry_exit, entry_exit_corner };
/// How a step's colour and opacity follow from the field: the TF at a sample; the TF's antiderivatives
/// between the values at the step's ends; or Engel's table of both values, which holds one step length only.
/// Or there are no steps: the ray is solved from cell to cell, exactly.
enum class ClassificationMethod { post, preintegrated, preintegrated_table, analytic };
/// Step lengths along a ray: all the same; growing with the distance to the eye as published (Knoll et al.,
/// section 5); or in proportion to what a pixel covers.
enum class Sampling { uniform, differential, footprint };
/// How the field is reconstructed between the grid's points: trilinear by the texture unit; the same in
/// float; tricubic B-spline; the family of Mitchell and Netravali with its B and C.
enum class Filter { linear, linear_exact, bspline, bc };
enum class Shading { none, gradient };
/// What a sample contributes to its ray (view-dependent layer sampling, Table 1): its colour and opacity by
/// the TF, of a segment of the step's length (semi_transparent) or as they are (lookup); white and opaque
/// where the TF has at least half its greatest opacity (iso_surface); or its value as a grey, of which a ray
/// shows the greatest, the least or the mean.
enum class BlendMode { semi_transparent, lookup, iso_surface, maximum, minimum, mean };
/// How shading finds a gradient: central differences of the field, or the filter's own derivative.
enum class Gradient { central, filter };

/// Only what lies in this box is rendered: it brings new entry and exit points, and changes nothing else.
struct ClipBox {
  glm::dvec3 min{0}, max{1};  ///< world units; min < max on each axis
  std::string unknown;
  bool operator==(const ClipBox&) const = default;
};

/// How view-dependent layer sampling goes about its work. None of it changes the picture by more than float
/// rounding, but for the quantised gradients.
struct VdlsOptions {
  bool homo_regions = true;  ///< leap over what the TF makes transparent (section 4.1)
  int leaves = 32;  ///< the screen quadtree begins with leaves x leaves squares (4.2): a power of two to 256;
                    ///< 0 = no quadtree, the projected box is drawn
  int merge_threshold = 8;   ///< brothers whose sample counts differ by no more become one node
  bool early_test = true;    ///< rays that are out of the volume are left alone (4.3)
  int layers_per_pass = 16;  ///< samples that a pass takes of each ray (4.3), 1..64; the paper's card: 2
  bool back_to_front = false;
  bool gradient_volume = true;  ///< shading takes precomputed gradients (3.3); else those of the ray caster

  /// Without its speed-ups, one layer a pass.
  static VdlsOptions basic() { return {false, 0, 0, false, 1, false, true}; }
  bool operator==(const VdlsOptions&) const = default;
};

/// How a picture is made. Every field is one of the preset's JSON fields under "rendering".
struct Rendering {
  Mode mode = Mode::both;
  PeakForm peak_form = PeakForm::split;
  Engine engine = Engine::raycaster;
  VdlsOptions vdls;  ///< of that engine
  ClassificationMethod classification = ClassificationMethod::post;
  int preintegration_bins = 256;  ///< of the table on each axis, 2..2048
  double step = 0.5;              ///< at least 1e-3, in units of the smallest spacing; `uniform` alone
  Placement placement = Placement::entry_exit_corner;
  Sampling sampling = Sampling::uniform;
  double s_k = 4;         ///< steps at the eye, in pixels' diagonals at distance 1, of the other samplings
  bool adaptive = false;  ///< longer steps where the field is smooth (Knoll et al., section 6.2)
  bool skipping = true;   ///< of empty space
  Filter filter = Filter::linear;
  std::optional<Filter> root_filter;      ///< of the surfaces; without one, the same
  double bc_b = 1.0 / 3, bc_c = 1.0 / 3;  ///< Mitchell and Netravali's, -10..10
  int max_peaks = 4;    ///< most crossings that one step composites in the paper's form, 1..64
  int peak_bins = 128;  ///< bins of the peak table, 1..4096
  Shading shading = Shading::none;
  Gradient gradient = Gradient::central;
  BlendMode blend_mode = BlendMode::semi_transparent;  ///< others show no surfaces of peaks
  double early_termination = 0;  ///< residual transmittance at which a ray stops; 0 = never
  std::optional<ClipBox> clip_box;
  glm::dvec3 background{0};  ///< display-referred RGB in [0, 1]
  std::string unknown;
  bool operator==(const Rendering&) const = default;
};

/// The setting with `linear` in place of filters that make no trilinear field: what analytic classification
/// takes.
Rendering with_trilinear_filters(Rendering rendering);

/// Why these settings do not go together, and what would; empty where they do. Files are refused for it.
std::string why_inconsistent(const Rendering& rendering);

/// Whether a picture's rays come from the eye, or all run in one direction.
enum class Projection { perspective, parallel };

/// The ray of a pixel goes through the pixel's centre; row 0 is at the top. In parallel projection all rays
/// run along the line from eye to target, and begin before the volume wherever the eye is; the picture is as
/// high as in perspective at the target, 2 |target - eye| tan(fov_y / 2). So what lies in the target's plane
/// stays as large when the projection is switched, and a nearer eye magnifies in both.
struct Camera {
  glm::dvec3 eye{0, 0, 0}, target{0, 0, 1}, up{0, 1, 0};  ///< world units
  double fov_y_degrees = 30;                              ///< in (0, 180)
  Projection projection = Projection::perspective;
  std::string unknown;
  bool operator==(const Camera&) const = default;
};

/// Half the height of what is in view at the target, in world units.
double half_height_at_target(const Camera& camera);

/// All that a person saves.
struct Preset {
  std::string name, notes;
  std::vector<std::string> tags;  ///< words to find it by in a library
  TransferFunction transfer_function;
  Rendering rendering;
  std::optional<Camera> camera;  ///< without one, the whole volume is in view
  std::string unknown;
  bool operator==(const Preset&) const = default;
};

}  // namespace crest
