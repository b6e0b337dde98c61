#include "render/volume/volume.h"

#include <algorithm>

namespace crest {

double Grid::smallest_spacing() const { return std::min({spacing.x, spacing.y, spacing.z}); }

std::size_t size_of(ScalarType type) {
  switch (type) {
    case ScalarType::uint8:
    case ScalarType::int8:
      return 1;
    case ScalarType::uint16:
    case ScalarType::int16:
    case ScalarType::float16:
      return 2;
    case ScalarType::uint32:
    case ScalarType::int32:
    case ScalarType::float32:
      return 4;
    case ScalarType::uint64:
    case ScalarType::int64:
    case ScalarType::float64:
      return 8;
  }
  return 0;
}

const char* name_of(ScalarType type) {
  switch (type) {
    case ScalarType::uint8:
      return "uint8";
    case ScalarType::int8:
      return "int8";
    case ScalarType::uint16:
      return "uint16";
    case ScalarType::int16:
      return "int16";
    case ScalarType::uint32:
      return "uint32";
    case ScalarType::int32:
      return "int32";
    case ScalarType::uint64:
      return "uint64";
    case ScalarType::int64:
      return "int64";
    case ScalarType::float32:
      return "float32";
    case ScalarType::float64:
      return "float64";
    case ScalarType::float16:
      return "float16";
  }
  return "";
}

bool is_integer(ScalarType type) {
  return type != ScalarType::float32 && type != ScalarType::float64 && type != ScalarType::float16;
}

}  // namespace crest
