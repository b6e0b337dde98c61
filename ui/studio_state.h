#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/measure/image_error.h"
#include "render/measure/methods.h"
#include "ui/actions.h"
#include "ui/editor_state.h"
#include "ui/file_dialog.h"
#include "ui/history.h"
#include "ui/navigation.h"
#include "ui/settings.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace crest {

/// A view, or what it is compared with.
struct ViewPart {
  int view = 0;
  bool is_compared = false;
};

struct ViewsState {
  int enlarged = -1;       ///< the view that fills the grid; -1 = `count` of them
  int count = view_count;  ///< of the views in the grid
  std::array<ViewContent, view_count> contents = contents_of_modes();
  std::vector<std::shared_ptr<const OtherPreset>> snapshots;  ///< the newest at the back
  int snapshots_taken = 0;
  std::optional<Comparison> comparison;
  std::optional<glm::vec2>
      cursor;                  ///< the mouse in any view: from its middle and top, in shares of its height
  bool moves_divider = false;  ///< the mouse does
  ViewPart preset_for;         ///< what the file dialog for a view's preset was opened for
  bool asks_for_file = false;  ///< that dialog is to be opened
  bool asks_for_own = false;   ///< the presets of the person's own folder are to be read again
  std::string error;           ///< why a preset could not be shown beside the document's
  bool outline = true;
  bool exact = true;           ///< at rest, views go on to the exact picture
  bool error_bound = false;    ///< or to how far it may be off
  std::optional<Mode> listed;  ///< whose features are listed; without one, those of the preset's mode
};

/// What the views show that have no choice of their own.
ShownPicture shown_by_all(const ViewsState& views);

/// A pixel that was clicked, and may be once more.
struct ClickedPixel {
  RayAsk ask;
  Mode mode;
  double time;  ///< Dear ImGui's
};

struct RayState {
  std::optional<RayAsk> ask;  ///< the ray that is inspected
  Mode mode = Mode::peak_xor_dvr;
  Picked picked;      ///< where the menu of a view was opened
  RayAsk under_menu;  ///< there
  std::optional<ClickedPixel> clicked;
  std::optional<ValueRange> visible;  ///< depths; without it, all of the ray
};

struct AccuracyState {
  std::optional<ExactAnswer>
      answer;  ///< against which errors are shown; without one, that of the preset's mode
  TargetError target = default_target();
  std::string_view hovered_method;  ///< in the list, in the last frame: a Method::id
  struct Present {
    Rendering rendering;
    const Method* method = nullptr;  ///< null where none of methods() renders so
  };
  std::optional<Present> present;  ///< the document's, when it was last looked up
};

/// Shares of the window: the rest goes to the views, and to the panels below the editor.
struct LayoutState {
  float side_share = 0.35F;    ///< of the width, for the panels
  float editor_share = 0.50F;  ///< of the side's height, for the transfer-function editor
};

/// What is chosen in the window for exports.
struct ExportDialog {
  bool asked = false;  ///< to be opened in the next frame
  int format = 0;      ///< in exporters()
  bool automatic_rows = true;
  int rows = 256;
  bool preview = false;
  ExportChoice to_write;  ///< when the file was asked for
  struct Shown {          ///< what the sentences are about
    int format = -1, rows = 0;
    const Volume* volume = nullptr;
    std::string volume_source;
    std::filesystem::path preset_path;
    Preset preset;
  };
  Shown shown;
  std::vector<std::string> losses, advice;
  std::string error;  ///< why it cannot be written
};

/// What would lose the unsaved changes: it waits for an answer, or for the name to save them under.
struct Leaving {
  bool quit = false, new_preset = false;
  std::optional<std::string> open_preset;
  std::optional<std::string> open_volume;  ///< to be opened with it
  bool once_saved = false;                 ///< the answer was to save: it goes on when that is asked for
  bool is_any() const { return quit || new_preset || open_preset; }
};

/// The window for the preset's name, notes and tags.
struct PresetDetails {
  bool asked = false;  ///< to be opened in the next frame
  std::string tags;    ///< as they are typed
};

/// The window for the library.
struct LibraryState {
  bool asked = false;                  ///< to be opened in the next frame
  std::string search, tag, chosen;     ///< the last a LibraryEntry::name
  bool open_chosen = false;            ///< it was double-clicked
  std::optional<std::string> renamed;  ///< the name that is being typed
};

/// What is chosen for a picture that is saved.
struct PictureDialog {
  bool asked = false;  ///< to be opened in the next frame
  glm::ivec2 as_shown{0},
      editor_as_shown{0};  ///< sizes of a view and of the editor's plot, in the last frame
  PictureAsk ask;
};

/// What differs between two presets, in sentences, and which two these are about.
struct ChangeList {
  Preset saved, now;
  std::vector<std::string> sentences;  ///< empty while nothing was compared
};

struct ImportDialog {
  int chosen = -1;  ///< none yet
  TfParts take = TfParts::both;
  bool fit = false;  ///< over the range of the preset's points
};

/// One line of the palette.
struct PaletteRow {
  std::string title;  ///< "Open builtin:gyroid"
  std::string name;   ///< the same without what changes, by which it is remembered
  Action action;
  std::string why_not;  ///< it cannot be chosen
};

/// The command palette.
struct PaletteState {
  bool asked = false;  ///< to be opened in the next frame
  std::string typed{};
  int selected = 0;                   ///< of the rows that fit
  bool comes_in_sight = false;        ///< the selected row does
  std::vector<PaletteRow> rows{};     ///< that fit what is typed, since it was typed
  std::vector<std::string> chosen{};  ///< names of rows, the newest first
};

/// Of the panels below the editor.
inline constexpr const char* tab_names[] = {"Peaks",  "Points", "Rendering", "Accuracy",
                                            "Slices", "Ray",    "History"};

/// What is chosen of a file's components, frames or series, or typed about its raw voxels.
struct OpeningState {
  std::optional<OpenChoice> about;  ///< what the rest is for
  int chosen = 0;
  bool scroll = false;  ///< to the chosen one
  RawLayout layout;
  std::vector<RawGuess> guesses;
  // Of what is too large
  bool takes_box = false;  ///< else every stride-th point
  int stride = 2;
  glm::ivec3 box_first{0}, box_end{0};  ///< points of the whole: [first, end)
};

struct StudioState {
  WidgetState widgets;
  History history;
  EditorState editor;
  ViewsState views;
  RayState ray;
  AccuracyState accuracy;
  LayoutState layout;
  FileDialog file_dialog;
  ExportDialog export_dialog;
  ImportDialog import_dialog;
  ChangeList changes;
  OpeningState opening;
  PictureDialog picture_dialog;
  glm::dvec3 slice_cursor{0.5};  ///< SlicesWanted::cursor
  PresetDetails details;
  LibraryState library;
  StudioSettings settings;  ///< the program keeps them
  bool settings_asked = false;
  PaletteState palette;
  NavigationState navigation;
  bool show_help = false, show_about = false;
  std::string_view asked_tab;     ///< of tab_names: it comes up in the next frame
  bool quit_asked = false;        ///< the person wants to leave
  bool quits_when_saved = false;  ///< and a picture is still being saved
  Leaving leaving;                ///< what the question about unsaved changes is about
  std::size_t shown_step{};       ///< of the history, to which its list was last scrolled
  double camera_moved = -1;       ///< when the wheel or a key last moved the camera, in Dear ImGui's seconds
  std::string under_cursor;       ///< what is told at the mouse
};

}  // namespace crest
