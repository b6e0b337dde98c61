#include "app/volume_loader.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <new>
#include <thread>
#include <utility>

#include "render/files/time_steps.h"

namespace crest {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds before_share{500};

}  // namespace

struct VolumeLoader::Job {
  Result result;
  std::stop_source stop;
  std::atomic<double> share = -1;  ///< negative while nothing was told
  std::atomic<bool> is_done = false;
  Clock::time_point begin = Clock::now();
};

VolumeLoader::VolumeLoader() : VolumeLoader(default_read()) {}

VolumeLoader::Read VolumeLoader::default_read() { return load_first_step; }

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
      Reading reading;
      reading.asks = true;
      reading.stop = job->stop.get_token();
      reading.progress = [job](double share) { job->share = share; };
      job->result.volume = std::make_shared<const Volume>(read(source, reading));
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

std::optional<double> VolumeLoader::share() const {
  if (!job_ || job_->share < 0 || Clock::now() - job_->begin < before_share) return std::nullopt;
  return job_->share;
}

bool VolumeLoader::has_news() const { return job_ && job_->is_done; }

bool VolumeLoader::has_thread() const {
  return std::ranges::any_of(threads_, [](const auto& thread) { return !thread.expired(); });
}

}  // namespace crest
