#include "render/reference/cache.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/files/folder_cache.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// To be raised whenever the same content gives another picture, or the files another layout.
constexpr int algorithm_version = 3;
constexpr const char* extension = ".reference";

std::uint64_t hash_of(const void* bytes, std::size_t size) { return XXH64(bytes, size, 0); }

/// Of the values, however they are stored.
std::uint64_t hash_of(const Voxels& values) {
  constexpr std::size_t block = std::size_t(1) << 16;
  const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(),
                                                                         XXH64_freeState);
  XXH64_reset(state.get(), 0);
  std::vector<float> room;
  for (std::size_t first = 0; first < values.size(); first += block) {
    const auto bytes = std::as_bytes(values.part(first, std::min(block, values.size() - first), room));
    XXH64_update(state.get(), bytes.data(), bytes.size());
  }
  return XXH64_digest(state.get());
}

/// All that the picture depends on, as text: numbers in full, the field as its hash.
std::string key_of(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                   double tolerance) {
  const Grid& grid = scene.volume->grid;
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
      hash_of(scene.volume->values), text_of(filters.dvr), text_of(filters.root), write_preset(preset));
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

/// The key, and the arrays as this machine has numbers in memory.
std::string file_content(const std::string& key, const Reference& reference) {
  std::string content = key;
  visit_arrays(reference, [&](auto values) {
    content.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  });
  return content;
}

/// Its length, to the byte.
std::uintmax_t content_size(const std::string& key, glm::ivec2 size) {
  constexpr std::size_t pixel = sizeof(glm::dvec4) + sizeof(std::uint32_t) + sizeof(std::uint8_t);
  return key.size() + std::uintmax_t(size.x) * std::uintmax_t(size.y) * pixel;
}

/// Nothing where the content is of another key.
std::optional<Reference> parse_content(const std::string& content, const std::string& key, glm::ivec2 size) {
  const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
  Reference reference{.size = size,
                      .pixels = std::vector<glm::dvec4>(count),
                      .crossings = std::vector<std::uint32_t>(count),
                      .grazing = std::vector<std::uint8_t>(count)};
  std::size_t end = key.size();
  visit_arrays(reference, [&](auto values) { end += values.size_bytes(); });
  if (content.size() != end || !content.starts_with(key)) return std::nullopt;
  const char* from = content.data() + key.size();
  visit_arrays(reference, [&](auto values) {
    std::memcpy(values.data(), from, values.size_bytes());
    from += values.size_bytes();
  });
  return reference;
}

}  // namespace

CachedReference render_reference_cached(const fs::path& folder, std::uintmax_t limit_bytes,
                                        const Scene& scene, const Camera& camera, glm::ivec2 size,
                                        Answer answer, double tolerance, const Progress& progress) {
  if (folder.empty()) return {render_reference(scene, camera, size, answer, tolerance, progress), false};
  const std::string key = key_of(scene, camera, size, answer, tolerance);
  const fs::path file = file_of(folder, key);
  if (const auto content = read_cached(file, content_size(key, size)))
    if (auto cached = parse_content(*content, key, size)) return {std::move(*cached), true};
  CachedReference rendered{render_reference(scene, camera, size, answer, tolerance, progress), false};
  write_cached(file, file_content(key, rendered.reference), limit_bytes);
  return rendered;
}

}  // namespace crest
