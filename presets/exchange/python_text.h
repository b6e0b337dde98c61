#pragma once

#include <string>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

// Parts of Python programs.

/// A list of tuples, value, red, green, blue, opacity; the points with these values.
std::string python_points(const TransferFunction& tf, const std::vector<double>& values);
std::string python_peaks(const std::vector<Peak>& peaks);
/// A string literal.
std::string python_string(const std::string& text);
/// For comments: control characters are replaced by spaces.
std::string one_line(std::string text);

}  // namespace crest
