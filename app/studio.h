#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/autosave.h"
#include "app/background_choice.h"
#include "app/background_sweep.h"
#include "app/background_writer.h"
#include "app/export_picture.h"
#include "app/last_volume.h"
#include "app/picture_maker.h"
#include "app/place_match.h"
#include "app/preset_folder.h"
#include "app/raw_preview.h"
#include "app/ray_inspector.h"
#include "app/recent_files.h"
#include "app/slice_pictures.h"
#include "app/studio_settings.h"
#include "app/thumbnail_maker.h"
#include "app/thumbnail_store.h"
#include "app/time_steps.h"
#include "app/view_difference.h"
#include "app/view_renderer.h"
#include "app/volume_loader.h"
#include "app/what_matters.h"
#include "ui/studio.h"

namespace crest {

/// The document that a person works on, with what was made of it: the volume, the views. It owns no window; a
/// GL 4.5 context must be current throughout.
class Studio {
 public:
  /// Makes of a preset what the command line said for a volume, in views of this aspect (width by height).
  using FitPreset = std::function<Preset(Preset preset, const Volume& volume, double aspect)>;
  /// What document.volume_source names is read once there is a frame. `fit` is called for the first volume.
  Studio(Document document, FitPreset fit, std::filesystem::path shader_folder);

  /// One frame: draws the panels (between Dear ImGui's NewFrame and Render), does what the person asked for,
  /// and works on the views for about `render_ms`.
  void frame(bool close_requested, double render_ms, bool interactive);

  /// Keeps unsaved changes, so that they outlive a crash. To be called again and again, also at rest.
  void keep_unsaved_changes();

  /// Takes over what the document's file has now; where there are unsaved changes it only says so.
  void take_changed_preset();

  /// What was dropped on the window: a preset, of Crest's own or of another program, or a volume.
  void open(const std::string& source);

  bool wants_to_quit() const { return quit_; }
  bool is_loading() const { return loader_.is_loading(); }     ///< a volume is being read
  bool is_stepping() const { return steps_.is_waited_for(); }  ///< a time step will come up
  /// Whether a thread reads on, although nobody waits for it: VolumeLoader::has_thread.
  bool leaves_thread() const {
    return loader_.has_thread() || place_match_.has_thread() || steps_.has_thread();
  }
  bool is_drawing() const {
    return views_.is_busy() || rays_.is_busy() || awaits_numbers();
  }  ///< a view, the inspected ray, or a number about them, is not done
  /// Drawing is done but for what the device still counts.
  bool awaits_counts() const {
    return (views_.only_counts() || (!views_.is_busy() && awaits_numbers())) && !rays_.is_busy();
  }
  bool animates() const { return animates_; }  ///< the window changes by itself, each blink_s
  /// Something of the work in the background may come up soon, has come up.
  bool is_measuring() const {
    return sweep_.is_active() || choice_.is_running() || matters_.is_active() || thumbnail_maker_.is_busy() ||
           picture_maker_.is_busy() || raw_preview_.is_busy() || place_match_.is_busy() ||
           steps_.is_active() || !left_pictures_.empty();
  }
  bool has_news() const {
    const auto now = BackgroundSweep::Clock::now();
    return sweep_.has_news(now) || choice_.has_news() || matters_.has_news(now) ||
           thumbnail_maker_.has_news() || picture_maker_.has_news() || raw_preview_.has_news() ||
           place_match_.has_news() || steps_.has_news(now) || has_left_picture() ||
           settings_writer_.has_error();
  }
  std::string title() const;
  const Document& document() const { return document_; }
  const StudioState& ui_state() const { return *ui_; }
  /// What a person chose in earlier runs; what is chosen from now on is kept.
  void use_settings(const ReadSettings& read);
  /// Waits for what is being written; destruction does so, too.
  void finish_writing();
  const StudioSettings& settings() const;
  const ViewRenderer& views() const { return views_; }
  void set_performance_text(std::string text) { performance_ = std::move(text); }

 private:
  struct Loaded {
    std::string source;
    std::shared_ptr<const Volume> volume;
  };

  /// What was on view when it was left, on its way to a thumbnail.
  struct LeftPicture {
    std::vector<std::string> keys;
    gl::PendingRead picture;
  };

  void start_loading(const std::string& source);
  void cancel_loading();
  void take_loaded_volume();
  void show(Loaded fresh);
  void take_time_step();
  void show_step(std::shared_ptr<const Volume> volume);
  void update_time_steps(const StudioRequests& requests);
  std::optional<ShownSteps> shown_steps() const;
  std::string shown_source() const;
  void ask_what_to_open(const OpenChoice& choice);
  void stop_asking();
  void take_raw_preview();
  void update_opening(const StudioRequests& requests);
  void open_preset(const std::string& name_or_path, TfParts take);
  void take_import(const StudioRequests::Import& choice);
  void export_to(const StudioRequests::Export& request);
  void update_export_picture(const StudioRequests& requests);
  /// Returns whether it could.
  bool save_preset_to(const std::filesystem::path& path);
  void handle(const StudioRequests& requests);
  void find_recoveries();
  std::optional<RecoveryOffer> recovery_offer() const;
  void take_recovery(RecoveryAnswer answer);
  void leave_volume();
  void close_volume();
  void add_start_pictures(StudioInputs& inputs);
  void keep_thumbnails();
  void take_left_picture(const LeftPicture& left, bool shows);
  void take_left_pictures();
  bool has_left_picture() const;
  void read_library();
  void follow_rename(const std::filesystem::path& from, const std::filesystem::path& to,
                     const std::string& title);
  void change_library(const LibraryRequest& request);
  std::vector<ThumbnailJob> library_jobs();
  void take_thumbnails();
  void want_thumbnails(const StudioRequests& requests);
  void say(std::string text, bool is_error = false);
  void keep_settings();
  void tell_view_error();
  /// The preset is what its file has, or what it was opened as.
  void mark_saved();
  const Preset* saved_preset() const;  ///< null where it stands nowhere
  bool has_unsaved_changes() const;
  StudioInputs inputs(bool close_requested);
  void update_sweep(const StudioRequests& requests, bool interactive);
  SweepSubject choice_subject(glm::ivec2 size) const;
  void take_choice();
  void update_choice(const StudioRequests& requests);
  Scene scene_of(const ViewContent& content, const Scene& own) const;
  ViewRequest view_request(const ViewContent& content, const Scene& own, ShownPicture shown_by_all_views,
                           glm::ivec2 size) const;
  void save_picture(const PictureAsk& ask);
  void save_editor_picture(const PictureAsk& ask);
  void take_saved_picture();
  std::array<ViewRequest, picture_count> view_requests(const StudioRequests& requests) const;
  void update_rays(const StudioRequests& requests, bool interactive);
  void save_ray_to(const std::filesystem::path& path);
  bool awaits_numbers() const { return difference_.is_busy() || export_picture_.is_busy(); }
  void update_difference(const StudioRequests& requests, bool interactive);
  void carry_over(CarryBy by);
  void take_place_match();
  void update_slices(const StudioRequests& requests);
  void update_matters(const StudioRequests& requests, bool interactive);
  glm::ivec2 own_view(const StudioRequests& requests) const;

  Document document_;
  struct Saved {
    Document document;  ///< which file it is
    Preset preset;      ///< what stands in it
  };
  std::vector<Saved> saved_;  ///< each file that the document was in, since undo leads back
  Loaded loaded_;
  VolumeLoader loader_;
  TimeSteps steps_;                    ///< of loaded_
  bool loading_for_document_ = false;  ///< which names it already: at the start, and after an undo
  FitPreset fit_;                      ///< empty once it was called
  double view_aspect_ = 1;
  StudioStatePtr ui_ = make_studio_state();
  ViewRenderer views_;
  ViewDifference difference_;
  RayInspector rays_;
  PictureMaker picture_maker_;
  std::optional<Opening> opening_;  ///< while a person is asked
  RawPreview raw_preview_;
  std::optional<PickedPixel> picked_;
  bool animates_ = false;
  BackgroundSweep sweep_;
  BackgroundChoice choice_;
  WhatMatters matters_;
  std::optional<LastVolume> last_volume_;
  PlaceMatch place_match_;
  TransferFunction before_match_;  ///< the preset's, when it began
  SlicePictures slices_;
  std::vector<Imported> imported_;  ///< from imported_from_, while the person chooses
  std::string imported_from_;
  TfParts import_take_ = TfParts::both;  ///< as the file was opened
  ExportPictureMaker export_picture_;
  RecentFiles recent_;
  ThumbnailStore thumbnails_;
  ThumbnailMaker thumbnail_maker_;
  std::vector<LeftPicture> left_pictures_;
  PresetFolder own_presets_;
  std::vector<LibraryEntry> library_;
  std::vector<std::string> library_texts_;  ///< of the presets in it, which their pictures are found by
  struct Recovery {
    RecoveryFile file;
    KeptDocument kept;
  };
  std::vector<Recovery> recoveries_;  ///< of earlier runs, the newest first; offered one after the other
  Autosave autosave_;
  std::optional<std::string> dropped_preset_;
  std::string message_, performance_;
  std::string view_error_, shader_error_;  ///< as last told
  StudioSettings kept_settings_;           ///< as they stand in their file
  BackgroundWriter settings_writer_;
  bool message_is_error_ = false, quit_ = false;
};

}  // namespace crest
