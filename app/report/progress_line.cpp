#include "app/report/progress_line.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace crest {
namespace {

constexpr double seconds_between_lines = 10, seconds_between_redraws = 0.1;

std::string bar(double share) {
  constexpr int width = 24;
  const int filled = int(std::clamp(share, 0.0, 1.0) * width);
  return fmt::format("[{:#>{}}{:->{}}]", "", filled, "", width - filled);
}

}  // namespace

ProgressLine::ProgressLine(std::optional<double> budget_seconds)
    : budget_seconds_(budget_seconds), is_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (is_terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(std::string_view doing, double done, std::size_t points, double seconds) {
  if (seconds < last_seconds_ + (is_terminal_ ? seconds_between_redraws : seconds_between_lines)) return;
  last_seconds_ = seconds;
  const std::string time = budget_seconds_ ? fmt::format("{:.0f} of {:.0f} s", seconds, *budget_seconds_)
                                           : fmt::format("{:.0f} s", seconds);
  const std::string text = fmt::format("{}, {} points, {} {:.0f} %", time, points, doing, 100 * done);
  if (is_terminal_)
    fmt::print(stderr, "\r\033[K{} {}", budget_seconds_ ? bar(seconds / *budget_seconds_) : "", text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
}

}  // namespace crest
