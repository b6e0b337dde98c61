#pragma once

namespace crest {

/// Throws Error where the limits of the process (ulimit -v, ulimit -u) leave less memory or fewer threads
/// than a driver takes that draws on the processor. Mesa's (22.3) looks at neither: it crashes, or waits for
/// ever for threads that it did not get.
void require_room_to_draw();

}  // namespace crest
