#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "presets/atomic_file.h"
#include "tests/paths.h"

namespace crest {

/// A folder of the program's shaders in which one piece of text, that must be there, is another.
class ChangedShaders {
 public:
  ChangedShaders(const std::string& file, const std::string& text, const std::string& other) {
    std::filesystem::copy(test::source_folder() / "render/shaders", folder_);
    std::string all = read_file(folder_ / file, 1 << 20);
    const std::size_t at = all.find(text);
    if (at == all.npos) throw std::runtime_error(file + " has no \"" + text + "\"");
    std::ofstream(folder_ / file) << all.replace(at, text.size(), other);
  }
  ~ChangedShaders() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ChangedShaders(const ChangedShaders&) = delete;
  ChangedShaders& operator=(const ChangedShaders&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  static std::filesystem::path new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "crest-shaders-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    return name;
  }
  std::filesystem::path folder_ = new_folder();
};

}  // namespace crest
