// ImageJ's files over 4 GB: the directory of the first image alone, and all images behind each other. How
// long its strip is says the file in 32 bits, so that it is not asked (ij.io.TiffDecoder, FileInfo.nImages).
#include <fmt/core.h>

#include <fstream>

#include "presets/error.h"
#include "render/readers/open_file.h"
#include "render/readers/tiff_file.h"
#include "render/volume/convert.h"

namespace crest {
namespace {

class ImageJStack : public PageFile {
 public:
  ImageJStack(const std::filesystem::path& path, std::unique_ptr<PageFile> first, const TiffStack& stack)
      : path_(path), first_(std::move(first)), stack_(stack), file_(open_file(path)) {}

  std::size_t pages() override { return stack_.images; }
  PageFormat format(std::size_t) override { return first_->format(0); }
  void read(std::size_t page, std::span<std::byte> out) override {
    file_.seekg(std::streamoff(stack_.begin + page * out.size()));
    if (!file_.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size())))
      throw Error(page_fault(path_, page, "its data ends early"));
    if (stack_.endian != std::endian::native) swap_bytes(out, size_of(first_->format(0).type));
  }

 private:
  std::filesystem::path path_;
  std::unique_ptr<PageFile> first_;
  TiffStack stack_;
  std::ifstream file_;
};

}  // namespace

std::unique_ptr<PageFile> open_imagej_stack(const std::filesystem::path& path,
                                            std::unique_ptr<PageFile> first, const TiffStack& stack) {
  const std::uint64_t size = std::filesystem::file_size(path), image = first->format(0).bytes();
  const std::uint64_t held = size > stack.begin ? (size - stack.begin) / image : 0;
  if (held < 2) return first;  // a description that is left of another file
  if (held < stack.images)
    throw Error(fmt::format("{}: its ImageJ description tells of {} images, and the file has {}",
                            path.string(), stack.images, held));
  return std::make_unique<ImageJStack>(path, std::move(first), stack);
}

}  // namespace crest
