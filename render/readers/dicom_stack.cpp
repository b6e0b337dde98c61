#include "render/readers/dicom_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <set>

#include "presets/error.h"
#include "render/files/natural_order.h"
#include "render/readers/voxel_header.h"

namespace crest {
namespace {

using Images = std::vector<DicomImage>;

bool are_parallel(const DicomImage& a, const DicomImage& b) {
  constexpr double tolerance = 1e-3;
  if (!a.orientation || !b.orientation) return a.orientation.has_value() == b.orientation.has_value();
  return glm::distance((*a.orientation)[0], (*b.orientation)[0]) < tolerance &&
         glm::distance((*a.orientation)[1], (*b.orientation)[1]) < tolerance;
}

bool are_alike(const DicomImage& a, const DicomImage& b) {
  return a.columns == b.columns && a.rows == b.rows && a.samples == b.samples && are_parallel(a, b);
}

/// The same image twice: of one instance, and at one place.
bool is_copy(const DicomImage& a, const DicomImage& b) {
  return a.file != b.file && a.instance == b.instance && a.frame == b.frame && a.number == b.number &&
         a.position == b.position;
}

Images without_copies(Images images, std::string& note) {
  std::map<std::pair<std::string, std::size_t>, Images> seen;  // a file's frames are of one instance
  Images kept;
  for (DicomImage& image : images) {
    if (!image.instance.empty()) {
      Images& same = seen[{image.instance, image.frame}];
      if (std::ranges::any_of(same, [&](const DicomImage& other) { return is_copy(other, image); })) continue;
      same.push_back(image);
    }
    kept.push_back(std::move(image));
  }
  if (const std::size_t copies = images.size() - kept.size(); copies > 0)
    add_note(note, fmt::format("{} cop{} of other images left out", copies, copies == 1 ? "y" : "ies"));
  return kept;
}

/// "zz_loc.dcm" or "3 images".
std::string left_out_text(const Images& images) {
  if (images.size() == 1) return images[0].file.filename().string();
  return fmt::format("{} images ({} and others)", images.size(), images[0].file.filename().string());
}

/// The largest part that is of one size and orientation.
Images largest_class(const Images& images, std::string& note) {
  std::vector<Images> classes;
  for (const DicomImage& image : images) {
    const auto found = std::ranges::find_if(classes, [&](const Images& c) { return are_alike(c[0], image); });
    if (found == classes.end())
      classes.push_back({image});
    else
      found->push_back(image);
  }
  const auto largest = std::ranges::max_element(classes, {}, &Images::size);
  Images others;
  for (const Images& one : classes)
    if (&one != &*largest) others.insert(others.end(), one.begin(), one.end());
  if (!others.empty())
    add_note(note, fmt::format("left out, being of another size or orientation: {}", left_out_text(others)));
  return *largest;
}

bool has_place(const DicomImage& image) { return image.position && image.orientation; }

/// Along the images' normal, in mm; of images without a place the slice's number.
double height(const DicomImage& image) {
  if (!has_place(image)) return image.slice_number.value_or(0);
  const auto& axes = *image.orientation;
  return glm::dot(*image.position, glm::cross(axes[0], axes[1]));
}

/// Images of one place follow each other: where each place begins.
std::vector<std::size_t> places_of(const Images& sorted) {
  constexpr double same = 1e-3;  // mm
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || height(sorted[i]) - height(sorted[i - 1]) > same) begins.push_back(i);
  return begins;
}

std::string mark_of(const DicomImage& image, const std::string& name) {
  const auto found = std::ranges::find(image.marks, name, &DicomMark::name);
  return found == image.marks.end() ? std::string() : found->value;
}

struct NaturalLess {
  bool operator()(const std::string& a, const std::string& b) const { return natural_less(a, b); }
};
using Parts = std::map<std::string, Images, NaturalLess>;

/// Images by the value of marks; in each part the order is kept.
Parts parted_by(const Images& sorted, const std::vector<std::string>& marks) {
  Parts parts;
  for (const DicomImage& image : sorted) {
    std::string key;
    for (const std::string& mark : marks)
      key += fmt::format("{}{} {}", key.empty() ? "" : ", ", mark, mark_of(image, mark));
    parts[key].push_back(image);
  }
  return parts;
}

bool places_are_unique(const Parts& parts) {
  return std::ranges::all_of(
      parts, [](const auto& part) { return places_of(part.second).size() == part.second.size(); });
}

/// Images of `most` to a place, parted by the first mark, or two, that does it.
std::optional<Parts> part_by_marks(const Images& sorted, std::size_t most) {
  std::vector<std::string> names;
  for (const DicomMark& mark : sorted[0].marks)
    if (std::ranges::find(names, mark.name) == names.end()) names.push_back(mark.name);
  std::vector<std::vector<std::string>> ways;
  for (const std::string& name : names) ways.push_back({name});
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = i + 1; j < names.size(); ++j) ways.push_back({names[i], names[j]});
  for (const auto& way : ways) {
    Parts parts = parted_by(sorted, way);
    if (parts.size() == most && places_are_unique(parts)) return parts;
  }
  return std::nullopt;
}

/// By their numbers within each place, when each has as many.
void part_by_numbers(const std::string& name, Images sorted, const std::vector<std::size_t>& begins,
                     std::size_t most, DicomStack& stack) {
  if (begins.size() * most != sorted.size()) {
    throw Error(fmt::format(
        "{}: it has {} images at {} places, up to {} at one, and nothing tells which belong together", name,
        sorted.size(), begins.size(), most));
  }
  stack.frames.resize(most);
  for (const std::size_t begin : begins) {
    const auto first = sorted.begin() + std::ptrdiff_t(begin);
    std::sort(first, first + std::ptrdiff_t(most), [](const DicomImage& a, const DicomImage& b) {
      if (a.number != b.number) return a.number < b.number;
      return natural_less(a.file.string(), b.file.string());
    });
    for (std::size_t f = 0; f < most; ++f) stack.frames[f].push_back(sorted[begin + f]);
  }
  add_note(stack.note, "its places repeat, and their images are told apart by their numbers alone");
}

void take_parts(const Parts& parts, DicomStack& stack) {
  for (const auto& [key, part] : parts) {
    stack.frame_names.push_back(key);
    stack.frames.push_back(part);
  }
}

/// The least between places, over all segments: what a file says as its slices' distance may be another. 0 of
/// one place.
double least_distance(const Images& sorted) {
  double least = 0;
  const std::vector<std::size_t> begins = places_of(sorted);
  for (std::size_t p = 1; p < begins.size(); ++p) {
    const double distance = height(sorted[begins[p]]) - height(sorted[begins[p - 1]]);
    least = least > 0 ? std::min(least, distance) : distance;
  }
  return least;
}

/// Slices that show nothing of a segment may be left out of the file. Those between others are put in, where
/// all that are there lie at multiples of the slices' distance.
Images with_empty_slices(const Images& slices, double distance, std::string& note) {
  constexpr double tolerance = 0.01;
  constexpr std::size_t most = std::size_t(1) << 16;
  if (!(distance > 0)) return slices;
  Images all = {slices[0]};
  for (std::size_t i = 1; i < slices.size(); ++i) {
    const double steps = (height(slices[i]) - height(slices[i - 1])) / distance;
    const bool fits = steps >= 0.5 && std::abs(steps - std::round(steps)) <= tolerance;
    if (!fits || double(all.size()) + steps > double(most)) return slices;
    for (std::size_t empty = 1; empty < std::size_t(std::round(steps)); ++empty)
      all.emplace_back(slices[i - 1]).is_empty = true;
    all.push_back(slices[i]);
  }
  if (const std::size_t put = all.size() - slices.size(); put > 0)
    add_note(note, fmt::format("{} slice{} that the file leaves out {} put in, and 0", put,
                               put == 1 ? "" : "s", put == 1 ? "is" : "are"));
  return all;
}

/// Segments (PS3.3, C.8.20) have the slices that they show in, which another one may lack.
bool take_segments(const Images& sorted, DicomStack& stack) {
  if (mark_of(sorted.front(), "segment").empty()) return false;
  Parts parts = parted_by(sorted, {"segment"});
  if (!places_are_unique(parts)) return false;
  const double distance = least_distance(sorted);
  for (auto& [key, part] : parts) {
    std::string note;
    part = with_empty_slices(part, distance, note);
    stack.frame_notes.push_back(note);
  }
  take_parts(parts, stack);
  return true;
}

void stack_by_position(const std::string& name, Images images, DicomStack& stack) {
  std::ranges::stable_sort(images, {}, height);
  if (take_segments(images, stack)) return;
  const std::vector<std::size_t> begins = places_of(images);
  std::size_t most = 0;
  for (std::size_t p = 0; p < begins.size(); ++p)
    most = std::max(most, (p + 1 < begins.size() ? begins[p + 1] : images.size()) - begins[p]);
  if (most == 1) {
    stack.frames.push_back(std::move(images));
    return;
  }
  const auto parts = part_by_marks(images, most);
  if (!parts) return part_by_numbers(name, std::move(images), begins, most, stack);
  take_parts(*parts, stack);
}

/// Without positions: by the numbers where each has its own, else by the files' names.
void stack_by_number(Images images, DicomStack& stack) {
  const bool one_file =
      std::ranges::all_of(images, [&](const DicomImage& i) { return i.file == images[0].file; });
  std::set<double> numbers;
  for (const DicomImage& image : images)
    if (image.number) numbers.insert(*image.number);
  const bool numbered = numbers.size() == images.size();
  std::ranges::stable_sort(images, [&](const DicomImage& a, const DicomImage& b) {
    return numbered ? *a.number < *b.number : natural_less(a.file.string(), b.file.string());
  });
  add_note(stack.note,
           one_file   ? "its frames tell no positions, and are in the file's order"
           : numbered ? "its images tell no positions, and are in the order of their numbers"
                      : "its images tell neither positions nor numbers, and are in the order of their names");
  stack.frames.push_back(std::move(images));
}

void take_order(const std::vector<DicomImage>& slices, DicomGeometry& geometry) {
  constexpr double tolerance = 0.01, straight = 0.5;  // of a spacing; degrees
  const std::size_t steps = slices.size() - 1;
  const glm::dvec3 whole = *slices.back().position - *slices.front().position;
  const double along = glm::dot(whole, geometry.direction[2]);
  geometry.spacing.z = std::abs(along) / double(steps);
  if (along < 0) geometry.direction[2] = -geometry.direction[2];
  const double tilt = glm::degrees(std::acos(std::clamp(std::abs(along) / glm::length(whole), 0.0, 1.0)));
  if (tilt > straight)
    add_note(geometry.note,
             fmt::format("its slices are shifted against each other, by a tilt of {:.3g} degrees, and "
                         "shown as a straight box",
                         tilt));
  for (std::size_t i = 0; i < steps; ++i) {
    const double step = std::abs(height(slices[i + 1]) - height(slices[i])), spacing = geometry.spacing.z;
    if (slices[i].is_empty || slices[i + 1].is_empty || std::abs(step - spacing) <= tolerance * spacing)
      continue;
    add_note(geometry.note,
             fmt::format("the slices are not evenly spaced: {:.6g} after slice {}, {:.6g} on average", step,
                         i + 1, spacing));
    return;
  }
}

/// Positions without an orientation still tell how images follow each other, where those differ along z.
void take_as_axial(Images& images, std::string& note) {
  const auto tells_place_alone = [](const DicomImage& i) { return i.position && !i.orientation; };
  const auto z_of = [](const DicomImage& i) { return i.position->z; };
  if (!std::ranges::all_of(images, tells_place_alone)) return;
  if (std::ranges::all_of(images, [&](const DicomImage& i) { return z_of(i) == z_of(images[0]); })) return;
  for (DicomImage& image : images) {
    image.orientation = {{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}};
    image.is_taken_as_axial = true;
  }
  add_note(note, "its images tell no orientation, and are taken as axial ones");
}

}  // namespace

DicomStack stack_dicom(const std::string& name, std::vector<DicomImage> images) {
  DicomStack stack;
  images = largest_class(without_copies(std::move(images), stack.note), stack.note);
  take_as_axial(images, stack.note);
  const bool placed = std::ranges::all_of(images, has_place);
  const bool counted = !placed && std::ranges::all_of(images, [](const DicomImage& image) {
    return !image.position && image.slice_number;
  });
  if (images[0].is_placed_by_number)
    add_note(stack.note, "its frames tell no positions, and are placed by the distance between slices");
  if (counted)
    add_note(stack.note, "its frames tell no positions, and are in the order of their slices' numbers");
  if ((placed || counted) && images.size() > 1)
    stack_by_position(name, std::move(images), stack);
  else
    stack_by_number(std::move(images), stack);
  return stack;
}

DicomGeometry geometry_of(const std::vector<DicomImage>& slices) {
  const DicomImage& first = slices.front();
  DicomGeometry geometry;
  if (first.orientation) {
    geometry.direction[0] = (*first.orientation)[0];
    geometry.direction[1] = (*first.orientation)[1];
    geometry.direction[2] = glm::cross(geometry.direction[0], geometry.direction[1]);
  }
  if (first.position) geometry.origin = *first.position;
  if (first.spacing) geometry.spacing = glm::dvec3(*first.spacing, 1);
  if (!first.spacing) add_note(geometry.note, "the spacing within its images is not known, and taken as 1");
  if (first.spacing_at_detector)
    add_note(geometry.note, "the spacing within its images is that at the detector");
  const bool placed = std::ranges::all_of(slices, has_place);
  if (placed && slices.size() > 1 && height(slices.front()) != height(slices.back())) {
    take_order(slices, geometry);
  } else if (first.slice_distance) {
    geometry.spacing.z = std::abs(*first.slice_distance);
  } else if (first.thickness) {
    geometry.spacing.z = *first.thickness;
    add_note(geometry.note, "the slices' distance is not known, and taken as their thickness");
  } else {
    add_note(geometry.note, "the slices' distance is not known, and taken as 1");
  }
  if (first.is_time) add_note(geometry.note, "its frames follow each other in time, not in space");
  return geometry;
}

}  // namespace crest
