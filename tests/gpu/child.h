#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace crest::gpu {

/// A program that runs beside this one, in a process group of its own; what it prints goes into a file. It is
/// ended when this dies, or after its time.
class Child {
 public:
  /// Throws Error when it cannot be started.
  Child(std::vector<std::string> words, std::filesystem::path output, double limit_s);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool is_over();  ///< does not wait
  void wait();

  // Once it is over:
  bool succeeded() const { return status_ == 0 && !timed_out_; }
  bool timed_out() const { return timed_out_; }
  double seconds() const { return seconds_; }
  std::string end() const;     ///< "exit code 1", "signal 11", "stopped after 20 s"
  std::string output() const;  ///< both streams

 private:
  pid_t id_ = 0;
  std::filesystem::path output_;
  double limit_s_, began_, seconds_ = 0;
  int status_ = 0;
  bool is_over_ = false, timed_out_ = false;
};

}  // namespace crest::gpu
