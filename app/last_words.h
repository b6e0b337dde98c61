#pragma once

namespace crest {

/// From now on a crash says one line on stderr. Where memory is limited (ulimit -v), of which a driver may
/// have got none, and where the processor time that is allowed ended, that ends the program as any other
/// failure does: with exit code 1. What a save has begun stays beside its target until a later save. A crash
/// in a thread that blocks all signals, as Mesa's do, cannot be told.
void end_crashes_with_a_line();
/// And from now on without a line, since the program has told why it ends.
void end_crashes_silently();

}  // namespace crest
