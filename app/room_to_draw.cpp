#include "app/room_to_draw.h"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <latch>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "presets/error.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

void require_address_space(std::size_t threads) {
  rlimit limits{};
  if (::getrlimit(RLIMIT_AS, &limits) != 0 || limits.rlim_cur == RLIM_INFINITY) return;
  // Measured on llvmpipe; a thread has its stack and what the allocator sets aside for it
  constexpr std::uint64_t driver = std::uint64_t(1) << 30, a_thread = std::uint64_t(72) << 20;
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uint64_t taken = pages * std::uint64_t(::sysconf(_SC_PAGESIZE)),
                      left = limits.rlim_cur > taken ? limits.rlim_cur - taken : 0,
                      needed = driver + threads * a_thread;
  if (left < needed)
    throw Error(fmt::format("drawing takes {} of address space, and ulimit -v leaves {}", byte_text(needed),
                            byte_text(left)));
}

void require_threads(std::size_t count) {
  std::latch end(1);
  std::vector<std::jthread> threads;  // all at once: that is what counts
  try {
    threads.reserve(count);
    while (threads.size() < count) threads.emplace_back([&end] { end.wait(); });
    end.count_down();
  } catch (const std::bad_alloc&) {
    end.count_down();
    throw;
  } catch (const std::system_error& error) {
    end.count_down();
    throw Error(fmt::format("drawing takes {} threads, and the system gives {} (ulimit -u allows more): {}",
                            count, threads.size(), error.code().message()));
  }
}

}  // namespace

void require_room_to_draw() {
  // The driver's, those of the library that writes pictures, and some that do one thing each
  constexpr unsigned most_that_draw = 32, others = 8;
  const std::size_t threads = 2 * std::min(std::thread::hardware_concurrency(), most_that_draw) + others;
  require_address_space(threads);
  require_threads(threads);
}

}  // namespace crest
