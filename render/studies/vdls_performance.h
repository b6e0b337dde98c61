#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/studies/vdls_scenes.h"

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

/// All setups in one scene, seen from random directions. Each draws a first frame that is not timed. Throws
/// Cancelled when a stop is asked for.
std::vector<VdlsTiming> time_setups(Renderer& renderer, const Scene& scene, glm::ivec2 size,
                                    const std::vector<VdlsSetup>& setups, const VdlsEffort& effort);

/// Times along something that grows: a figure of the paper.
struct VdlsSeries {
  std::string id, title, x_title;
  bool is_scaling = false;  ///< x is what the times are to be proportional to
  struct Point {
    double x;
    std::string label;
    std::vector<VdlsTiming> timings;  ///< by setup
  };
  std::vector<Point> points;
};

/// frame_ms = c x^exponent, fitted to a series by least squares of the logarithms.
struct PowerFit {
  double exponent = 0;
  double largest_residual = 0;  ///< of a point's time, as a share of it
};
PowerFit fit_power(const VdlsSeries& series, std::size_t setup);

}  // namespace crest
