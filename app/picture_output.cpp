#include "app/picture_output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "presets/atomic_file.h"
#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;
namespace {

/// A new, empty file with this ending, gone in the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& ending)
      : name_((fs::temp_directory_path() / "crest-XXXXXX").string() + ending) {
    const int descriptor = mkstemps(name_.data(), int(ending.size()));
    if (descriptor < 0) throw Error(fmt::format("{}: {}", name_, std::strerror(errno)));
    close(descriptor);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

constexpr std::size_t largest_picture = std::size_t(1)
                                        << 33;  // bytes; 16384x16384 in 32-bit float are half of it

void print_whole(const std::string& content) {
  if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size())
    throw Error(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

}  // namespace

void require_output(const PictureOptions& options) {
  if (options.is_to_stdout()) return;
  if (options.format.empty())
    require_picture_file(options.output);
  else
    require_writable(options.output);
}

void write_picture(const PictureOptions& options, const Image& image, glm::vec3 background,
                   const std::string& preset) {
  const fs::path output = options.output;
  const std::string ending = options.format.empty() ? output.extension().string() : "." + options.format;
  if (!options.is_to_stdout() && output.extension() == ending)
    return write_image(output, image, background, preset);
  // Its writer goes by the ending of a name
  const TemporaryFile file(options.is_to_stdout() && options.format.empty() ? ".png" : ending);
  write_image(file.name(), image, background, preset);
  const std::string content = read_file(file.name(), largest_picture);
  if (options.is_to_stdout())
    print_whole(content);
  else
    write_file_atomically(output, content);
}

}  // namespace crest
