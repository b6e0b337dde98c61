#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/raycaster/trace_ray.h"
#include "render/renderer.h"
#include "ui/ray_inspection.h"

namespace crest {

/// Solves and traces the ray that is inspected, and the one under the mouse.
class RayInspector {
 public:
  /// From now on this ray is wanted; `scene` is the document's. What is known of another scene's same ray is
  /// shown until work() has solved it anew.
  void want(const Scene& scene, const Camera& camera, const RayAsk& ask);
  void clear() { wanted_.reset(); }
  /// And nothing of the volume is held.
  void forget() { *this = {}; }
  /// Solves one mode that is out of date, if there is one, and traces it; that is there in a later call,
  /// since nothing waits for the device.
  void work(Renderer& renderer);
  bool is_busy() const;  ///< whether there is one
  /// What is known of the ray; null while nothing is wanted.
  const RayInspection* inspection() const { return wanted_ ? &wanted_->inspection : nullptr; }

  /// What is under the mouse in a picture of `scene`.
  PickedPixel pick(const Scene& scene, const Camera& camera, const RayAsk& ask);

 private:
  struct Subject {
    Scene scene;
    Camera camera;
    bool is(const Scene& other, const Camera& its_camera) const;
  };
  struct Wanted {
    Subject subject;
    RayInspection inspection;
    std::array<bool, view_count> is_current{};
    struct Tracing {
      std::size_t mode;
      InspectedRay ray;
      PendingTrace steps;
    };
    std::optional<Tracing> tracing;
  };
  struct Picking {
    Subject subject;
    ExactRays rays;
    PickedPixel last;
  };
  void begin(Renderer& renderer, std::size_t mode);
  void take();

  std::optional<Wanted> wanted_;
  std::unique_ptr<Picking> picking_;
  std::shared_ptr<const reference::EmptyCells> empty_cells_;  ///< of the volume that was looked at last
};

/// The inspected ray as a table: a row for each mode and place, of the exact answer and as drawn.
std::string ray_table(const RayInspection& inspection);

}  // namespace crest
