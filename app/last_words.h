#pragma once

namespace crest {

/// From now on a crash, of a driver that gets no memory above all, ends the program as any other failure
/// does: with one line on stderr and exit code 1. What saves have begun stays beside its target until the
/// next save.
void end_crashes_with_a_line();
/// And from now on without a line, since the program has told why it ends.
void end_crashes_silently();

}  // namespace crest
