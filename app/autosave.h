#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "app/recovery_file.h"

namespace crest {

/// Keeps the document in a RecoveryFile while it has unsaved changes. It is written in a thread, so that the
/// window does not wait for the disk. What is kept outlives this object: end() is for a person who saved, or
/// who chose to lose it.
class Autosave {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds rest{2};      ///< an edit is kept so long after the last one,
  static constexpr std::chrono::seconds longest{10};  ///< or so long after the first that is not kept

  /// An empty folder: nothing is kept.
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// To be called again and again, also while the window rests. Returns what went wrong, once.
  std::string update(const Document& document, bool has_unsaved_changes, Clock::time_point now);
  /// Takes over the file of a program that ended, whose document is now this one's, in place of its own.
  void adopt(RecoveryFile file, const Document& document);
  /// What is kept of this document stays for the next start, as if the program ended here.
  void leave_behind(const Document& document);
  /// Nothing is to be kept of what was; waits for what is being written.
  void end();
  bool is_writing() const;

 private:
  void begin_writing(const Document& document);

  std::filesystem::path folder_;
  std::optional<RecoveryFile> file_;  ///< the thread's while it writes
  std::future<void> writing_;         ///< valid until its outcome was told
  Document seen_;                     ///< as of the last update with unsaved changes
  bool waits_ = false;                ///< it is to be written
  std::string told_;                  ///< the last error
  Clock::time_point first_change_, last_change_;
};

}  // namespace crest
