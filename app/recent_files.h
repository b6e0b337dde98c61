#pragma once

#include <string>
#include <vector>

#include "app/background_writer.h"

namespace crest {

/// The volumes and presets that were opened last, newest first, kept in $XDG_CONFIG_HOME/crest (or
/// ~/.config/crest). What cannot be read or written there is no error: the list is then empty, or lives only
/// as long as the program.
class RecentFiles {
 public:
  RecentFiles();
  void add(const std::string& opened);
  const std::vector<std::string>& list() const { return list_; }
  void finish_writing() { writer_.finish(); }

 private:
  std::vector<std::string> list_;
  BackgroundWriter writer_;
};

}  // namespace crest
