#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "presets/exchange/importers.h"
#include "render/files/time_steps.h"
#include "ui/widgets.h"

namespace crest {

enum class FilePurpose {
  open_volume,
  open_preset,
  view_preset,  ///< shown in a view, beside the one that is edited
  save_preset,
  export_preset,
  save_ray,
  save_picture
};

/// A modal window that lets a person choose a file.
struct FileDialog {
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  FilePurpose purpose = FilePurpose::open_volume;
  bool asked = false;  ///< to be opened in the next frame
  bool open = false;   ///< asked for, and not answered or cancelled yet
  std::filesystem::path folder;
  std::vector<Entry> entries;    ///< folders first, by name
  std::string name;              ///< what is chosen or typed: a name in the folder, or a path
  std::string filter;            ///< shown are the names that contain it
  std::string_view extension;    ///< with its dot, where a person gives none; of an export
  TfParts take = TfParts::both;  ///< of a preset that is opened
  std::string error;
  std::string list_of;                              ///< the name that `list` is about
  std::optional<NumberedList> list;                 ///< of volumes, which the chosen file is one of
  std::optional<std::filesystem::path> to_replace;  ///< the question before overwriting is open
};

/// Opens the dialog in the folder of `near`, a path or nothing; for saving with its name filled in.
void open_file_dialog(FileDialog& dialog, FilePurpose purpose, const std::filesystem::path& near);

/// Draws it while it is open. Returns the path once it is chosen.
std::optional<std::string> file_dialog(FileDialog& dialog, WidgetState& widgets);

}  // namespace crest
