#pragma once

#include <vector>

#include "render/studies/stability/lab.h"

// The cases of the table, by the file that holds them. Each returns its rows, without their group.

namespace crest::stability {

// invariances.cpp
std::vector<Row> values_scaled_and_shifted(Lab& lab);
std::vector<Row> world_scaled(Lab& lab);
std::vector<Row> point_on_a_line(Lab& lab);
std::vector<Row> mirrored(Lab& lab);

// transfer_functions.cpp
std::vector<Row> widths_of_peaks(Lab& lab);
std::vector<Row> widths_of_spikes_in_haze(Lab& lab);
std::vector<Row> colors_of_narrow_peaks(Lab& lab);
std::vector<Row> peaks_one_float_apart(Lab& lab);
std::vector<Row> few_and_many_peaks(Lab& lab);
std::vector<Row> four_peaks_in_one_step(Lab& lab);
std::vector<Row> plateaus(Lab& lab);
std::vector<Row> steps_of_the_tf(Lab& lab);
std::vector<Row> step_at_a_label(Lab& lab);
std::vector<Row> outside_the_data(Lab& lab);

// opacities.cpp
std::vector<Row> faint_and_opaque_haze(Lab& lab);
std::vector<Row> faint_and_opaque_surfaces(Lab& lab);
std::vector<Row> extinction_times_step(Lab& lab);
std::vector<Row> surface_in_dense_haze(Lab& lab);
std::vector<Row> beyond_all_opacity(Lab& lab);
std::vector<Row> hundred_thousand_crossings(Lab& lab);
std::vector<Row> steps_long_and_short(Lab& lab);

// crossings.cpp
std::vector<Row> samples_on_the_isovalue(Lab& lab);
std::vector<Row> integers_with_peaks_at_integers(Lab& lab);
std::vector<Row> touching_extrema(Lab& lab);
std::vector<Row> regions_on_the_isovalue(Lab& lab);
std::vector<Row> roots_on_faces_edges_and_points(Lab& lab);
std::vector<Row> three_roots_in_a_cell(Lab& lab);

// values.cpp
std::vector<Row> tiny_and_huge_values(Lab& lab);
std::vector<Row> far_from_zero(Lab& lab);
std::vector<Row> signed_values(Lab& lab);
std::vector<Row> constant_volumes(Lab& lab);
std::vector<Row> voxels_without_a_value(Lab& lab);

// grids.cpp
std::vector<Row> smallest_grid(Lab& lab);
std::vector<Row> long_grid(Lab& lab);
std::vector<Row> long_spacing(Lab& lab);

// cameras.cpp
std::vector<Row> eye_inside_the_volume(Lab& lab);
std::vector<Row> eye_on_a_face(Lab& lab);
std::vector<Row> eye_at_a_point(Lab& lab);
std::vector<Row> eye_far_away(Lab& lab);
std::vector<Row> ray_along_an_axis(Lab& lab);
std::vector<Row> ray_in_a_face(Lab& lab);
std::vector<Row> ray_along_an_edge(Lab& lab);
std::vector<Row> ray_of_no_length(Lab& lab);
std::vector<Row> fields_of_view(Lab& lab);
std::vector<Row> up_along_the_view(Lab& lab);

}  // namespace crest::stability
