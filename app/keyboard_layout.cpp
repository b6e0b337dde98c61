#include "app/keyboard_layout.h"

#include <cctype>
#include <string_view>

namespace crest {

int key_on_cap(int key, const char* name) {
  if (!name || name[0] == '\0' || name[1] != '\0') return key;  // it types nothing, or more than ASCII
  const unsigned char typed = static_cast<unsigned char>(name[0]);
  if (std::isalnum(typed)) return std::toupper(typed);
  const bool is_letters_place = key >= 'A' && key <= 'Z';
  if (!is_letters_place) return key;
  // These have a number of their own, which is their ASCII code
  constexpr std::string_view with_keys = "',-./;=[\\]`";
  return with_keys.find(char(typed)) != with_keys.npos ? int(typed) : -1;
}

}  // namespace crest
