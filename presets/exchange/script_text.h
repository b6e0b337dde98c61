#pragma once

#include <string>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

// Parts of programs. Names and paths hold what they like, and none of it may become code.

/// A list of tuples, value, red, green, blue, opacity; the points with these values.
std::string python_points(const TransferFunction& tf, const std::vector<double>& values);
std::string python_peaks(const std::vector<Peak>& peaks);
/// A string literal.
std::string python_string(const std::string& text);
/// A word of a shell's line, in single quotes.
std::string shell_string(const std::string& text);
/// For comments: control characters are replaced by spaces.
std::string one_line(std::string text);

}  // namespace crest
