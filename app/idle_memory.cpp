#include "app/idle_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace crest {
namespace {

using namespace std::chrono_literals;

constexpr auto pause = 2s;      ///< since the last input: who pauses may go on at any time
constexpr auto seldom_is = 5s;  ///< between two times

}  // namespace

void IdleMemory::rest(Clock::time_point now, Clock::time_point last_input) {
  if (is_given_back_ || now - last_input < pause || now - given_back_at_ < seldom_is) return;
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
  is_given_back_ = true;
  given_back_at_ = now;
}

}  // namespace crest
