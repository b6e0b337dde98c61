#pragma once

namespace crest {

/// Takes from this process, for good, what no reader needs: to write files, to start programs, the network,
/// the terminal, other processes.
/// It ends with the thread that started it. What the system refuses (in some containers) is left out.
void confine();

}  // namespace crest
