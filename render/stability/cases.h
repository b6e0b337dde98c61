#pragma once

#include <vector>

#include "render/stability/lab.h"

// The cases of the table, by the file that holds them. Each returns its rows, without their group.

namespace crest::stability {

// invariances.cpp
std::vector<Row> values_scaled_and_shifted(Lab& lab);
std::vector<Row> world_scaled(Lab& lab);
std::vector<Row> point_on_a_line(Lab& lab);
std::vector<Row> mirrored(Lab& lab);

// opacities.cpp
std::vector<Row> faint_and_opaque_haze(Lab& lab);
std::vector<Row> faint_and_opaque_surfaces(Lab& lab);
std::vector<Row> extinction_times_step(Lab& lab);
std::vector<Row> beyond_all_opacity(Lab& lab);
std::vector<Row> hundred_thousand_crossings(Lab& lab);
std::vector<Row> steps_long_and_short(Lab& lab);

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
