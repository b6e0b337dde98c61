#include "app/volume_loader.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <thread>
#include <utility>

#include "render/files/time_steps.h"

namespace crest {

struct VolumeLoader::Job {
  Result result;
  std::stop_source stop;
  std::atomic<bool> is_done = false;
};

namespace {

Volume read_until(const std::string& source, std::stop_token stop) {
  Reading reading;
  reading.stop = std::move(stop);
  reading.asks = true;
  return load_first_step(source, reading);
}

}  // namespace

VolumeLoader::VolumeLoader() : VolumeLoader(read_until) {}

VolumeLoader::Read VolumeLoader::default_read() { return read_until; }

VolumeLoader::VolumeLoader(Read read) : read_(std::move(read)) {}

VolumeLoader::~VolumeLoader() { cancel(); }

void VolumeLoader::cancel() {
  if (job_) job_->stop.request_stop();
  job_.reset();
}

const std::string& VolumeLoader::source() const { return job_->result.source; }

void VolumeLoader::start(const std::string& source) {
  cancel();
  job_ = std::make_shared<Job>();
  job_->result.source = source;
  std::erase_if(threads_, [](const auto& thread) { return thread.expired(); });
  threads_.push_back(job_);
  std::thread([job = job_, read = read_, source] {
    try {
      job->result.volume = std::make_shared<const Volume>(read(source, job->stop.get_token()));
    } catch (const std::bad_alloc&) {
      job->result.error = source + ": reading it takes more memory than there is";
    } catch (const ChoiceNeeded& needed) {
      job->result.error = needed.what();
      job->result.choice = needed.choice;
    } catch (const std::exception& error) {
      job->result.error = error.what();
    }
    job->is_done = true;
  }).detach();
}

std::optional<VolumeLoader::Result> VolumeLoader::take() {
  if (!job_ || !job_->is_done) return std::nullopt;
  return std::move(std::exchange(job_, nullptr)->result);
}

bool VolumeLoader::has_news() const { return job_ && job_->is_done; }

bool VolumeLoader::has_thread() const {
  return std::ranges::any_of(threads_, [](const auto& thread) { return !thread.expired(); });
}

}  // namespace crest
