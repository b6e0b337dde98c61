#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "presets/exchange/importers.h"
#include "presets/peaks.h"
#include "render/scene/picture_need.h"
#include "render/volume/volume.h"
#include "ui/accuracy_results.h"
#include "ui/choice_results.h"
#include "ui/document.h"
#include "ui/library_entry.h"

namespace crest {

inline constexpr int view_count = 4;
/// The modes of the 2x2 grid, left to right, top to bottom.
inline constexpr std::array<Mode, view_count> view_modes{Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr,
                                                         Mode::both};

/// A view's picture, as the program last drew it.
struct ViewPicture {
  std::uintptr_t texture = 0;  ///< an ImTextureID, row 0 at the top; 0 while there is none
  int coarseness = 1;          ///< 1 at full resolution, 4 when every fourth pixel was cast
  double progress = 1;         ///< share of the picture as it is wanted that is done
  bool is_exact = false;       ///< it is, or becomes, the exact march's
  /// Of an exact picture that is done: the share of the pixels that are surely within 1/255 (light apart).
  std::optional<double> share_within;
  double frame_ms = 0;  ///< of the last full-resolution picture; 0 while there is none
  double samples_per_ray = 0, dvr_samples_per_ray = 0;  ///< 0 while not counted
  PictureNeed need;                                     ///< at full resolution; empty until it is begun
  std::vector<std::string> warnings;  ///< what it may be off by, and why it shows nothing, in sentences
};

/// An export: a format of exporters(), and the rows of a table (0 = the fewest).
struct ExportChoice {
  int format = 0, rows = 0;
  bool operator==(const ExportChoice&) const = default;
};

/// The preset as it is drawn here, as the target of an export draws it, and their difference, in one picture.
struct ExportPicture {
  std::uintptr_t texture = 0;  ///< 0 while there is none
  glm::ivec2 size{0};
  double rmse = 0, max = 0, share = 0;  ///< as PixelErrors
};

/// Of a document that an earlier run of the program left with unsaved changes.
struct RecoveryOffer {
  std::string name;    ///< of the preset
  std::string volume;  ///< its source; empty where none was open
  double age = 0;      ///< seconds since it was kept
  int more = 0;        ///< that many others are there
};
enum class RecoveryAnswer { restore, discard, later };

/// What the program tells the panels: results, read only.
struct StudioInputs {
  const Volume* volume = nullptr;  ///< null while none is open
  TransferFunction resolved;       ///< the document's TF in the volume's units
  std::span<const Peak> peaks;     ///< of `resolved`
  std::span<const Peak> surfaces;  ///< those that are shown as surfaces
  std::array<ViewPicture, view_count> views;
  const AccuracyResults* accuracy = nullptr;  ///< null while nothing was ever measured
  const ChoiceResults* choice = nullptr;      ///< null while nothing was ever chosen
  std::string loading;                        ///< the volume that is being read; empty while none is
  std::string message;                        ///< the last news or error, one line
  bool message_is_error = false;
  std::vector<std::string> recent;  ///< volumes and presets opened last, newest first
  /// An ImTextureID each, of 4:3, or 0: of `recent`, and of examples(). Both may be shorter, or empty.
  std::vector<std::uintptr_t> recent_pictures, example_pictures;
  std::span<const LibraryEntry> library;  ///< as it was last read
  std::string performance;                ///< e.g. frame times, for the status bar
  ExportPicture export_picture;           ///< of the last preview_export
  /// What is in a file of another program, while nothing of it is chosen; and what was asked for when it was
  /// opened.
  std::span<const Imported> imported;
  TfParts import_take = TfParts::both;
  std::optional<RecoveryOffer> recovery;
  bool unsaved_changes = false;   ///< of the preset, the camera aside: worth a question before they are lost
  const Preset* saved = nullptr;  ///< the preset as its file has it; null where it has none
  std::optional<std::string> dropped_preset;  ///< on the window, since the last frame
  bool close_requested = false;               ///< the window's close button was pressed since the last frame
};

/// What the views show when nobody does anything: the picture as the settings have it; or the exact one,
/// where there is one for the settings, or how far each of its pixels may be off, at most.
enum class ShownPicture { as_set, exact, error_bound };

/// Of the person's own folder of presets.
enum class LibraryChange { add, rename, duplicate, remove };
struct LibraryRequest {
  LibraryChange change;
  std::filesystem::path preset;  ///< a file, or to be duplicated a name; of `add` the document's
  std::string title;             ///< the new one
};

/// What the person asked for in this frame, other than changes of the document.
struct StudioRequests {
  std::optional<std::string> open_volume;
  std::optional<std::string> open_preset;  ///< a file, or a name from the library
  TfParts take = TfParts::both;            ///< of its TF
  struct Import {
    int index;  ///< in StudioInputs::imported; -1: none
    TfParts take;
    bool fit;  ///< over the range of the preset's points
  };
  std::optional<Import> import_choice;
  std::optional<ExportChoice> preview_export;  ///< as long as it is to be seen
  struct Export {
    ExportChoice what;
    std::filesystem::path path;
  };
  std::optional<Export> export_preset;
  bool cancel_loading = false;
  bool close_volume = false;
  bool shows_start_page = false;  ///< in place of the views
  bool shows_library = false;     ///< its presets' pictures are wanted
  bool reads_library = false;     ///< the folder may have changed
  std::optional<LibraryRequest> library;
  bool new_preset = false;
  /// To be done first; when it fails, the program neither quits nor opens anything else.
  std::optional<std::filesystem::path> save_preset;
  std::array<glm::ivec2, view_count>
      view_pixels{};  ///< size to draw each view at; (0, 0) = it is not visible
  ShownPicture shown_picture = ShownPicture::exact;
  bool document_changed = false;      ///< by this frame: an edit, undo or redo
  std::optional<bool> measure;        ///< switches the measurement in the background on or off
  std::optional<TargetError> choose;  ///< a setting that keeps this error
  bool stop_choosing = false;
  std::optional<RecoveryAnswer> recovery;  ///< of the one that is offered; `later` of all
  bool quit = false;                       ///< the person was asked about unsaved changes
  bool reload_shaders = false;
};

struct StudioState;  ///< selection, zoom, open dialogs, undo history: what is not in the document

struct StudioStateDeleter {
  void operator()(StudioState*) const;
};
using StudioStatePtr = std::unique_ptr<StudioState, StudioStateDeleter>;
StudioStatePtr make_studio_state();

/// Draws the whole window with Dear ImGui, between NewFrame and Render. Changes `document` as the person
/// edits it, and keeps the undo history of it.
StudioRequests studio_frame(Document& document, StudioState& state, const StudioInputs& inputs);

}  // namespace crest
