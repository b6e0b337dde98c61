#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "presets/atomic_file.h"
#include "tests/paths.h"

namespace crest {

/// A folder of the program's shaders in which some pieces of text, that must be there, are others.
class ChangedShaders {
 public:
  struct Change {
    std::string file, text, other;
  };
  explicit ChangedShaders(const std::vector<Change>& changes) {
    std::filesystem::copy(test::source_folder() / "render/shaders", folder_);
    for (const Change& change : changes) make(change);
  }
  ChangedShaders(const std::string& file, const std::string& text, const std::string& other)
      : ChangedShaders(std::vector<Change>{{file, text, other}}) {}
  ~ChangedShaders() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ChangedShaders(const ChangedShaders&) = delete;
  ChangedShaders& operator=(const ChangedShaders&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  void make(const Change& change) {
    std::string all = read_file(folder_ / change.file, 1 << 20);
    const std::size_t at = all.find(change.text);
    if (at == all.npos) throw std::runtime_error(change.file + " has no \"" + change.text + "\"");
    std::ofstream(folder_ / change.file) << all.replace(at, change.text.size(), change.other);
  }
  static std::filesystem::path new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "crest-shaders-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    return name;
  }
  std::filesystem::path folder_ = new_folder();
};

}  // namespace crest
