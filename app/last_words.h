#pragma once

namespace crest {

/// From now on a crash, of a driver that gets no memory above all, and the end of the processor time that is
/// allowed, end the program as any other failure does: with one line on stderr and exit code 1. What a save
/// has begun stays beside its target until a later save. A crash in a thread that blocks all signals, as
/// Mesa's do, cannot be told.
void end_crashes_with_a_line();
/// And from now on without a line, since the program has told why it ends.
void end_crashes_silently();

}  // namespace crest
