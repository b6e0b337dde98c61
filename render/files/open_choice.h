#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "presets/error.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {

/// What a source leaves open, and the query can say.
/// `part`: of a grid that is too large.
enum class ChoiceKind { raw_layout, component, frame, array, series, part };
/// "component": the key in the query; empty for raw voxels and parts, which take several (raw_layout.h,
/// grid_part.h).
std::string_view key_of(ChoiceKind kind);

struct ChoiceOption {
  std::string value;  ///< in the query
  std::string text;   ///< for people: "red", "T1 axial (MR), 124 images"
  bool operator==(const ChoiceOption&) const = default;
};

/// A choice that must be made before a volume can be read. A plain value, also between processes.
struct OpenChoice {
  ChoiceKind kind = ChoiceKind::raw_layout;
  std::string path;         ///< of the file or folder
  Query query;              ///< what is said so far; of raw voxels also by a sidecar or the file's name
  std::uint64_t count = 0;  ///< of components, frames, arrays or series; else 0
  /// As many as `count`; or none, where they have no names but their numbers from 0.
  std::vector<ChoiceOption> options;
  std::optional<MemoryNeed> need = {};  ///< of what is too large
  std::uint64_t memory = 0;             ///< bytes that it may take
  bool operator==(const OpenChoice&) const = default;
};

/// The error that says which choice there is. Its text tells the query that makes it.
struct ChoiceNeeded : Error {
  ChoiceNeeded(const std::string& text, OpenChoice what) : Error(text), choice(std::move(what)) {}
  OpenChoice choice;
};

/// What to say, and to ask, where a source is too large: the text ends with the smallest stride that fits.
ChoiceNeeded part_needed(const TooLarge& fault, const std::string& path, const Query& query);

/// "PATH?key=value&...", as load_volume takes it; without a query the path alone.
std::string source_of(const std::string& path, const Query& query);
/// The source with the i-th of the choice's options, in [0, count).
std::string chosen_source(const OpenChoice& choice, std::uint64_t i);

}  // namespace crest
