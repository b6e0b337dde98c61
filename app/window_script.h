#pragma once

#include <filesystem>

#include "app/studio.h"

namespace crest {

/// Writes what a script needs that drives the window from outside: where each named widget is, in pixels of
/// the window, and whether the views are done. Written only when it changed.
class LayoutFile {
 public:
  explicit LayoutFile(std::filesystem::path path) : path_(std::move(path)) {}
  void update(const Studio& studio);

 private:
  std::filesystem::path path_;
  std::string last_;
};

}  // namespace crest
