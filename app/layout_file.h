#pragma once

#include <filesystem>

#include "app/background_writer.h"
#include "app/studio.h"

namespace crest {

/// What a script needs that drives the window from outside, as lines of tab-separated words: the window's
/// title, whether anything is still being drawn, and the middle of each named widget in pixels. Written when
/// it changed, a moment later. update() throws Error where it could not be.
class LayoutFile {
 public:
  explicit LayoutFile(std::filesystem::path path) : path_(std::move(path)) {}
  void update(const Studio& studio);

 private:
  std::filesystem::path path_;
  std::string last_;
  BackgroundWriter writer_;
};

}  // namespace crest
