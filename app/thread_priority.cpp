#include "app/thread_priority.h"

#include <sys/resource.h>

namespace crest {

constexpr int politeness = 5;

void lower_thread_priority() { setpriority(PRIO_PROCESS, 0, politeness); }  // on Linux it is of threads

}  // namespace crest
