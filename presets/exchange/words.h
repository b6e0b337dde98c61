#pragma once

#include <string>
#include <vector>

#include "presets/exchange/exporters.h"

namespace crest {

// Sentences about what targets cannot hold. Each adds one where there is something to say.

/// Surfaces of peaks, where the mode shows them and the target has none.
void say_no_peaks(const ExportInput& input, std::vector<std::string>& losses);
/// Surfaces that a person switched on or off, or gave an opacity of their own, where the target keeps no such
/// setting.
void say_no_surface_settings(const ExportInput& input, std::vector<std::string>& losses);
/// Points that were moved apart.
void say_moved(const TransferFunction& tf, const std::vector<double>& values,
               std::vector<std::string>& losses);
/// Filters, blend modes and a clip box, which no file of a TF holds.
void say_no_rendering(const ExportInput& input, std::vector<std::string>& losses);

/// Of VTK's shading, where the volume is shaded: where the field is flat it is dark.
void say_dark_where_flat(const ExportInput& input, std::vector<std::string>& losses);

/// "0.25", as short as it reads back to the same number.
std::string number(double value);
/// For sentences: six digits.
std::string short_number(double value);

/// Of the side of a box; that of one that is no cube is the mean (geometric) of its three.
double mean_side(const glm::dvec3& size);
/// Inviwo's opacities are those of this share of the volume's side.
inline constexpr double inviwo_share = 1.0 / 150;

/// Opacity for another unit distance: a' = 1 - (1 - a)^(to / from).
double opacity_over(double opacity, double from, double to);
/// The TF with its opacities for another unit distance.
TransferFunction with_unit_distance(TransferFunction tf, double unit_distance);

}  // namespace crest
