#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/studies/vdls/scenes.h"

namespace crest {

/// A way of rendering that is timed.
struct VdlsSetup {
  std::string name;
  Engine engine = Engine::vdls;
  VdlsOptions options;   ///< of VDLS
  bool skipping = true;  ///< of the ray caster
};
VdlsSetup vdls_setup(std::string name, const VdlsOptions& options);
/// VDLS basic and enhanced as in the paper (two layers a pass), and as it is by default; the ray caster
/// without skipping and with it.
std::vector<VdlsSetup> table_setups();
/// VDLS as it is by default, and the ray caster.
std::vector<VdlsSetup> engine_setups();

/// What a setup took for the same views as the others, turn by turn.
struct VdlsTiming {
  std::string setup;
  std::vector<double> frame_ms;  ///< by view
  double samples = 0;            ///< of a frame, its mean over the views that were counted
  double mean_ms() const;
  double frames_per_second() const { return 1e3 / mean_ms(); }
  double samples_per_second() const { return samples * frames_per_second(); }
};

/// How long and how many: views are drawn until the time is over, at least one and at most `views`.
struct VdlsEffort {
  double seconds = 1;
  int views = 100;
  std::stop_token stop;
};

/// What is drawn by each of its setups.
struct VdlsSubject {
  Scene scene;
  glm::ivec2 size;
  std::vector<VdlsSetup> setups;
};

/// All setups of all subjects, view by view from the same random directions, so that each number of a series
/// is the mean over as many views and all met the same machine. Each draws a first frame that is not timed.
/// `renderer` draws the first subject; one that needs another volume, TF or size gets a renderer of its own,
/// so that nothing is made anew between frames. Throws Cancelled when a stop is asked for.
std::vector<std::vector<VdlsTiming>> time_subjects(Renderer& renderer,
                                                   const std::vector<VdlsSubject>& subjects,
                                                   const VdlsEffort& effort);

/// What times may be proportional to: a power of a series' x.
struct VdlsScale {
  std::string name;
  double power = 1;
};

/// Times along something that grows: a figure of the paper.
struct VdlsSeries {
  std::string id, title, x_title;
  std::vector<VdlsScale> scales;  ///< that the paper claims
  struct Point {
    double x;
    std::string label;
    std::vector<VdlsTiming> timings;  ///< by setup
  };
  std::vector<Point> points;
};

/// frame_ms = fixed_ms + ms_per_unit x^power, fitted by least squares of the times' relative residuals.
struct LineFit {
  double fixed_ms = 0, ms_per_unit = 0;
  double fixed_share = 0;       ///< of the time at the largest x
  double largest_residual = 0;  ///< of a point's time, as a share of it
};
LineFit fit_line(const VdlsSeries& series, std::size_t setup, double power);

/// Whether the times grow as the paper claims: a line fits them, to a tenth; and it goes through zero, to a
/// tenth of the largest.
enum class Growth { proportional, linear, other };
Growth growth_of(const LineFit& fit);

}  // namespace crest
