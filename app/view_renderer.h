#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>

#include "render/gl/display_texture.h"
#include "render/gl/timer.h"
#include "render/renderer.h"
#include "ui/studio.h"

namespace crest {

/// What a view is to show.
struct ViewRequest {
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};        ///< (0, 0): the view is not visible
  bool error_bound = false;  ///< of an exact scene: how far each pixel may be off, in place of the picture
  bool operator==(const ViewRequest& other) const;
};

/// Draws the views of the studio a slice at a time, so that the window stays live: at first coarse, then in
/// full; where an exact scene takes long, in between by samples that keep its surfaces. A coarse picture that
/// was begun is finished, so that a view keeps up with a drag; a finer one is dropped when the request
/// changes. Nothing is drawn again that did not change. Slices are handed to the device without waiting for
/// them; their times are read later, and only a few are ahead of it.
class ViewRenderer {
 public:
  /// As Renderer.
  explicit ViewRenderer(std::filesystem::path shader_folder = {}, std::filesystem::path program_folder = {});

  /// Works for about `budget_ms`, or hands the device as much to do. A view that cannot be drawn keeps its
  /// last picture; error() says why. `interactive`: begin with coarse pictures, since more changes are to
  /// come.
  void work(const std::array<ViewRequest, picture_count>& requests, double budget_ms, bool interactive);
  /// Why a view cannot be drawn as it is now requested; empty where all can.
  std::string error() const;
  /// Whether display() is at full resolution and what was requested last: of a view that cannot be drawn it
  /// is an earlier picture.
  bool shows_what_is_wanted(int view) const;
  /// Whether there is anything left to draw.
  bool is_busy() const;
  /// Whether that is no more than to hear from the device what the pictures cost.
  bool only_counts() const;

  ViewPicture picture(int view) const;
  /// What picture() names; null while there is none.
  const gl::DisplayTexture* display(int view) const { return views_[std::size_t(view)].shown(); }
  /// From now on pictures in full are kept in float, or no longer; those that were not are drawn again.
  void keep_colors(bool keep) { keeps_colors_ = keep; }
  /// The picture in full, over no background; null while it is not done, or was not kept.
  const gl::RenderTarget* colors(int view) const;
  glm::dvec3 background(int view) const {
    return views_[std::size_t(view)].wanted.scene.rendering.background;
  }
  /// Each view's requests are numbered: the one it is to show, and the one it shows at least coarsely.
  std::array<std::uint64_t, picture_count> wanted_versions() const;
  std::array<std::uint64_t, picture_count> shown_versions() const;

  Renderer& renderer() { return renderer_; }
  /// The volume is not to be shown any more: what is held for it goes, and the pictures once the frame that
  /// is being drawn does not name them.
  void close();
  /// Draws everything again (after the shaders changed).
  void invalidate();

 private:
  /// How good a picture is. A preview is of an exact scene, by samples.
  enum Stage { coarse, preview, full, stage_count };
  /// A picture that is being drawn, row by row.
  struct Pass {
    ViewRequest request;
    std::uint64_t version = 0;
    Stage stage = full;
    Scene scene;  ///< of the request, as this stage draws it
    int coarseness = 1;
    glm::ivec2 next{0};  ///< where the next slice begins
    std::unique_ptr<gl::RenderTarget> target;
    /// The next slice, where the device has to be asked about it first, and was.
    struct Begun {
      Tile tile;
      gl::PendingBuffer known;
    };
    std::optional<Begun> begun;
    bool waits() const { return begun && !begun->known.is_over(); }
  };
  /// Rows of a pass that the device was asked for.
  struct Slice {
    gl::QueryHandle time;
    double expected_ms = 0, pixels = 0;
    Stage stage = full;
    bool is_first = false, is_last = false;  ///< of its pass
  };
  /// What a small picture costs, and whether anything is to be seen, in it or in the one in full.
  struct Counting {
    PendingCounts counts;
    gl::PendingRead small;
    std::optional<gl::PendingRead> full;  ///< where the small one shows nothing
  };
  struct View {
    ViewRequest wanted;
    std::vector<std::string> warnings;  ///< of `wanted`, with the notes on it
    std::string nothing_visible;        ///< why, where the picture in full shows nothing
    std::string error;                  ///< why `wanted` cannot be drawn
    std::uint64_t wanted_version = 0, shown_version = 0;
    Stage shown_stage = coarse;
    int shown_coarseness = 0;  ///< 0: nothing is shown
    std::optional<Pass> pass;
    std::deque<Slice> queued;  ///< what the device may not be through with
    /// A coarse picture, which the window enlarges, and one at full resolution; which of them is shown.
    std::unique_ptr<gl::DisplayTexture> small, display;
    bool shows_small = false;
    /// Of other sizes: the frame that is being drawn may name them.
    std::vector<std::unique_ptr<gl::DisplayTexture>> last;
    const gl::DisplayTexture* shown() const { return shows_small ? small.get() : display.get(); }
    std::array<double, stage_count> ms_per_pixel{1e-3, 1e-3, 1e-3};  ///< guesses; measured from then on
    double frame_ms = 0, pass_ms = 0;  ///< of the last picture in full; of what is known of a pass
    PictureNeed need;
    RenderCounts counts;
    bool is_counted = false;
    std::optional<Counting> counting;  ///< while the device counts
    /// The picture in full, until it is known whether it shows anything, or as long as colours are kept.
    std::unique_ptr<gl::RenderTarget> full;
  };

  static bool is_done(const View& view);
  static bool is_same_but_for_bound(ViewRequest a, const ViewRequest& b);
  static void forget_costs(View& view);
  static void let_go(View& view);
  void take_times();
  double queued_ms() const;
  View* next_view();
  Stage next_stage(const View& view) const;
  void begin_pass(View& view, bool interactive);
  Scene scene_of(const ViewRequest& request, Stage stage, int coarseness);
  void draw_slice(View& view, double slice_ms, bool interactive);
  gl::DisplayTexture& make_display(View& view, std::unique_ptr<gl::DisplayTexture>& display, glm::ivec2 size);
  void show_slice(View& view, const Tile& slice);
  void show_rows(const Pass& pass, gl::DisplayTexture& display, int first_row, int last_row);
  void finish_pass(View& view);
  void begin_counting(View& view);
  void take_counts();
  void take_counts(View& view);
  void end_counting(View& view);
  void give_up(View& view, std::string why);  ///< what cannot be drawn is not tried again until it changes

  Renderer renderer_;
  gl::Presenter presenter_;
  std::array<View, picture_count> views_;
  std::size_t last_view_ = 0;
  bool keeps_colors_ = false, is_closed_ = false;
};

}  // namespace crest
