#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace crest {

/// Tells on stderr how far a sweep is: one line that is drawn over on a terminal, else a line now and then.
class ProgressLine {
 public:
  explicit ProgressLine(std::optional<double> budget_seconds);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done`: share of what it is doing, in [0, 1].
  void show(std::string_view doing, double done, std::size_t points, double seconds);

 private:
  std::optional<double> budget_seconds_;
  bool is_terminal_;
  double last_seconds_ = -1e9;
};

}  // namespace crest
