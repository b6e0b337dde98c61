#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace crest {

/// A preset that the library offers: one that comes with the program, or of the person's own folder.
struct LibraryEntry {
  std::string name;            ///< as open_preset takes it: of the program's, or the file's path
  std::filesystem::path path;  ///< of the person's own; empty where it comes with the program
  std::string title, notes;    ///< the title is never empty
  std::vector<std::string> tags;
  std::uintptr_t picture = 0;  ///< of the open volume, as a thumbnail; 0 while there is none
  bool is_own() const { return !path.empty(); }
};

/// Whether each word of `search` is in the title, the notes or the tags; upper and lower case are the same.
bool matches(const LibraryEntry& entry, const std::string& search);

}  // namespace crest
