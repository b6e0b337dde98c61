#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace crest::test {

/// What Crest keeps in files, and how it writes them: into `folder`, which is there, another content for each
/// `version`, and the same bytes for the same one.
struct Saver {
  std::string name;
  std::function<void(const std::filesystem::path& folder, int version)> save;
};
std::vector<Saver> savers();

}  // namespace crest::test
