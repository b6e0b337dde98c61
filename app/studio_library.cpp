#include <fmt/core.h>

#include "app/sources.h"
#include "app/studio.h"
#include "presets/preset_file.h"

// The library: presets that come with the program, and the person's own.

namespace crest {
namespace {

/// So many pictures are asked for at once: the next ones when these are there.
constexpr std::size_t most_jobs = 4;

/// On what presets are shown while no volume is open.
constexpr const char* stand_in = "builtin:plume?n=64";

/// What tells one volume from another, for pictures: a file may change under its name.
std::string identity_of(const Volume* volume, const std::string& source) {
  if (!volume) return stand_in;
  const glm::ivec3 dims = volume->grid.dims;
  const VolumeStatistics& statistics = volume->statistics;
  return fmt::format("{} {}x{}x{} {} {} {}", absolute_source(source), dims.x, dims.y, dims.z,
                     statistics.range.min, statistics.range.max, statistics.mean);
}

std::string library_key(const std::string& volume, const std::string& preset_text) {
  return fmt::format("library\n{}\n{}", volume, preset_text);
}

}  // namespace

void Studio::read_library() {
  library_.clear();
  library_texts_.clear();
  const auto add = [&](std::string name, std::filesystem::path path, const Preset& preset) {
    const std::string file = path.empty() ? name : path.stem().string();
    library_.push_back(
        {std::move(name), std::move(path), title_of(preset, file), preset.notes, preset.tags, 0});
    library_texts_.push_back(write_preset(preset));
  };
  for (const PresetFolder::Item& item : own_presets_.items()) add(item.path.string(), item.path, item.preset);
  for (const LibraryPreset& one : library()) add(std::string(one.name), {}, parse_preset(one.text, one.name));
}

/// The document that is open goes by its new name, in its file too.
void Studio::follow_rename(const std::filesystem::path& from, const std::filesystem::path& to,
                           const std::string& title) {
  for (Saved& one : saved_)
    if (one.document.preset_path == from) {
      one.document.preset_path = to;
      one.preset.name = title;
    }
  if (document_.preset_path != from) return;
  document_.preset_path = to;
  document_.preset.name = title;
}

void Studio::change_library(const LibraryRequest& request) {
  try {
    const std::string file = request.preset.string();
    switch (request.change) {
      case LibraryChange::add:
        say(fmt::format("Kept as {}", own_presets_.add(document_.preset).string()));
        break;
      case LibraryChange::rename: {
        const std::filesystem::path renamed = own_presets_.rename(request.preset, request.title);
        follow_rename(request.preset, renamed, request.title);
        say(fmt::format("{} is {} now", file, renamed.filename().string()));
        break;
      }
      case LibraryChange::duplicate:
        say(fmt::format("Copied to {}", own_presets_.duplicate(request.preset).string()));
        break;
      case LibraryChange::remove:
        own_presets_.remove(request.preset);
        std::erase_if(saved_, [&](const Saved& one) { return one.document.preset_path == request.preset; });
        say(fmt::format("{} is in the bin", request.preset.filename().string()));
        break;
    }
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
  read_library();
}

/// Gives the entries the pictures that there are; returns the others.
std::vector<ThumbnailJob> Studio::library_jobs() {
  std::vector<ThumbnailJob> jobs;
  const std::string volume = identity_of(loaded_.volume.get(), loaded_.source);
  for (std::size_t i = 0; i < library_.size(); ++i) {
    std::string key = library_key(volume, library_texts_[i]);
    library_[i].picture = thumbnails_.texture(key);
    if (library_[i].picture == 0 && jobs.size() < most_jobs)
      jobs.push_back(
          {std::move(key), loaded_.volume, stand_in,
           [text = library_texts_[i], name = library_[i].name] { return parse_preset(text, name); }});
  }
  return jobs;
}

}  // namespace crest
