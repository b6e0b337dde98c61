#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/gl/handle.h"

namespace crest::gl {

/// The variants of an engine's shaders, each compiled when it is first needed.
class ProgramCache {
 public:
  /// So many are held, those that were used last: llvmpipe takes some 6 MB for each, and there are more kinds
  /// of them than anybody counts. A dropped one is read from its file again.
  static constexpr std::size_t most_programs = 32;

  /// Shaders are read from `folder`, or, when it is empty, from the program itself. Linked programs are kept
  /// in `binary_folder` for the next start, unless it is empty (program_files.h).
  explicit ProgramCache(std::filesystem::path folder, std::filesystem::path binary_folder = {})
      : folder_(std::move(folder)), binary_folder_(std::move(binary_folder)) {}

  /// Throws Error for a program that cannot be built and has no last good one. It lives at least until
  /// most_programs others were asked for.
  GLuint program(std::string_view vertex, std::string_view fragment, const std::vector<std::string>& defines);

  /// Builds every variant again when it is next needed. Where that fails, the last good one is kept, and
  /// `error` says why.
  void reload();
  const std::string& error() const { return error_; }
  /// Lets all go, where nothing is drawn any more.
  void clear() { variants_.clear(); }

  std::size_t count() const { return variants_.size(); }
  /// How many programs were compiled, and not read from a file.
  int compiled() const { return compiled_; }

 private:
  struct Variant {
    ProgramHandle program;
    bool current = false;        ///< false after reload, until it was built again
    std::uint64_t last_use = 0;  ///< as counted by uses_
  };
  ProgramHandle read_or_build(std::string_view vertex, std::string_view fragment,
                              const std::vector<std::string>& defines);
  void drop_oldest();

  std::filesystem::path folder_, binary_folder_;
  int compiled_ = 0;
  std::uint64_t uses_ = 0;
  std::map<std::pair<std::string, std::vector<std::string>>, Variant> variants_;
  std::string error_;
  std::vector<std::future<void>> writing_;  ///< their files; the end waits for them
};

}  // namespace crest::gl
