#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/files/kinds.h"

#include "render/files/open_choice.h"
#include "render/readers/readers.h"
#include "render/readers/whole_images.h"
#include "render/volume/convert.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view keys = "component,spacing,origin";

/// As a person counts: slice2 before slice10, and slice02 where slice2 is. (strverscmp takes a number with
/// leading zeros for a fraction: slice02 before slice1.)
bool natural_less(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at + 1 < text.size() && text[at] == '0' && is_digit(text[at + 1])) ++at;
      const std::size_t begin = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      return text.substr(begin, at - begin);
    };
    const std::string m = number(a, i), n = number(b, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  const std::size_t rest_a = a.size() - i, rest_b = b.size() - j;
  return rest_a != rest_b ? rest_a < rest_b : a < b;
}

/// One image: a file, or a page of one.
struct Page {
  fs::path file;
  int subimage = 0;
};

/// By its extension alone: OpenImageIO would try a file that is not what it says with all that it knows.
std::unique_ptr<OIIO::ImageInput> open(const fs::path& file) {
  OIIO::ImageSpec spec, as_stored;
  as_stored["oiio:UnassociatedAlpha"] = 1;
  auto input = OIIO::ImageInput::create(extension_of(file).substr(1));
  if (input && input->open(file.string(), spec, as_stored)) return input;
  throw Error(fmt::format("{}: not an image that can be read: {}", file.string(),
                          one_line(input ? input->geterror() : OIIO::geterror())));
}

/// The type that its values are read as; half floats are read as float32.
ScalarType scalar_type(const std::string& name, OIIO::TypeDesc format) {
  using enum ScalarType;
  switch (format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return uint8;
    case OIIO::TypeDesc::INT8:
      return int8;
    case OIIO::TypeDesc::UINT16:
      return uint16;
    case OIIO::TypeDesc::INT16:
      return int16;
    case OIIO::TypeDesc::UINT32:
      return uint32;
    case OIIO::TypeDesc::INT32:
      return int32;
    case OIIO::TypeDesc::UINT64:
      return uint64;
    case OIIO::TypeDesc::INT64:
      return int64;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return float32;
    case OIIO::TypeDesc::DOUBLE:
      return float64;
    default:
      throw Error(fmt::format("{}: its pixels are of a type ({}) that is not read", name, format.c_str()));
  }
}

/// What OpenImageIO would fill up.
void require_whole(const fs::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".tif" || extension == ".tiff") require_whole_tiff(file);
  if (extension == ".jpg" || extension == ".jpeg") require_whole_jpeg(file);
}

void require_alike(const Page& page, const OIIO::ImageSpec& spec, const OIIO::ImageSpec& first) {
  if (spec.width == first.width && spec.height == first.height && spec.nchannels == first.nchannels &&
      spec.format == first.format && spec.depth <= 1) {
    return;
  }
  throw Error(
      fmt::format("{}: image {} is {}x{} with {} channels of {}, and the first is {}x{} with {} of {}",
                  page.file.string(), page.subimage + 1, spec.width, spec.height, spec.nchannels,
                  spec.format.c_str(), first.width, first.height, first.nchannels, first.format.c_str()));
}

/// By the names that the file gives its channels, where there are not too many.
std::vector<ChoiceOption> channel_options(const OIIO::ImageSpec& spec) {
  constexpr int most = 64;
  std::vector<ChoiceOption> options;
  for (int i = 0; i < spec.nchannels && spec.nchannels <= most; ++i)
    options.push_back(
        {fmt::format("{}", i), fmt::format("component {}: {}", i, one_line(spec.channel_name(i)))});
  return options;
}

std::size_t channel_of(const FileRequest& request, const OIIO::ImageSpec& spec) {
  if (spec.nchannels > 1 && !request.query.contains("component")) {
    throw ChoiceNeeded(
        fmt::format("{}: its images have {} channels, and a volume is one: take the first with ?component=0",
                    request.name(), spec.nchannels),
        {ChoiceKind::component, request.name(), request.query, std::uint64_t(spec.nchannels),
         channel_options(spec)});
  }
  return std::size_t(integer_in(request.name(), request.query, "component", 0, 0, spec.nchannels - 1));
}

glm::dvec3 vector_of(const FileRequest& request, std::string_view key, glm::dvec3 fallback) {
  const auto found = request.query.find(key);
  if (found == request.query.end()) return fallback;
  const auto vector = to_vector(found->second, ',');
  if (!vector) {
    throw Error(
        fmt::format("{}: {}={} is not three numbers like 1,1,2.5", request.name(), key, found->second));
  }
  return *vector;
}

Volume read_pages(const FileRequest& request, const std::vector<Page>& pages) {
  require_known_keys(request.name(), request.query, keys);
  auto input = open(pages.front().file);
  const OIIO::ImageSpec first = input->spec();
  const std::size_t channel = channel_of(request, first);
  const ScalarType type = scalar_type(request.name(), first.format);
  const auto channels = std::size_t(first.nchannels);
  const glm::u64vec3 dims(std::uint64_t(first.width), std::uint64_t(first.height), pages.size());
  request.require_memory(dims, channels * size_of(type) / pages.size());
  require_whole(pages.front().file);

  Volume volume;
  volume.file_type = type;
  volume.grid = {glm::ivec3(dims), vector_of(request, "spacing", glm::dvec3(1)),
                 vector_of(request, "origin", glm::dvec3(0))};
  if (channels > 1) volume.note = fmt::format("component {} of {} (counted from 0)", channel, channels);
  volume.values.resize(volume.grid.point_count());
  const std::size_t points = dims.x * dims.y;
  std::vector<std::byte> bytes(points * channels * size_of(type));
  const OIIO::TypeDesc read_as = first.format == OIIO::TypeHalf ? OIIO::TypeFloat : first.format;
  for (std::size_t k = 0; k < pages.size(); ++k) {
    const Page& page = pages[k];
    if (k > 0 && page.file != pages[k - 1].file) {
      require_whole(page.file);
      input = open(page.file);
    }
    require_alike(page, input->spec(page.subimage), first);
    if (!input->read_image(page.subimage, 0, 0, first.nchannels, read_as, bytes.data())) {
      throw Error(fmt::format("{}: image {} could not be read: {}", page.file.string(), page.subimage + 1,
                              one_line(input->geterror())));
    }
    convert_to_float(std::span(bytes).subspan(channel * size_of(type)), type, channels,
                     std::span(volume.values).subspan(k * points, points));
  }
  return volume;
}

}  // namespace

Volume read_image_pages(const FileRequest& request) {
  std::vector<Page> pages;
  const auto input = open(request.path);
  while (input->seek_subimage(int(pages.size()), 0)) pages.push_back({request.path, int(pages.size())});
  if (pages.size() < 2) {
    throw Error(
        fmt::format("{}: one image: a volume is a multi-page file, or a folder of images", request.name()));
  }
  return read_pages(request, pages);
}

Volume read_image_folder(const FileRequest& request) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(request.path)) {
    if (is_image(entry.path())) files.push_back(entry.path().string());
  }
  std::ranges::sort(files, natural_less);
  std::vector<Page> pages;
  for (const std::string& file : files) pages.push_back({file, 0});
  return read_pages(request, pages);
}

}  // namespace crest
