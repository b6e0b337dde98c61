#pragma once

#include <array>
#include <vector>

#include "render/studies/knoll/scene.h"

namespace crest {

/// The pictures of the paper are some 1024 pixels wide. Steps depend on s_k times a pixel's size, so this s_k
/// gives a picture of another width the steps that 4 gives those.
inline constexpr int paper_width = 1024;
double s_k_of_paper(int width);

/// Table 1's ways to render, with differential sampling: "post" first, "xor-paper", "xor", "preintegrated",
/// and "xor-paper-all": as published, no macrocell skipped.
std::vector<Variant> table1_variants(double s_k);

/// Engel's table holds one step only, so its steps are equal: this one's step comes in addition.
Variant preintegrated_table_variant(double step);

/// Beside those, what the figures of a scene show: fig. 4's surfaces alone; fig. 5's single peaks (a), peaks
/// with 16 times the opacity (d) and surfaces alone (f).
Variant surfaces_variant(double s_k);
Variant single_peak_variant(double s_k);
Variant magnified_variant(double s_k);

/// Table 2's columns: "post", "xor", "xor-bspline"; and fig. 7's "post-bspline". Their sampling comes in
/// addition.
std::vector<Variant> sampling_methods();
Variant post_bspline_method();

/// Bins on each axis of a table.
inline constexpr std::array<int, 7> studied_bins{16, 32, 64, 128, 256, 512, 1024};
/// "peaks-16" to "peaks-1024", as published, and "preintegrated-16" to "preintegrated-1024".
std::vector<Variant> bins_variants(double s_k);

}  // namespace crest
