#include "render/reference/cache.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "presets/atomic_file.h"
#include "presets/names.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// To be raised whenever the same content gives another picture, or the files another layout.
constexpr int algorithm_version = 3;
constexpr const char* extension = ".reference";

std::uint64_t hash_of(const void* bytes, std::size_t size) { return XXH64(bytes, size, 0); }

/// All that the picture depends on, as text: numbers in full, the field as its hash.
std::string key_of(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                   double tolerance) {
  const Grid& grid = scene.volume->grid;
  const std::vector<float>& values = scene.volume->values;
  Preset preset;
  preset.transfer_function = scene.tf;
  preset.rendering.clip_box = scene.rendering.clip_box;
  preset.camera = camera;
  const AnswerFilters filters = filters_of(answer, scene.rendering);
  const auto text_of = [](const FieldFilter& f) {
    return fmt::format("{} {} {}", name_of(f.kind), f.b, f.c);
  };
  return fmt::format(
      "crest reference, algorithm {}\n{}x{} pixels, {}, tolerance {}\ngrid {} {} {}, spacing {} {} {}, "
      "origin "
      "{} {} {}, values {:016x}\nfilter {}, of roots {}\n{}",
      algorithm_version, size.x, size.y, name_of(answer), tolerance, grid.dims.x, grid.dims.y, grid.dims.z,
      grid.spacing.x, grid.spacing.y, grid.spacing.z, grid.origin.x, grid.origin.y, grid.origin.z,
      hash_of(values.data(), values.size() * sizeof(float)), text_of(filters.dvr), text_of(filters.root),
      write_preset(preset));
}

fs::path file_of(const fs::path& folder, const std::string& key) {
  return folder / fmt::format("{:016x}{}", hash_of(key.data(), key.size()), extension);
}

/// Calls visit(span) for each of the arrays.
template <class SomeReference, class Visit>
void visit_arrays(SomeReference& reference, const Visit& visit) {
  visit(std::span(reference.pixels));
  visit(std::span(reference.crossings));
  visit(std::span(reference.grazing));
}

/// The key, the arrays as this machine has numbers in memory, and a hash of all before it.
std::string file_content(const std::string& key, const Reference& reference) {
  std::string content = key;
  visit_arrays(reference, [&](auto values) {
    content.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  });
  const std::uint64_t hash = hash_of(content.data(), content.size());
  content.append(reinterpret_cast<const char*>(&hash), sizeof hash);
  return content;
}

/// Nothing where the content is not whole, or of another key.
std::optional<Reference> parse_content(const std::string& content, const std::string& key, glm::ivec2 size) {
  const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
  Reference reference{.size = size,
                      .pixels = std::vector<glm::dvec4>(count),
                      .crossings = std::vector<std::uint32_t>(count),
                      .grazing = std::vector<std::uint8_t>(count)};
  std::size_t end = key.size();
  visit_arrays(reference, [&](auto values) { end += values.size_bytes(); });
  std::uint64_t hash = 0;
  if (content.size() != end + sizeof hash || !content.starts_with(key)) return std::nullopt;
  std::memcpy(&hash, content.data() + end, sizeof hash);
  if (hash != hash_of(content.data(), end)) return std::nullopt;
  const char* from = content.data() + key.size();
  visit_arrays(reference, [&](auto values) {
    std::memcpy(values.data(), from, values.size_bytes());
    from += values.size_bytes();
  });
  return reference;
}

std::optional<Reference> read_cached(const fs::path& file, const std::string& key, glm::ivec2 size) {
  std::error_code fault;
  const std::uintmax_t bytes = fs::file_size(file, fault);
  if (fault) return std::nullopt;
  try {
    auto reference = parse_content(read_file(file, bytes), key, size);
    if (reference) fs::last_write_time(file, fs::file_time_type::clock::now(), fault);  // it was used
    return reference;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// Takes away the files that were used longest ago, until `room` bytes are free below the limit.
void make_room(const fs::path& folder, std::uintmax_t limit_bytes, std::uintmax_t room) {
  struct File {
    fs::file_time_type used;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t total = room;
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != extension || !entry.is_regular_file(fault)) continue;
    files.push_back({entry.last_write_time(fault), entry.file_size(fault), entry.path()});
    if (fault)
      files.pop_back();  // another program took it away
    else
      total += files.back().bytes;
  }
  std::ranges::sort(files, {}, &File::used);
  for (const File& file : files) {
    if (total <= limit_bytes) return;
    fs::remove(file.path, fault);
    total -= file.bytes;
  }
}

void write_cached(const fs::path& file, std::uintmax_t limit_bytes, const std::string& content) {
  if (content.size() > limit_bytes) return;
  try {
    fs::create_directories(file.parent_path());
    make_room(file.parent_path(), limit_bytes, content.size());
    write_file_atomically(file, content);
  } catch (const std::exception&) {
    // It is rendered again next time.
  }
}

}  // namespace

CachedReference render_reference_cached(const fs::path& folder, std::uintmax_t limit_bytes,
                                        const Scene& scene, const Camera& camera, glm::ivec2 size,
                                        Answer answer, double tolerance, const Progress& progress) {
  if (folder.empty()) return {render_reference(scene, camera, size, answer, tolerance, progress), false};
  const std::string key = key_of(scene, camera, size, answer, tolerance);
  const fs::path file = file_of(folder, key);
  if (auto cached = read_cached(file, key, size)) return {std::move(*cached), true};
  CachedReference rendered{render_reference(scene, camera, size, answer, tolerance, progress), false};
  write_cached(file, limit_bytes, file_content(key, rendered.reference));
  return rendered;
}

}  // namespace crest
