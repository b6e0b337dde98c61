#include "render/volume/itk_support.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <mutex>
#include <new>

#include "presets/error.h"
#include "render/volume/header_text.h"

namespace crest {
namespace {

/// Sends stderr to /dev/null for as long as this lives: NIfTI's and MetaIO's readers, GDCM and ITK itself
/// each print on it in a way of their own.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)) {
    flush();
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~Silence() {
    flush();
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static void flush() {
    std::cerr.flush();
    std::fflush(stderr);
  }
  int kept_;
};

/// An exception's text in one line, without the object that ITK begins it with.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  const std::size_t object = text.find("): ");
  if (text.starts_with("ITK ERROR") && object != std::string::npos) text.erase(0, object + 3);
  return std::string(trim(text));
}

}  // namespace

void with_itk(const std::string& name, const std::function<void()>& work) {
  static std::mutex one_at_a_time;  // stderr is the process's
  const std::lock_guard lock(one_at_a_time);
  const Silence silence;
  try {
    work();
  } catch (const itk::ExceptionObject& e) {
    throw Error(fmt::format("{}: it could not be read: {}", name, one_line(e.GetDescription())));
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: reading it takes more memory than there is", name));
  } catch (const std::exception& e) {
    throw Error(fmt::format("{}: it could not be read: {}", name, one_line(e.what())));
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
