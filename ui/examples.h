#pragma once

#include <span>

namespace crest {

/// A built-in volume and a preset of the library that show one thing together.
struct Example {
  const char* title;
  const char* shows;
  const char* volume;  ///< its source
  const char* preset;  ///< its name
};

std::span<const Example> examples();

}  // namespace crest
