#include "render/stability/table.h"

#include <array>

#include "render/stability/cases.h"

namespace crest::stability {
namespace {

constexpr Case cases[] = {
    {"invariances", "values scaled and shifted with the TF", values_scaled_and_shifted},
    {"invariances", "world scaled with the unit distance", world_scaled},
    {"invariances", "a point inserted on a line", point_on_a_line},
    {"invariances", "mirrored volume and camera", mirrored},

    {"opacities", "haze of opacity 1e-7, 1-1e-7 and 1", faint_and_opaque_haze},
    {"opacities", "surfaces of opacity 1e-7, 1-1e-7 and 1", faint_and_opaque_surfaces},
    {"opacities", "extinction times step from 1e-9 to 1e9", extinction_times_step},
    {"opacities", "unit distance of 1e-40 and less", beyond_all_opacity},
    {"opacities", "1e5 crossings of opacity 1e-5", hundred_thousand_crossings},
    {"opacities", "steps from 8 voxels to 1/256", steps_long_and_short},

    {"cameras", "the eye inside the volume", eye_inside_the_volume},
    {"cameras", "the eye on a face", eye_on_a_face},
    {"cameras", "the eye at a point", eye_at_a_point},
    {"cameras", "the eye at 1e6 diagonals", eye_far_away},
    {"cameras", "a ray along an axis", ray_along_an_axis},
    {"cameras", "rays in a face", ray_in_a_face},
    {"cameras", "a ray along an edge", ray_along_an_edge},
    {"cameras", "a ray of no length at a corner", ray_of_no_length},
    {"cameras", "fields of view of 0.001 and 170 degrees", fields_of_view},
    {"cameras", "`up` parallel to the view", up_along_the_view},
};

Row failed(const Case& one, const std::exception& error) {
  Row row;
  row.claim.name = one.name;
  row.claim.quantity = error.what();
  return row;
}

}  // namespace

std::span<const Case> all_cases() { return cases; }

std::vector<Row> run_all(Lab& lab, const std::function<void(const Case&)>& progress) {
  std::vector<Row> table;
  for (const Case& one : cases) {
    if (progress) progress(one);
    std::vector<Row> rows;
    try {
      rows = one.rows(lab);
    } catch (const std::exception& error) {
      rows = {failed(one, error)};
    }
    for (Row& row : rows) {
      row.group = one.group;
      table.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace crest::stability
