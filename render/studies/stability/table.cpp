#include "render/studies/stability/table.h"

#include <array>

#include "render/studies/stability/cases.h"

namespace crest::stability {
namespace {

constexpr Case table[] = {
    {"invariances", "values scaled and shifted with the TF", values_scaled_and_shifted},
    {"invariances", "world scaled with the unit distance", world_scaled},
    {"invariances", "a point inserted on a line", point_on_a_line},
    {"invariances", "mirrored volume and camera", mirrored},

    {"transfer functions", "peak widths from 1e-1 to 1e-12, and a true spike", widths_of_peaks},
    {"transfer functions", "spikes of any width in haze", widths_of_spikes_in_haze},
    {"transfer functions", "colours of narrow peaks in DVR", colors_of_narrow_peaks},
    {"transfer functions", "peaks one float apart", peaks_one_float_apart},
    {"transfer functions", "2 and 1000 peaks", few_and_many_peaks},
    {"transfer functions", "four peaks inside one sample's change of value", four_peaks_in_one_step},
    {"transfer functions", "plateaus", plateaus},
    {"transfer functions", "steps", steps_of_the_tf},
    {"transfer functions", "a step at the value of a region", step_at_a_label},
    {"transfer functions", "TFs wholly outside the data", outside_the_data},

    {"opacities", "haze of opacity 1e-7, 1-1e-7 and 1", faint_and_opaque_haze},
    {"opacities", "surfaces of opacity 1e-7, 1-1e-7 and 1", faint_and_opaque_surfaces},
    {"opacities", "extinction times step from 1e-9 to 1e9", extinction_times_step},
    {"opacities", "a surface in dense haze", surface_in_dense_haze},
    {"opacities", "unit distance of 1e-40 and less", beyond_all_opacity},
    {"opacities", "1e5 crossings of opacity 1e-5", hundred_thousand_crossings},
    {"opacities", "steps from 8 voxels to 1/256", steps_long_and_short},

    {"crossings", "samples on the isovalue", samples_on_the_isovalue},
    {"crossings", "integer data with peaks at integer values", integers_with_peaks_at_integers},
    {"crossings", "touching extrema", touching_extrema},
    {"crossings", "regions with f = v", regions_on_the_isovalue},
    {"crossings", "roots on a face, an edge, a point", roots_on_faces_edges_and_points},
    {"crossings", "three roots in a cell", three_roots_in_a_cell},

    {"values", "values around 1e-30 and 1e30", tiny_and_huge_values},
    {"values", "an offset of 1e6 with variation of 1", far_from_zero},
    {"values", "16-bit signed with negative values", signed_values},
    {"values", "constant volumes", constant_volumes},
    {"values", "NaN and Inf corners", voxels_without_a_value},

    {"grids", "2x2x2", smallest_grid},
    {"grids", "2x2x500", long_grid},
    {"grids", "spacing 1:1:1000", long_spacing},

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

std::span<const Case> all_cases() { return table; }

std::vector<Row> run(Lab& lab, std::span<const Case> cases,
                     const std::function<void(const Case&)>& progress) {
  std::vector<Row> all;
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
      all.push_back(std::move(row));
    }
  }
  return all;
}

}  // namespace crest::stability
