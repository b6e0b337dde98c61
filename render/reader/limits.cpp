#include "render/reader/limits.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace crest {
namespace {

namespace fs = std::filesystem;

#ifdef __SANITIZE_ADDRESS__
constexpr bool limits_memory = false;  // its shadow takes terabytes of address space
constexpr double slower = 20;
#else
constexpr bool limits_memory = true;
constexpr double slower = 1;
#endif

std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * std::uint64_t(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource resource, std::uint64_t most) {
  rlimit limits{};
  if (::getrlimit(resource, &limits) != 0) return;
  limits.rlim_cur = std::min<std::uint64_t>(most, limits.rlim_max);
  ::setrlimit(resource, &limits);
}

}  // namespace

Limits::Limits() : taken_(address_space()) {}

double Limits::allow(std::uint64_t bytes) const {
  // A file's bytes, decoded and as numbers, are held a few times over; a decoder takes some in any case.
  constexpr std::uint64_t margin = std::uint64_t(256) << 20, copies = 3, most = std::uint64_t(1) << 60;
  if (limits_memory) limit(RLIMIT_AS, taken_ + margin + copies * std::min(bytes, most));

  constexpr double least = 1,
                   bytes_per_second = 4e6;  // the slowest, text and JPEG 2000, take a tenth of that
  const double seconds = std::min(slower * (least + double(bytes) / bytes_per_second), 1e9);
  itimerval timer{};
  timer.it_value.tv_sec = time_t(seconds);
  timer.it_value.tv_usec = suseconds_t(1e6 * (seconds - std::floor(seconds)));
  ::setitimer(ITIMER_PROF, &timer, nullptr);
  return seconds;
}

std::uint64_t bytes_held(const fs::path& path) {
  constexpr std::uint64_t a_file = std::uint64_t(1) << 16;
  std::error_code fault;
  if (!fs::is_directory(path, fault)) {
    const std::uintmax_t size = fs::file_size(path, fault);
    return fault ? 0 : size;
  }
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(path, fault)) {
    const std::uintmax_t size = entry.is_regular_file(fault) ? entry.file_size(fault) : 0;
    if (!fault) bytes += size + a_file;
  }
  return bytes;
}

}  // namespace crest
