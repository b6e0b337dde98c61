#pragma once

#include <string>
#include <vector>

namespace crest::test {

/// What a save asks of the disk, in the order in which it does: this program has functions of its own in
/// place of the C library's write(), fsync(), fchmod(), rename() and unlink(). These are the calls by
/// which a save that is made as it should be changes what others see of the disk.
struct DiskCall {
  enum Kind { write, sync, mode, rename, remove } kind;
  std::string path, to;  ///< of the open file, or as given; of rename()
};

/// From now on calls are kept in mind. A write to a file gets rid of at most some 500 bytes, as the kernel
/// may have it, so that a kill can find it half done. The `kill_before`-th call, counted from 0, is not made:
/// this process is killed (SIGKILL).
void watch_disk_calls(int kill_before);
std::vector<DiskCall> watched_disk_calls();

}  // namespace crest::test
