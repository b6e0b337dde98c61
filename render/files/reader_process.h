#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace crest {

/// A program that runs beside this one and is read from: its standard output is a pipe, its input and errors
/// are nowhere, and it inherits nothing else that is open. It is ended, and waited for, with this value.
class ReaderProcess {
 public:
  /// `words`: after the program's name. Throws Error when it cannot be started. Any thread may.
  ReaderProcess(const std::filesystem::path& program, const std::vector<std::string>& words);
  ~ReaderProcess();
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  int output() const { return output_; }  ///< file descriptor
  void kill() const;                      ///< any thread may, until wait() returns
  /// Waits for its end. Its status as of waitpid(2); 0 where it cannot be known.
  int wait();
  /// Whether a signal has stopped it, so that nothing would come.
  bool is_stopped() const;

 private:
  int output_ = -1;
  pid_t pid_ = -1;
};

}  // namespace crest
