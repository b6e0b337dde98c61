#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "render/measure/sweep.h"

namespace crest {

/// What a report is of, beyond what was measured: as its reader is told it.
struct ReportSubject {
  std::string command;   ///< that makes this report
  std::string volume;    ///< as given
  std::string preset;    ///< as given, or empty
  std::string renderer;  ///< as the driver names itself
  std::string made_at;   ///< UTC, ISO 8601
  /// The command that renders with a setting of the sweep.
  std::function<std::string(const Method&, double step)> render_command;
};

/// Error against run time, of a scene as a camera sees it.
struct Report {
  ReportSubject subject;
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};
  SweepSettings settings;

  std::vector<Measurement> points;
  std::map<std::size_t, Image> pictures;  ///< of some points: see keep_picture()
  std::vector<MethodStart> starts;
  std::map<ExactAnswer, Reference> references;
  std::vector<LeftOut> left_out;
  double seconds = 0, reference_seconds = 0;
  bool stopped = false;  ///< before its time, by the person

  glm::vec3 background() const { return scene.rendering.background; }
};

/// Runs a whole sweep into `report`, whose first fields are set. A GL 4.5 context is current.
void measure_report(Report& report, std::stop_token stop, const SweepStatus& status);

/// Pictures are kept of a method's point nearest to this step,
inline constexpr double typical_step = 0.5;
/// and of its cheapest point under the target, for each answer: `points` without pictures.
std::vector<std::size_t> pictured_points(const std::vector<Measurement>& points, const TargetError& target);

}  // namespace crest
