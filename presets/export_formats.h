#pragma once

#include <string>
#include <string_view>

#include "presets/exporters.h"

namespace crest {

// Each format's two functions, as Exporter describes them, in a file of its own: export_FORMAT.cpp.

std::string write_paraview(std::string_view preset_name, const TransferFunction& tf,
                           const ExportOptions& options);
std::string paraview_losses(const TransferFunction& tf, const ExportOptions& options);

std::string write_csv(std::string_view preset_name, const TransferFunction& tf, const ExportOptions& options);
std::string csv_losses(const TransferFunction& tf, const ExportOptions& options);

/// "4 world units", or "4 times the smallest spacing".
std::string unit_distance_text(const TransferFunction& tf);

/// What no other tool knows: a line about the points' surface settings, or nothing.
std::string surface_losses(const TransferFunction& tf);

}  // namespace crest
