#include "ui/examples.h"

namespace crest {

std::span<const Example> examples() {
  static constexpr Example all[] = {
      {"A spike that samples miss", "The red shell is lost by samples alone", "builtin:plume?n=96",
       "dirac-shell"},
      {"Four close peaks", "One step crosses several surfaces, in their right order",
       "builtin:marschner-lobb?n=64", "four-peaks"},
      {"Bone under glass, as in a CT", "A sharp solid in clear skin; the data are made up",
       "builtin:noise?n=64&high=2", "glass-and-bone"},
      {"A tree of vessels", "Thin tubes with a translucent wall and a bright core", "builtin:vessels?n=96",
       "vessels-shell"}};
  return all;
}

}  // namespace crest
