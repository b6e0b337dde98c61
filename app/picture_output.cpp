#include "app/picture_output.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "presets/atomic_file.h"
#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;
namespace {

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
  std::string ending = options.is_to_stdout() ? ".png" : output.extension().string();
  if (!options.format.empty()) ending = "." + options.format;
  if (!options.is_to_stdout() && output.extension() == ending)
    return write_image(output, image, background, preset);
  const std::string content = encode_image("picture" + ending, image, background, preset);
  if (options.is_to_stdout())
    print_whole(content);
  else
    write_file_atomically(output, content);
}

}  // namespace crest
