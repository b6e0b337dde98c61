#pragma once

#include <functional>
#include <vector>

namespace crest {

/// Wall-clock milliseconds of `work`, until the graphics device has finished it.
double finished_ms(const std::function<void()>& work);

/// A clock that only goes forward.
double steady_seconds();

double median(std::vector<double> values);

}  // namespace crest
