#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/measure/image_error.h"
#include "render/measure/methods.h"
#include "ui/editor_state.h"
#include "ui/file_dialog.h"
#include "ui/history.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace crest {

struct ViewsState {
  int enlarged = -1;  ///< the view that fills the grid; -1 = all four
  bool outline = true;
  bool exact = true;           ///< at rest, views go on to the exact picture
  bool error_bound = false;    ///< or to how far it may be off
  std::optional<Mode> listed;  ///< whose features are listed; without one, those of the preset's mode
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
  bool once_saved = false;  ///< the answer was to save: it goes on when that is asked for
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

struct ImportDialog {
  int chosen = -1;  ///< none yet
  TfParts take = TfParts::both;
  bool fit = false;  ///< over the range of the preset's points
};

struct StudioState {
  WidgetState widgets;
  History history;
  EditorState editor;
  ViewsState views;
  AccuracyState accuracy;
  LayoutState layout;
  FileDialog file_dialog;
  ExportDialog export_dialog;
  ImportDialog import_dialog;
  PresetDetails details;
  LibraryState library;
  bool show_help = false;
  bool quit_asked = false;   ///< the person wants to leave
  Leaving leaving;           ///< what the question about unsaved changes is about
  std::size_t shown_step{};  ///< of the history, to which its list was last scrolled
  double camera_moved = -1;  ///< when the wheel last moved the camera, in Dear ImGui's seconds
  std::string under_cursor;  ///< what the status bar tells of the place under the mouse
};

}  // namespace crest
