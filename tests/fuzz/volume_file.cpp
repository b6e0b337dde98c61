#include "tests/fuzz/volume_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "presets/error.h"
#include "presets/printable.h"
#include "render/files/geometry.h"
#include "render/files/open_choice.h"
#include "render/files/reader_answer.h"
#include "tests/fuzz/target.h"

namespace crest::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where there is such a folder: a fuzzer writes thousands of files a second. Gone with the
/// process.
class Scratch {
 public:
  Scratch() {
    std::error_code fault;
    const fs::path memory = "/dev/shm";
    const bool is_told = std::getenv("TMPDIR") != nullptr;  // by run.sh, which removes it in any case
    const fs::path parent = !is_told && fs::is_directory(memory, fault) ? memory : fs::temp_directory_path();
    folder_ = parent / fmt::format("crest-fuzz-{}", getpid());
    fs::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

Json as_sent(const Json& json) {
  return parse_json(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void require_told(Volume volume) {
  repair_geometry(volume);
  volume.note = printable(volume.note);
  Volume told = volume_from_json(as_sent(volume_to_json(volume)));
  require(told.grid == volume.grid && told.direction == volume.direction, "a grid is told as it is");
  require(told.file_type == volume.file_type && told.note == volume.note, "a note is told as it is");
  told.values = std::move(volume.values);
  require(told.values.size() == told.grid.point_count(), "there is a value for each point");
  compute_statistics(told.grid, told.values, 16);
}

void make_choice(const OpenChoice& choice, Query& query) {
  const OpenChoice told = choice_from_json(as_sent(choice_to_json(choice)));
  require(told.count > 0 && told.count == choice.count && told.options.size() == choice.options.size(),
          "a choice is told as it is");
  const bool is_new =
      query
          .emplace(key_of(choice.kind),
                   choice.options.empty() ? std::to_string(choice.count - 1) : choice.options.back().value)
          .second;
  require(is_new, "what was chosen is not asked again");
}

}  // namespace

std::string write_scratch(std::string_view name, std::string_view content) {
  static const Scratch scratch;
  const fs::path path = scratch.folder() / name;
  std::ofstream(path, std::ios::binary).write(content.data(), std::streamsize(content.size()));
  return path.string();
}

void read_volume(const std::string& path, Volume (*read)(const FileRequest&)) {
  constexpr std::uint64_t memory = 16 << 20;
  FileRequest request{
      path, {}, {.memory = memory, .asks = false, .stop = {}, .reader = {}, .patience = {}}, {}};
  while (true) {
    try {
      return require_told(read(request));
    } catch (const ChoiceNeeded& needed) {
      if (needed.choice.kind == ChoiceKind::raw_layout) throw;
      make_choice(needed.choice, request.query);
    } catch (const fs::filesystem_error& fault) {  // which the reader's program catches, too
      throw Error(fault.what());
    }
  }
}

}  // namespace crest::fuzz
