#include "render/readers/itk_support.h"

#include <fmt/core.h>

#include <algorithm>
#include <new>

#include "presets/error.h"
#include "render/files/header_text.h"

namespace crest {
namespace {

/// An exception's text without the objects, and their addresses, that ITK names in it.
std::string without_objects(std::string text) {
  for (const std::string_view head : {"itk::ERROR: ", "ITK ERROR: "}) {
    for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head)) {
      const std::size_t object = text.find("(0x", at), end = text.find("): ", at);
      const bool has_object = object != std::string::npos && end != std::string::npos && object < end;
      text.erase(at, has_object ? end + 3 - at : head.size());
    }
  }
  return one_line(text);
}

}  // namespace

void with_itk(const std::string& name, const std::function<void()>& work) {
  try {
    work();
  } catch (const itk::ExceptionObject& e) {
    throw Error(fmt::format("{}: it could not be read: {}", name, without_objects(e.GetDescription())));
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: reading it takes more memory than there is", name));
  } catch (const std::exception& e) {
    throw Error(fmt::format("{}: it could not be read: {}", name, without_objects(e.what())));
  }
}

ScalarType scalar_type(const std::string& name, itk::CommonEnums::IOComponent component) {
  using enum itk::CommonEnums::IOComponent;
  static_assert(sizeof(long) == 8);
  switch (component) {
    case UCHAR:
      return ScalarType::uint8;
    case CHAR:
      return ScalarType::int8;
    case USHORT:
      return ScalarType::uint16;
    case SHORT:
      return ScalarType::int16;
    case UINT:
      return ScalarType::uint32;
    case INT:
      return ScalarType::int32;
    case ULONG:
    case ULONGLONG:
      return ScalarType::uint64;
    case LONG:
    case LONGLONG:
      return ScalarType::int64;
    case FLOAT:
      return ScalarType::float32;
    case DOUBLE:
      return ScalarType::float64;
    default:
      break;
  }
  throw Error(fmt::format("{}: its voxels are of a type ({}) that is not read; int8 to float64 are", name,
                          itk::ImageIOBase::GetComponentTypeAsString(component)));
}

std::vector<ChoiceOption> component_options(const itk::ImageIOBase& io) {
  using enum itk::CommonEnums::IOPixel;
  std::vector<std::string> names;
  if (io.GetPixelType() == RGB) names = {"red", "green", "blue"};
  if (io.GetPixelType() == RGBA) names = {"red", "green", "blue", "alpha"};
  if (io.GetPixelType() == COMPLEX) names = {"real part", "imaginary part"};
  std::vector<ChoiceOption> options;
  if (names.size() != io.GetNumberOfComponents()) return options;
  for (std::size_t i = 0; i < names.size(); ++i)
    options.push_back({fmt::format("{}", i), fmt::format("component {}: {}", i, names[i])});
  return options;
}

void take_geometry(const itk::ImageIOBase& io, Volume& volume) {
  for (unsigned axis = 0; axis < std::min(3u, io.GetNumberOfDimensions()); ++axis) {
    volume.grid.spacing[int(axis)] = io.GetSpacing(axis);
    volume.grid.origin[int(axis)] = io.GetOrigin(axis);
    const std::vector<double> cosines = io.GetDirection(axis);
    for (unsigned row = 0; row < std::min<std::size_t>(3, cosines.size()); ++row) {
      volume.direction[int(axis)][int(row)] = cosines[row];
    }
  }
}

}  // namespace crest
