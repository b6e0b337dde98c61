#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest {

// Time steps: the frames of one file, or a numbered list of files, which a pattern names ("flow_*.vti"). In
// both cases a source with "frame=i" in its query is step i, counted from 0, and its volume says how many
// there are (Volume::frames).

/// The files that a pattern names: with a whole number where its file's name has its one "*", in natural
/// order. Empty where the name has none or several, or no file fits.
std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& pattern);

/// The pattern that most files of this one's folder fit to, this one among them: one of the numbers in its
/// name is its "*". Nothing where no other file fits to any.
struct NumberedList {
  std::filesystem::path pattern;
  std::size_t count = 0;  ///< at least 2
};
std::optional<NumberedList> numbered_list_of(const std::filesystem::path& file);

/// "NAME?query", where there is such a file or folder, or a numbered list.
struct FoundSource {
  std::filesystem::path path;
  std::string query;
  std::vector<std::filesystem::path> list;  ///< of a pattern, its files; else empty
};
/// With the longest NAME that there is, because a real file's name may hold a "?" or "*" too.
std::optional<FoundSource> find_source(const std::string& source);

/// The file of a pattern's first step, or the path itself.
std::filesystem::path first_file(const std::filesystem::path& path);

/// The source with "frame=step" in its query, in place of another one.
std::string source_of_step(const std::string& source, int step);
/// As load_volume, but where only the frame is left open, and frames have no names, the first.
Volume load_first_step(const std::string& source, const Reading& reading = {});

/// The least range that has the values of all steps, `volume` being one of them. Reads the others one after
/// another. Throws as load_volume.
ValueRange range_of_steps(const std::string& source, const Volume& volume, const Reading& reading = {});

}  // namespace crest
