#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "app/export_files.h"
#include "app/preset_source.h"
#include "app/studio.h"
#include "app/user_folders.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/exporters.h"
#include "presets/preset_file.h"
#include "render/files/file_request.h"
#include "render/scene/export_input.h"
#include "ui/edit_points.h"
#include "ui/studio_state.h"

// What the studio does with files: volumes, presets, what an earlier run left.

namespace crest {
namespace {

bool is_preset_file(const std::string& source) {
  return std::ranges::find(preset_extensions(), extension_of(source)) != preset_extensions().end();
}

/// Whether it is a picture that was made with a preset; other pictures are volumes.
bool holds_preset(const std::string& source) {
  try {
    return is_picture_file(source) && !preset_in_picture(source).empty();
  } catch (const std::exception&) {
    return false;
  }
}

/// What is in a file of another program; nothing where it is none.
std::vector<Imported> presets_of_another_program(const std::string& path) {
  constexpr std::size_t most = std::size_t(64) << 20;
  const std::string content = read_file(path, most);
  if (!find_importer(content, path) || is_own_preset(content)) return {};
  return import_presets(content, path);
}

/// What the document's file, or the library, has now.
std::optional<Preset> read_again(const Document& document) {
  try {
    const std::string file = document.preset_path.string();
    if (!file.empty() || !document.library_name.empty())
      return load_preset(file.empty() ? document.library_name : file);
  } catch (const std::exception&) {
    // it is gone
  }
  return std::nullopt;
}

Preset without_camera(Preset preset) {
  preset.camera.reset();
  return preset;
}

}  // namespace

void Studio::start_loading(const std::string& source) {
  loading_for_document_ = false;
  stop_asking();
  say("");
  loader_.start(source);
}

void Studio::cancel_loading() {
  if (!is_loading()) return;
  say(fmt::format("{} is not read", loader_.source()));
  loader_.cancel();
  document_.volume_source = loaded_.source;
}

void Studio::carry_over(CarryBy by) {
  if (!last_volume_ || !loaded_.volume) return;
  place_match_.cancel();
  if (by == CarryBy::places) {
    say(fmt::format("Comparing {} with {} ...", last_volume_->name, loaded_.volume->name));
    before_match_ = document_.preset.transfer_function;
    return place_match_.start(last_volume_->source, loaded_.volume);
  }
  TransferFunction& tf = document_.preset.transfer_function;
  tf = last_volume_->carried_to(loaded_.volume->statistics.range, matters_.values(), by, tf.domain);
  ui_->editor.visible.reset();
  say(fmt::format("Carried over from {}", last_volume_->name));
}

void Studio::take_place_match() {
  const auto outcome = place_match_.take();
  if (!outcome || !last_volume_ || !loaded_.volume) return;
  if (!outcome->fit) return say(outcome->error, true);
  TransferFunction& tf = document_.preset.transfer_function;
  if (tf != before_match_)
    return say(fmt::format("Not carried over from {}: the transfer function was changed meanwhile",
                           last_volume_->name));
  tf = in_domain(carried(last_volume_->tf, *outcome->fit), tf.domain, loaded_.volume->statistics.range);
  ui_->editor.visible.reset();
  say(fmt::format("Carried over from {}, whose values tell {:.3g} % of the variance here", last_volume_->name,
                  100 * outcome->fit->explained));
}

/// Its TF may be carried over to the next one; what was made of it goes.
void Studio::leave_volume() {
  place_match_.cancel();
  if (!loading_for_document_ && loaded_.volume)
    last_volume_ =
        last_volume(*loaded_.volume, shown_source(), document_.preset.transfer_function, matters_.values());
  rays_.forget();
  slices_.forget();
  ui_->ray = {};
  picked_.reset();
}

void Studio::show(Loaded fresh) {
  keep_thumbnails();
  leave_volume();
  Preset preset = document_.preset;
  if (fit_) preset = fit_(std::move(preset), *fresh.volume, view_aspect_);
  views_.renderer().hold(fresh.volume);  // the driver must hold it, too
  const bool was_saved = !has_unsaved_changes();
  document_.preset = std::move(preset);
  if (was_saved) mark_saved();
  fit_ = nullptr;
  loaded_ = std::move(fresh);
  matters_.set_volume(loaded_.volume);
  steps_.open(loaded_.source, loaded_.volume);
  if (!loading_for_document_) document_.volume_source = loaded_.source;
  recent_.add(loaded_.source);
  const Volume& volume = *loaded_.volume;
  const glm::ivec3 dims = volume.grid.dims;
  say(fmt::format("{}: {}x{}x{} {}{}{}{}", volume.name, dims.x, dims.y, dims.z, name_of(volume.file_type),
                  volume.note.empty() ? "" : ", ", volume.note,
                  last_volume_ ? "; Preset, Carry over fits the curve to it" : ""));
}

void Studio::take_loaded_volume() {
  auto result = loader_.take();
  if (!result) return;
  try {
    if (result->volume) return show({result->source, std::move(result->volume)});
  } catch (const std::exception& error) {
    result->error = error.what();
  }
  // What was there stays
  if (document_.volume_source == result->source) document_.volume_source = loaded_.source;
  if (result->choice)
    ask_what_to_open(*result->choice);
  else
    say(result->error, true);
}

void Studio::close_volume() {
  keep_thumbnails();
  loader_.cancel();
  leave_volume();
  loaded_ = {};
  steps_.open("", nullptr);
  matters_.set_volume(nullptr);
  sweep_.leave();
  choice_.stop();
  document_.volume_source.clear();
  views_.close();
  say("");
}

void Studio::open_preset(const std::string& name_or_path, TfParts take) {
  try {
    const bool is_file = std::filesystem::exists(name_or_path);
    const bool is_picture = is_picture_file(name_or_path);
    imported_.clear();
    if (is_file && !is_picture) imported_ = presets_of_another_program(name_or_path);
    if (!imported_.empty()) {
      imported_from_ = name_or_path;
      import_take_ = take;
      return;
    }
    Preset preset = load_preset_from(name_or_path);
    keep_thumbnails();
    fit_ = nullptr;  // was for the preset of the command line
    if (TransferFunction& tf = document_.preset.transfer_function; take != TfParts::both) {
      tf = combined(tf, preset.transfer_function, take, false);
      say(fmt::format("Took {} from {}", take == TfParts::colors ? "the colours" : "the opacities",
                      name_or_path));
      return;
    }
    document_.preset = std::move(preset);
    document_.preset_path = is_file && !is_picture ? name_or_path : "";
    document_.library_name = is_file ? "" : name_or_path;
    mark_saved();
    if (is_file && !is_picture) recent_.add(name_or_path);
    say(fmt::format("Opened {}", name_or_path));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::take_import(const StudioRequests::Import& choice) {
  const std::vector<Imported> all = std::exchange(imported_, {});
  if (choice.index < 0 || choice.index >= int(all.size())) return;
  const Imported& one = all[std::size_t(choice.index)];
  TransferFunction read = one.preset.transfer_function;
  if (loaded_.volume) {
    const Grid& grid = loaded_.volume->grid;
    read = for_volume(one, glm::dvec3(grid.dims) * grid.spacing);
  }
  // How the preset is rendered, and from where, stays; but for a light that the file asks for
  Preset& preset = document_.preset;
  preset.transfer_function = combined(preset.transfer_function, read, choice.take, choice.fit);
  if (choice.take == TfParts::both) {
    preset.name = one.preset.name;
    if (one.preset.rendering.shading != Shading::none)
      preset.rendering.shading = one.preset.rendering.shading;
    document_.preset_path.clear();
    document_.library_name.clear();
    fit_ = nullptr;
  }
  say(fmt::format("Imported {} from {}", one.preset.name, imported_from_));
}

void Studio::export_to(const StudioRequests::Export& request) {
  try {
    const Exporter& exporter = exporters()[std::size_t(request.what.format)];
    const ExportInput input = export_input(document_.preset, loaded_.volume.get(), request.what.rows,
                                           stem_of(request.path, exporter.extension));
    const Exported exported = exporter.write(input);
    write_export(exported, input.stem, request.path);
    std::string more;
    for (std::size_t i = 1; i < exported.files.size(); ++i)
      more += fmt::format("{}{}", i == 1 ? " and *" : ", *", exported.files[i].suffix);
    say(fmt::format("Exported {}{}", request.path.string(), more));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::mark_saved() {
  std::erase_if(saved_, [&](const Saved& one) { return is_same_preset_file(one.document, document_); });
  saved_.push_back({document_, document_.preset});
}

const Preset* Studio::saved_preset() const {
  for (const Saved& one : saved_)
    if (is_same_preset_file(one.document, document_)) return &one.preset;
  return nullptr;
}

bool Studio::has_unsaved_changes() const {
  const Preset* saved = saved_preset();
  return !saved || without_camera(document_.preset) != without_camera(*saved);
}

bool Studio::save_preset_to(const std::filesystem::path& path) {
  try {
    save_preset(path, document_.preset);
    document_.preset_path = path;
    document_.library_name.clear();
    mark_saved();
    recent_.add(path.string());
    keep_thumbnails();
    say(fmt::format("Saved {}", path.string()));
    return true;
  } catch (const std::exception& error) {
    say(error.what(), true);
    return false;
  }
}

void Studio::take_changed_preset() {
  const std::string file = document_.preset_path.string();
  try {
    Preset fresh = load_preset_from(file);
    const Preset* saved = saved_preset();
    if (!saved || fresh == *saved) return;  // it was written from here
    if (has_unsaved_changes())
      return say(fmt::format("{} has changed outside; what is not saved here stays", file), true);
    // The view stays where it is, unless the file has another one than before
    if (fresh.camera == saved->camera) fresh.camera = document_.preset.camera;
    keep_thumbnails();
    document_.preset = std::move(fresh);
    mark_saved();
    say(fmt::format("{} has changed, and is read again", file));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::open(const std::string& source) {
  if (is_preset_file(source) || holds_preset(source))
    dropped_preset_ = source;
  else
    start_loading(source);
}

void Studio::find_recoveries() {
  for (RecoveryFile& file : RecoveryFile::left_behind(recovery_folder())) try {
      KeptDocument kept = file.read();
      recoveries_.push_back({std::move(file), std::move(kept)});
    } catch (const std::exception&) {
      // damaged, or of another version: it stays for that
    }
}

std::optional<RecoveryOffer> Studio::recovery_offer() const {
  if (recoveries_.empty()) return std::nullopt;
  const KeptDocument& kept = recoveries_.front().kept;
  const auto age = std::chrono::system_clock::now() - kept.time;
  return RecoveryOffer{preset_label(kept.document), kept.document.volume_source,
                       std::chrono::duration<double>(age).count(), int(recoveries_.size()) - 1};
}

void Studio::take_recovery(RecoveryAnswer answer) {
  if (recoveries_.empty()) return;
  if (answer == RecoveryAnswer::later) return recoveries_.clear();
  Recovery one = std::move(recoveries_.front());
  recoveries_.erase(recoveries_.begin());
  if (answer == RecoveryAnswer::discard) return one.file.remove();
  // What is unsaved now is offered at the next start
  if (has_unsaved_changes()) autosave_.leave_behind(document_);
  document_ = std::move(one.kept.document);
  fit_ = nullptr;  // was for the preset of the command line
  if (auto saved = read_again(document_)) {
    const Preset kept = std::exchange(document_.preset, std::move(*saved));
    mark_saved();
    document_.preset = kept;
  }
  say(fmt::format("Restored {}", preset_label(document_)));
  autosave_.adopt(std::move(one.file), document_);
}

void Studio::keep_unsaved_changes() {
  const std::string error = autosave_.update(document_, has_unsaved_changes(), Autosave::Clock::now());
  if (!error.empty()) say(error, true);
}

}  // namespace crest
