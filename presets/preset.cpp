#include "presets/preset.h"

#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"

namespace crest {

std::string why_inconsistent(const Rendering& rendering) {
  if (!holds_one_length(rendering.classification)) return "";
  const auto complaint = [](std::string_view field, std::string_view wanted, std::string_view is) {
    return fmt::format(
        "rendering.{0}: the pre-integrated table holds steps of one length, which takes {0} {1}, not {2} "
        "(classification preintegrated has no such limit)",
        field, wanted, is);
  };
  if (!has_equal_steps(rendering.sampling))
    return complaint("sampling", name_of(Sampling::uniform), name_of(rendering.sampling));
  if (rendering.adaptive) return complaint("adaptive", "false", "true");
  if (rendering.placement != Placement::entry)
    return complaint("placement", name_of(Placement::entry), name_of(rendering.placement));
  return "";
}

}  // namespace crest
