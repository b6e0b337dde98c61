#pragma once

namespace crest {

/// The calling thread, and those that it starts, give way to the window's: a software renderer needs the same
/// processors.
void lower_thread_priority();

}  // namespace crest
