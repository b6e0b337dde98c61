#include "ui/file_dialog.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "render/files/kinds.h"
#include "render/files/natural_order.h"
#include "ui/import_dialog.h"
#include "ui/style.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 20000;

struct Wording {
  const char* title;
  const char* button;
  std::span<const std::string_view> extensions;  ///< none: all files
};
constexpr std::string_view own_extension[] = {".json"};
constexpr std::string_view table_extension[] = {".csv"};
constexpr std::string_view picture_extensions[] = {".png", ".exr"};
const Wording wordings[] = {{"Open a volume", "Open", {}},
                            {"Open a preset", "Open", preset_extensions()},
                            {"A preset for a view", "Show", own_extension},
                            {"Save the preset", "Save", own_extension},
                            {"Export to a file", "Export", {}},
                            {"Save the ray as a table", "Save", table_extension},
                            {"Save the picture", "Save", picture_extensions}};

const Wording& wording(FilePurpose purpose) { return wordings[int(purpose)]; }

bool writes(FilePurpose purpose) { return purpose >= FilePurpose::save_preset; }

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string size_text(std::uintmax_t bytes) {
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double size = double(bytes);
  const char* unit = "B";
  for (const char* next : {"kB", "MB", "GB", "TB"}) {
    if (size < 1000) break;
    size /= 1000;
    unit = next;
  }
  return fmt::format("{:.3g} {}", size, unit);
}

/// Lists the folder; what cannot be read is told in `error` and leaves the dialog where it was.
void enter(FileDialog& dialog, const fs::path& folder) {
  std::error_code failure;
  const fs::path target = fs::weakly_canonical(folder, failure);
  fs::directory_iterator files(failure ? folder : target, failure);
  if (failure) {
    dialog.error = fmt::format("{}: {}", folder.string(), failure.message());
    return;
  }
  dialog.error.clear();
  dialog.folder = target;
  dialog.entries.clear();
  for (; files != fs::directory_iterator() && dialog.entries.size() < most_entries;
       files.increment(failure)) {
    if (failure) break;
    std::error_code ignored;
    FileDialog::Entry entry{files->path().filename().string(), files->is_directory(ignored), 0};
    if (entry.name.starts_with('.')) continue;
    if (!entry.folder) {
      const std::uintmax_t bytes = files->file_size(ignored);
      entry.bytes = ignored ? 0 : bytes;
    }
    dialog.entries.push_back(std::move(entry));
  }
  std::ranges::sort(dialog.entries, [](const auto& a, const auto& b) {
    return a.folder != b.folder ? a.folder : natural_less(lower(a.name), lower(b.name));
  });
}

fs::path typed_path(const FileDialog& dialog) {
  std::string text = dialog.name;
  const char* home = std::getenv("HOME");
  if (home && (text == "~" || text.starts_with("~/"))) text.replace(0, 1, home);
  return dialog.folder / text;
}

/// What is chosen, if it can be taken; otherwise a folder is entered, or the question or error is set.
std::optional<std::string> take(FileDialog& dialog) {
  if (dialog.name.empty()) return std::nullopt;
  fs::path path = typed_path(dialog);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    dialog.name.clear();
    enter(dialog, path);
    return std::nullopt;
  }
  if (writes(dialog.purpose)) {
    if (path.extension().empty()) path += dialog.extension;
    if (!fs::is_directory(path.parent_path(), ignored)) {
      dialog.error = fmt::format("{}: there is no such folder", path.parent_path().string());
      return std::nullopt;
    }
    if (fs::exists(path, ignored)) {
      dialog.to_replace = path;
      return std::nullopt;
    }
    return path.string();
  }
  // A volume's name may carry a query: file.raw?size=..., or stand for a list: step_*.raw
  const std::string text = path.string();
  const bool may_have_more =
      dialog.purpose == FilePurpose::open_volume && text.find_first_of("?*") != std::string::npos;
  if (may_have_more || fs::exists(path, ignored)) return text;
  dialog.error = fmt::format("{}: there is no such file", text);
  return std::nullopt;
}

/// Images and DICOM files are slices, which their folder is opened for.
void find_list(FileDialog& dialog) {
  if (std::exchange(dialog.list_of, dialog.name) == dialog.name) return;
  dialog.list.reset();
  std::error_code ignored;
  const fs::path path = typed_path(dialog);
  if (dialog.name.empty() || !fs::is_regular_file(path, ignored) || is_image(path) || is_dicom(path)) return;
  dialog.list = numbered_list_of(path);
}

/// Returns the pattern of the list that the chosen file is one of, when all are to be opened.
std::optional<std::string> list_button(FileDialog& dialog, WidgetState& widgets) {
  find_list(dialog);
  if (!dialog.list) return std::nullopt;
  const bool pressed =
      ImGui::Button(fmt::format("Open all {} as time steps###all steps", dialog.list->count).c_str());
  note_item(widgets, "open all steps");
  tip(dialog.list->pattern.filename().string().c_str());
  ImGui::SameLine();
  return pressed ? std::optional(dialog.list->pattern.string()) : std::nullopt;
}

bool passes(const FileDialog& dialog, const FileDialog::Entry& entry) {
  const auto& extensions = wording(dialog.purpose).extensions;
  const bool is_kind = entry.folder || extensions.size() == 0 || std::ranges::any_of(extensions, [&](auto e) {
                         return lower(entry.name).ends_with(e);
                       });
  return is_kind &&
         (dialog.filter.empty() || lower(entry.name).find(lower(dialog.filter)) != std::string::npos);
}

std::optional<std::string> list_of_files(FileDialog& dialog, WidgetState& widgets, float height) {
  std::optional<std::string> chosen;
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  if (!ImGui::BeginTable("files", 2, flags, {0, height})) return chosen;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, scaled(80));
  std::optional<fs::path> go_to;
  for (const FileDialog::Entry& entry : dialog.entries) {
    if (!passes(dialog, entry)) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = entry.folder ? entry.name + "/" : entry.name;
    if (ImGui::Selectable(label.c_str(), dialog.name == entry.name,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick |
                              ImGuiSelectableFlags_DontClosePopups)) {
      dialog.name = entry.name;
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        if (entry.folder)
          go_to = dialog.folder / entry.name;
        else
          chosen = entry.name;
      }
    }
    note_item(widgets, "file/" + entry.name);
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextDisabled("%s", size_text(entry.bytes).c_str());
  }
  ImGui::EndTable();
  if (go_to) {
    dialog.name.clear();
    enter(dialog, *go_to);
  }
  if (chosen) chosen = take(dialog);
  return chosen;
}

/// The question before a file is overwritten.
std::optional<std::string> replace_question(FileDialog& dialog, WidgetState& widgets) {
  std::optional<std::string> chosen;
  ImGui::TextUnformatted(
      fmt::format("{} exists. Replace it?", dialog.to_replace->filename().string()).c_str());
  ImGui::SameLine();
  if (ImGui::Button("Replace")) {
    chosen = dialog.to_replace->string();
    dialog.to_replace.reset();
  }
  note_item(widgets, "replace");
  ImGui::SameLine();
  if (ImGui::Button("Keep it")) dialog.to_replace.reset();
  note_item(widgets, "keep");
  return chosen;
}

std::optional<std::string> buttons(FileDialog& dialog, WidgetState& widgets) {
  std::optional<std::string> chosen;
  const float button = scaled(96);
  if (dialog.purpose == FilePurpose::open_volume) {
    if (ImGui::Button("Open this folder")) chosen = dialog.folder.string();
    tip("A DICOM series or a stack of images");
    ImGui::SameLine();
    if (const auto all = list_button(dialog, widgets)) chosen = all;
  }
  if (dialog.purpose == FilePurpose::open_preset) {
    parts_choice(widgets, dialog.take);
    ImGui::SameLine();
  }
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0F, ImGui::GetContentRegionAvail().x - 2 * button - spacing));
  if (default_button(wording(dialog.purpose).button, {button, 0})) chosen = take(dialog);
  note_item(widgets, "take file");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {button, 0})) ImGui::CloseCurrentPopup();
  note_item(widgets, "cancel file");
  return chosen;
}

std::optional<std::string> contents(FileDialog& dialog, WidgetState& widgets) {
  std::optional<std::string> chosen;
  if (ImGui::Button("Up")) {
    dialog.name.clear();
    enter(dialog, dialog.folder.parent_path());
  }
  note_item(widgets, "folder up");
  ImGui::SameLine();
  ImGui::TextUnformatted(dialog.folder.string().c_str());
  ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - scaled(220)));
  field_label("Filter");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##filter", &dialog.filter);
  const float rows_below = dialog.error.empty() ? 2 : 3;
  chosen = list_of_files(dialog, widgets, -ImGui::GetFrameHeightWithSpacing() * rows_below);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputTextWithHint("##file name", "name or path", &dialog.name,
                               ImGuiInputTextFlags_EnterReturnsTrue))
    chosen = take(dialog);
  note_item(widgets, "file name");
  if (!dialog.error.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette().error), "%s", dialog.error.c_str());
  const auto decided = dialog.to_replace ? replace_question(dialog, widgets) : buttons(dialog, widgets);
  return decided ? decided : chosen;
}

}  // namespace

void open_file_dialog(FileDialog& dialog, FilePurpose purpose, const fs::path& near) {
  std::error_code ignored;
  const fs::path beside = near.empty() ? fs::path() : fs::absolute(near, ignored).parent_path();
  const bool known = !beside.empty() && fs::is_directory(beside, ignored);
  const fs::path folder = known ? beside : dialog.folder.empty() ? fs::current_path(ignored) : dialog.folder;
  dialog = FileDialog{};
  dialog.purpose = purpose;
  dialog.asked = dialog.open = true;
  if (purpose == FilePurpose::save_preset) dialog.name = near.filename().string();
  dialog.extension = purpose == FilePurpose::save_ray       ? ".csv"
                     : purpose == FilePurpose::save_picture ? ".png"
                                                            : ".json";
  enter(dialog, folder);
}

std::optional<std::string> file_dialog(FileDialog& dialog, WidgetState& widgets) {
  const char* title = wording(dialog.purpose).title;
  if (dialog.asked) ImGui::OpenPopup(title);
  dialog.asked = false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(760), display.x * 0.9F), std::min(scaled(520), display.y * 0.9F)},
                           ImGuiCond_Appearing);
  dialog.open = true;
  if (!ImGui::BeginPopupModal(title, &dialog.open, ImGuiWindowFlags_NoSavedSettings)) {
    dialog.open = false;
    return std::nullopt;
  }
  std::optional<std::string> chosen = contents(dialog, widgets);
  if (escape_pressed(widgets)) ImGui::CloseCurrentPopup();
  if (chosen) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return chosen;
}

}  // namespace crest
