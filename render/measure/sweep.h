#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "render/measure/measurement.h"
#include "render/measure/methods.h"
#include "render/measure/plan.h"
#include "render/reference/reference.h"
#include "render/scene/scene.h"

namespace crest {

/// What a sweep asks of a renderer. measure_scene() has the real one; it is called from the thread that calls
/// Sweep::next().
struct Measurer {
  struct Picture {
    Image image;
    double samples_per_ray = 0, dvr_samples_per_ray = 0;
    double crossings_per_ray = 0, crossings_left_out_per_ray = 0;
    std::vector<std::uint32_t> crossings;  ///< composited, by pixel
  };
  struct FrameTime {
    double wall_ms = 0, device_ms = 0;
  };
  struct Start {
    double first_frame_ms = 0, edit_ms = 0;  ///< see MethodStart
  };
  std::function<Reference(const ExactAnswer&, const Progress&)> reference;  ///< throws Cancelled
  std::function<Start(const Rendering&)> start;                             ///< may make the next frames slow
  std::function<Picture(const Rendering&)> picture;  ///< and makes the next frames fast
  std::function<FrameTime(const Rendering&)> frame;
  std::function<double()> seconds;  ///< a clock that only goes forward
};

struct SweepSettings {
  std::optional<double> budget_seconds =
      {};  ///< for all of it, exact answers included; without one, every point
  TargetError target = default_target();
  int frames = 5;            ///< timed of each point: more of short ones, 3 where one takes over a second
  double group_seconds = 4;  ///< points are timed turn by turn in groups of about this long
  /// A point whose frame is expected to take longer is left out.
  double longest_frame_ms = std::numeric_limits<double>::infinity();
};

/// What a sweep is doing: "exact answer 'integral'", "dvr at step 0.25", and how far it is with that, in
/// [0, 1].
using SweepStatus = std::function<void(std::string_view doing, double done)>;

/// Measures a scene's methods, one point after the other, the most informative first (see plan_points).
/// An exact answer is rendered when the methods of those before it are covered: first that of the scene's own
/// mode, then `integral`, then the others of the scene's own field; those of other filters, which take
/// longer, when nothing more informative is left to measure. Plain values come out; cancellable between
/// frames.
class Sweep {
 public:
  /// `scene` tells the TF, the own mode, and the settings that no method changes (measured_rendering).
  Sweep(Scene scene, Measurer measurer, SweepSettings settings = {},
        std::span<const Method> methods = crest::methods());

  struct Point {
    Measurement measurement;
    Image image;
  };

  /// Measures on until there is one more point. Nothing when all is measured, the budget does not allow more,
  /// or `stop` was asked for. Throws Error.
  std::optional<Point> next(std::stop_token stop = {}, const SweepStatus& status = {});

  const std::vector<Measurement>& measured() const { return measured_; }
  const std::vector<MethodStart>& starts() const { return starts_; }
  const std::map<ExactAnswer, Reference>& references() const { return references_; }
  /// Methods and answers that were left out so far and, after the end, the points that the budget did not
  /// allow.
  const std::vector<LeftOut>& left_out() const { return left_out_; }
  double seconds() const;                                          ///< since it began
  double reference_seconds() const { return reference_seconds_; }  ///< of these, for the exact answers

 private:
  double seconds_left() const;
  Rendering rendering_of(const PlannedPoint& point) const;
  std::vector<ExactAnswer> answers_of(const Method& method) const;
  bool is_ready(const Method& method) const;
  bool needs_reference(const std::vector<PlannedPoint>& plan) const;
  void render_next_reference(std::stop_token stop, const SweepStatus& status);
  std::vector<PlannedPoint> next_group(const std::vector<PlannedPoint>& plan) const;
  void measure(const std::vector<PlannedPoint>& group, std::stop_token stop, const SweepStatus& status);
  void start_method(const PlannedPoint& point);
  Point look_at(const PlannedPoint& point);
  void time_frames(const std::vector<PlannedPoint>& group, std::vector<Point>& points, std::stop_token stop);
  void tell_skipped(const std::vector<PlannedPoint>& plan);

  Scene scene_;
  Measurer measurer_;
  SweepSettings settings_;
  std::vector<const Method*> methods_;  ///< that make sense in the scene and have an exact answer
  std::vector<ExactAnswer> awaited_;    ///< answers not rendered yet, the next one first
  std::map<ExactAnswer, Reference> references_;
  std::vector<Measurement> measured_;
  std::vector<MethodStart> starts_;
  std::vector<LeftOut> left_out_;
  std::vector<Point> ready_;         ///< measured, but not handed out yet; the next one last
  std::optional<Rendering> anchor_;  ///< the first point's
  double first_anchor_ms_ = 0;       ///< its median in the first group
  int groups_ = 0;
  double began_ = 0, reference_seconds_ = 0;
  bool ended_ = false;
};

}  // namespace crest
