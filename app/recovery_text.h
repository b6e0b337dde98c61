#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "ui/document.h"

namespace crest {

/// A document as it was at a time, while it had changes that were not saved.
struct KeptDocument {
  Document document;
  std::chrono::system_clock::time_point time;  ///< in whole seconds
};

/// As a recovery file has it: JSON. What is no UTF-8 in a name is replaced, since it must not cost the edit.
std::string recovery_text(const KeptDocument& kept);
/// Throws Error, which begins with `source`, where the text is none of ours.
KeptDocument parse_recovery(std::string_view text, const std::string& source);

}  // namespace crest
