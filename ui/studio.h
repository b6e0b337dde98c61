#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "presets/exchange/importers.h"
#include "presets/peaks.h"
#include "render/files/open_choice.h"
#include "render/files/raw_layout.h"
#include "render/reference/visibility.h"
#include "render/scene/picture_need.h"
#include "render/slices/slice.h"
#include "render/volume/by_value.h"
#include "render/volume/match_values.h"
#include "render/volume/suggested_peaks.h"
#include "render/volume/volume.h"
#include "ui/accuracy_results.h"
#include "ui/choice_results.h"
#include "ui/comparison.h"
#include "ui/document.h"
#include "ui/library_entry.h"
#include "ui/ray_inspection.h"
#include "ui/view_content.h"

namespace crest {

/// The views' pictures, and behind them the one that a view is compared with.
inline constexpr int picture_count = view_count + 1, compared_picture = view_count;

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

/// The volume that was there before this one, whose TF can be carried over.
struct CarryOver {
  std::string from;           ///< its name
  bool knows_values = false;  ///< of both volumes, as carrying by histogram needs them
  bool same_grid = false;     ///< as carrying by places needs it
};
/// Of a document that an earlier run of the program left with unsaved changes.
struct RecoveryOffer {
  std::string name;    ///< of the preset
  std::string volume;  ///< its source; empty where none was open
  double age = 0;      ///< seconds since it was kept
  int more = 0;        ///< that many others are there
};
enum class RecoveryAnswer { restore, discard, later };

/// The time steps of the volume, which are counted from 0.
struct ShownSteps {
  int count = 0;
  int shown = 0, wanted = 0;  ///< the same, unless one is being read
  int known_ranges = 0;       ///< of so many the range is known
  bool is_playing = false;
};

/// The middle slice of a file of raw voxels, as a form says that they lie.
struct RawPicture {
  std::uintptr_t texture = 0;  ///< an ImTextureID, row 0 at the top; 0 while there is none
  glm::ivec2 size{0};
  ValueRange range{0, 0};  ///< of its values: from black to white
  std::string error;       ///< why there is none
};

/// What must be chosen before a volume can be opened.
struct Opening {
  OpenChoice choice;
  std::uint64_t file_bytes = 0;  ///< of raw voxels: the file's length
  RawPicture picture;            ///< of the last preview_raw
};

/// One across each axis.
inline constexpr int slice_count = 3;

/// The slices that are to be seen.
struct SlicesWanted {
  glm::dvec3 cursor{0.5};  ///< in which they meet: in the box, each axis from 0 to 1
  std::array<glm::ivec2, slice_count> pixels{};
};

/// What the program tells the panels: results, read only.
struct StudioInputs {
  const Volume* volume = nullptr;  ///< null while none is open
  TransferFunction resolved;       ///< the document's TF in the volume's units
  std::span<const Peak> peaks;     ///< of `resolved`
  std::span<const Peak> surfaces;  ///< those that are shown as surfaces
  std::array<ViewPicture, picture_count> views;
  const RayInspection* ray = nullptr;  ///< as it was asked for; null while nothing of it is there
  std::optional<PickedPixel> picked;   ///< under the mouse, when it rests
  DifferencePicture difference;        ///< of the two pictures that are compared, where that was asked for
  const ByValue* by_value = nullptr;   ///< of the volume; null while it is not measured
  std::span<const SuggestedPeak> suggested;          ///< by it, the most persistent first
  const Visibility* visibility = nullptr;            ///< null while it was never measured
  bool visibility_is_old = false;                    ///< of a scene or a view that is no longer there
  std::string why_no_values, why_no_visibility;      ///< where there can be none
  std::optional<CarryOver> carry_over;               ///< while there was another volume
  std::array<std::uintptr_t, slice_count> slices{};  ///< as ViewPicture::texture, across x, y, z
  const AccuracyResults* accuracy = nullptr;         ///< null while nothing was ever measured
  const ChoiceResults* choice = nullptr;             ///< null while nothing was ever chosen
  std::string loading;                               ///< the volume that is being read; empty while none is
  std::optional<double> loading_share;  ///< of that one, in [0, 1]; nothing while it is not known
  std::string version;                  ///< of the program
  std::string message;                  ///< the last news or error, one line
  bool message_is_error = false;
  std::vector<std::string> recent;  ///< volumes and presets opened last, newest first
  /// An ImTextureID each, of 4:3, or 0: of `recent`, and of examples(). Both may be shorter, or empty.
  std::vector<std::uintptr_t> recent_pictures, example_pictures;
  std::span<const LibraryEntry> library;  ///< as it was last read
  std::string saving;                     ///< how far a picture is that is being saved; empty while none is
  std::string performance;                ///< e.g. frame times, for the status bar
  ExportPicture export_picture;           ///< of the last preview_export
  /// What is in a file of another program, while nothing of it is chosen; and what was asked for when it was
  /// opened.
  std::span<const Imported> imported;
  TfParts import_take = TfParts::both;
  const Opening* opening = nullptr;  ///< null while there is nothing to choose
  std::optional<ShownSteps> steps;   ///< where there are several
  std::optional<RecoveryOffer> recovery;
  bool unsaved_changes = false;   ///< of the preset, the camera aside: worth a question before they are lost
  const Preset* saved = nullptr;  ///< the preset as its file has it; null where it has none
  std::optional<std::string> dropped_preset;  ///< on the window, since the last frame
  bool close_requested = false;               ///< the window's close button was pressed since the last frame
};

/// Of the person's own folder of presets.
enum class LibraryChange { add, rename, duplicate, remove };
struct LibraryRequest {
  LibraryChange change;
  std::filesystem::path preset;  ///< a file, or to be duplicated a name; of `add` the document's
  std::string title;             ///< the new one
};

/// Control points, first and last.
using LitPoints = std::optional<std::pair<std::size_t, std::size_t>>;

/// What a picture may be of, other than of one view.
inline constexpr int picture_of_grid = -1, picture_of_editor = -2;

/// A picture to be saved: of one view, of all that the grid shows, or of the transfer-function editor.
struct PictureAsk {
  int view = picture_of_grid;
  glm::ivec2 size{0};
  int turntable = 1;  ///< pictures of one turn
  std::filesystem::path path;
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
  bool cancel_opening = false;           ///< nothing is chosen; open_volume says what is
  std::optional<RawLayout> preview_raw;  ///< of the file that is to be opened, as long as it is to be seen
  bool close_volume = false;
  std::optional<int> go_to_step;   ///< of the time steps
  std::optional<bool> play_steps;  ///< begins to play them, or ends it
  bool shows_start_page = false;   ///< in place of the views
  bool shows_library = false;      ///< its presets' pictures are wanted
  bool reads_library = false;      ///< the folder may have changed
  std::optional<LibraryRequest> library;
  bool new_preset = false;
  /// To be done first; when it fails, the program neither quits nor opens anything else.
  std::optional<std::filesystem::path> save_preset;
  std::array<glm::ivec2, view_count>
      view_pixels{};  ///< size to draw each view at; (0, 0) = it is not visible
  ShownPicture shown_picture = ShownPicture::exact;  ///< of views that have no choice of their own
  std::array<ViewContent, view_count> contents;      ///< of the views
  std::optional<Comparison> comparison;              ///< of a view that is visible
  std::optional<RayAsk> inspect;                     ///< as long as the ray is to be seen
  std::optional<RayAsk> hovered;                     ///< the pixel under the mouse
  std::optional<std::filesystem::path> save_ray;     ///< the inspected ray, as a table
  std::optional<PictureAsk> save_picture;
  bool close_message = false;  ///< the error was read
  std::string problem;         ///< with what the person asked for, which the panels found themselves
  bool animates = false;       ///< something in the window changes by itself, at blink_s
  /// Control points, first and last, whose surface is lit while the mouse rests on it in the list.
  LitPoints lit_points;
  bool document_changed = false;       ///< by this frame: an edit, undo or redo
  std::optional<SlicesWanted> slices;  ///< as long as they are to be seen
  std::optional<CarryBy> carry;        ///< the TF that was there with the last volume, to this one
  bool show_visibility = false;        ///< as long as it is to be seen
  std::optional<bool> measure;         ///< switches the measurement in the background on or off
  std::optional<TargetError> choose;   ///< a setting that keeps this error
  bool stop_choosing = false;
  std::optional<RecoveryAnswer> recovery;  ///< of the one that is offered; `later` of all
  std::optional<std::string> open_manual;  ///< a page of it, without ".md"; empty: where it begins
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
