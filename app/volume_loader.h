#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/files/file_request.h"
#include "render/files/open_choice.h"
#include "render/volume/volume.h"

namespace crest {

/// Reads volumes beside the window; the one that was asked for last counts. What is no longer wanted is asked
/// to stop, which ends a reader's program at once (Reading::stop); its thread holds nothing but its own data,
/// and what it finds is dropped. No call waits.
class VolumeLoader {
 public:
  using Read = std::function<Volume(const std::string& source, const Reading& reading)>;
  /// Reads with load_first_step().
  VolumeLoader();
  static Read default_read();
  /// `read` is called in other threads, also after the loader is gone, with a reading that asks
  /// (Reading::asks), stops and tells how far it is.
  explicit VolumeLoader(Read read);
  ~VolumeLoader();
  VolumeLoader(const VolumeLoader&) = delete;
  VolumeLoader& operator=(const VolumeLoader&) = delete;

  struct Result {
    std::string source;
    std::shared_ptr<const Volume> volume;  ///< null where it could not be read
    std::string error;                     ///< why
    std::optional<OpenChoice> choice;      ///< that must be made first
  };

  /// Reads this one, in place of what is being read.
  void start(const std::string& source);
  /// Stops what is being read, and lets go of it.
  void cancel();
  bool is_loading() const { return job_ != nullptr; }
  bool has_news() const;              ///< take() has something
  const std::string& source() const;  ///< of what is being read; is_loading() must be true
  /// How much of it is read, in [0, 1]. Nothing while no reader has told, and in the first half second: a
  /// number that comes and goes at once is of no use.
  std::optional<double> share() const;
  /// What was read, once.
  std::optional<Result> take();

  /// Whether a thread still reads, wanted or not. A program that ends meanwhile must not take apart what the
  /// thread uses: std::_Exit.
  bool has_thread() const;

 private:
  struct Job;
  Read read_;
  std::shared_ptr<Job> job_;                 ///< the one that counts
  std::vector<std::weak_ptr<Job>> threads_;  ///< each lives as long as its thread
};

}  // namespace crest
