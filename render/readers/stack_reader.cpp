#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "presets/error.h"
#include "render/files/geometry.h"
#include "render/files/header_text.h"
#include "render/files/kinds.h"
#include "render/files/natural_order.h"
#include "render/readers/page_file.h"
#include "render/readers/readers.h"
#include "render/readers/select_one.h"
#include "render/readers/subtract.h"
#include "render/readers/tiff_file.h"
#include "render/readers/voxel_header.h"
#include "render/volume/rounding.h"
#include "render/volume/voxel_store.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view keys = "component,frame,spacing,origin,subtract,crop,stride";

/// One image: a file, or a page of one.
struct Page {
  fs::path file;
  std::size_t number = 0;
};

void require_alike(const Page& page, const PageFormat& format, const Page& front, const PageFormat& first) {
  if (format.width == first.width && format.height == first.height && format.channels == first.channels &&
      format.type == first.type && format.note == first.note) {
    return;
  }
  const bool values = format.note != first.note;
  throw Error(fmt::format(
      "{}: image {} is {}x{} with {} channels of {}{}, and the first{} is {}x{} with {} of {}{}",
      page.file.string(), page.number + 1, format.width, format.height, format.channels, name_of(format.type),
      values ? fmt::format(" ({})", format.note) : "",
      page.file == front.file ? "" : fmt::format(", {},", front.file.filename().string()), first.width,
      first.height, first.channels, name_of(first.type), values ? fmt::format(" ({})", first.note) : ""));
}

/// Of several channels the one that the query says.
std::size_t channel_of(const FileRequest& request, const PageFormat& format, std::string& note) {
  return std::size_t(select_one(request, ChoiceKind::component, format.channels, note,
                                format.is_colour ? colour_names(format.channels) : Names()));
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

/// The images that become slices, of a channel of theirs, and what their file says of them.
struct Stack {
  std::vector<Page> pages;
  PageFormat format = {};  ///< each page's
  std::size_t channel = 0;
  std::optional<glm::dvec3> spacing = {};
  std::string lengths = {};  ///< a note, unless the query says the spacing
  LinearMap scaling = {};    ///< from the stored values, where they are_scaled()
  std::string note = {};
  int frames = 1, frame = 0;  ///< as the volume's
};

/// Calibrations of ImageJ's are of integers of 8 and 16 bits.
bool are_scaled(ScalarType type) { return is_integer(type) && size_of(type) <= 2; }

Volume read_stack(const FileRequest& request, const Stack& stack) {
  const PageFormat& first = stack.format;
  const glm::u64vec3 dims(first.width, first.height, stack.pages.size());
  const GridPart part = request.part_of(dims);
  request.require_memory({part, held_size_of(first.type), first.bytes()});

  Volume volume;
  volume.file_type = first.type;
  volume.note = stack.note;
  volume.frames = stack.frames;
  volume.frame = stack.frame;
  volume.grid = {glm::ivec3(dims), vector_of(request, "spacing", stack.spacing.value_or(glm::dvec3(1))),
                 vector_of(request, "origin", glm::dvec3(0))};
  add_note(volume.note, first.note);
  if (!request.query.contains("spacing")) {
    add_note(volume.note, stack.lengths);
    if (!stack.spacing)
      add_note(volume.note, "its spacing is not known, and taken as 1: ?spacing=x,y,z says it");
  }
  const LinearMap scaling = are_scaled(first.type) ? stack.scaling : LinearMap();
  if (scaling != LinearMap())
    add_note(volume.note, fmt::format("values are {} times the stored ones plus {}, by ImageJ's calibration",
                                      scaling.slope, scaling.intercept));
  const LinearMap map = subtracted(request, scaling, volume.note);
  VoxelStore store(first.type, part.point_count(), map);
  std::vector<std::byte> bytes(first.bytes());
  Rounding lost;
  std::unique_ptr<PageFile> file;
  fs::path opened;
  for (std::uint64_t k = 0; k < part.dims().z; ++k) {
    const Page& page = stack.pages[part.first.z + k * part.stride.z];
    if (page.file != opened) file = open_pages(page.file);
    opened = page.file;
    require_alike(page, file->format(page.number), stack.pages.front(), first);
    file->read(page.number, bytes);
    lost = joined(lost, put_slice(store, part, k, bytes, first.type, {first.channels, stack.channel}, map));
    tell(request.reading.progress, double(k + 1) / double(part.dims().z));
  }
  volume.values = store.take();
  add_note(volume.note, rounding_note(lost, first.type, map));
  place_part(volume, part);
  return volume;
}

/// How the pages of an image file follow each other; those of all but TIFF are slices.
PlaneOrder order_of(const std::string& name, const fs::path& file, std::size_t pages) {
  return order_planes(name, is_tiff(file) ? describe_tiff(file) : TiffDescription(), pages);
}

std::string left_out_note(std::size_t pages) {
  if (pages == 0) return "";
  return fmt::format("{} {} left out: smaller copies of others, or masks", pages,
                     pages == 1 ? "page" : "pages");
}

/// What a folder's files say, where all say the same. Throws Error where one value would mean two things.
void take_common(const std::vector<std::string>& files, const std::vector<PlaneOrder>& orders, Stack& stack) {
  const PlaneOrder& first = orders.front();
  const auto other = std::ranges::find_if(
      orders, [&](const LinearMap& scaling) { return scaling != first.scaling; }, &PlaneOrder::scaling);
  if (other != orders.end() && are_scaled(stack.format.type))
    throw Error(fmt::format(
        "{}: by ImageJ's calibration its values are {} times the stored ones plus {}, and those of {} are {} "
        "times them plus {}: the images of one volume need the same",
        files[std::size_t(other - orders.begin())], other->scaling.slope, other->scaling.intercept,
        files.front(), first.scaling.slope, first.scaling.intercept));
  stack.scaling = first.scaling;
  const bool same_lengths = std::ranges::all_of(orders, [&](const PlaneOrder& order) {
    return order.spacing == first.spacing && order.lengths == first.lengths;
  });
  if (same_lengths) stack.spacing = first.spacing;
  stack.lengths = same_lengths ? first.lengths : "its files tell of different spacings, and none is taken";
  std::vector<std::string> notes;
  std::size_t left_out = 0;
  for (const PlaneOrder& order : orders) {
    if (std::ranges::find(notes, order.note) == notes.end()) notes.push_back(order.note);
    left_out += order.left_out;
  }
  for (const std::string& note : notes) add_note(stack.note, note);
  add_note(stack.note, left_out_note(left_out));
}

/// Of an image that is there twice, as s1.png and s1.tif, each slice would be two.
void require_one_format(const std::vector<std::string>& files) {
  std::map<fs::path, std::string> seen;
  for (const std::string& file : files) {
    const auto [other, is_new] = seen.emplace(fs::path(file).replace_extension(), file);
    if (!is_new)
      throw Error(fmt::format("{}: the folder has {} too: keep the images of one format in it", file,
                              fs::path(other->second).filename().string()));
  }
}

}  // namespace

Volume read_image_pages(const FileRequest& request) {
  const std::string name = request.name();
  require_known_keys(name, request.query, keys);
  const auto file = open_pages(request.path);
  const std::size_t count = file->pages();
  if (count == 1) static_cast<void>(file->format(0));  // says it of a page with a depth
  if (count < 2)
    throw Error(fmt::format("{}: one image: a volume is a multi-page file, or a folder of images", name));
  const PlaneOrder order = order_of(name, request.path, count);
  Stack stack;
  stack.format = file->format(order.pages.front());  // pages that are left out may be of another
  std::size_t plane = 0;
  if (order.components == 1) {
    stack.channel = channel_of(request, stack.format, stack.note);
  } else {  // a plane may itself hold several channels
    const std::size_t component = std::size_t(
        select_one(request, ChoiceKind::component, order.components * stack.format.channels, stack.note));
    plane = component / stack.format.channels;
    stack.channel = component % stack.format.channels;
  }
  const auto frame = std::size_t(select_one(request, ChoiceKind::frame, order.frames, stack.note));
  for (std::size_t slice = 0; slice < order.slices; ++slice)
    stack.pages.push_back(
        {request.path, order.pages[(frame * order.components + plane) * order.slices + slice]});
  stack.frames = int(order.frames);  // of which each is a page at least
  stack.frame = int(frame);
  stack.spacing = order.spacing;
  stack.lengths = order.lengths;
  stack.scaling = order.scaling;
  add_note(stack.note, order.note);
  add_note(stack.note, left_out_note(order.left_out));
  return read_stack(request, stack);
}

Volume read_image_folder(const FileRequest& request) {
  require_known_keys(request.name(), request.query, "component,spacing,origin,subtract,crop,stride");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(request.path)) {
    if (is_image(entry.path())) files.push_back(entry.path().string());
  }
  if (files.empty()) throw Error(fmt::format("{}: a folder without images", request.name()));
  std::ranges::sort(files, natural_less);
  require_one_format(files);
  Stack stack;
  std::vector<PlaneOrder> orders;
  std::size_t several = 0;
  for (const std::string& file : files) {
    const PlaneOrder& order = orders.emplace_back(order_of(file, file, open_pages(file)->pages()));
    if (order.components * order.frames > 1)
      throw Error(fmt::format("{}: it holds channels or frames: open it alone, not its folder", file));
    several += order.pages.size() > 1;
    for (const std::size_t page : order.pages) stack.pages.push_back({file, page});
  }
  const Page& front = stack.pages.front();
  stack.format = open_pages(front.file)->format(front.number);
  take_common(files, orders, stack);
  stack.channel = channel_of(request, stack.format, stack.note);
  if (several > 0)
    add_note(stack.note,
             fmt::format("{} files with several pages are joined, in the order of their names", several));
  return read_stack(request, stack);
}

}  // namespace crest
