#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "presets/transfer_function.h"
#include "render/volume/grid_part.h"
#include "render/volume/tell_share.h"
#include "render/volume/voxels.h"

namespace crest {

/// A regular grid. Point (i,j,k) is at origin + spacing*(i,j,k); the box runs from the first to the last
/// point.
struct Grid {
  glm::ivec3 dims{2};     ///< points on each axis, at least 2
  glm::dvec3 spacing{1};  ///< > 0, world units
  glm::dvec3 origin{0};

  std::size_t point_count() const { return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z); }
  double smallest_spacing() const;
  glm::dvec3 box_min() const { return origin; }
  glm::dvec3 box_max() const { return origin + box_size(); }
  glm::dvec3 box_size() const { return spacing * glm::dvec3(dims - 1); }
  bool operator==(const Grid&) const = default;
};

/// float16: IEEE half precision.
enum class ScalarType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64, float16 };
std::size_t size_of(ScalarType type);
const char* name_of(ScalarType type);  ///< "uint8" ... "float64", "float16"
bool is_integer(ScalarType type);

/// What the finite voxels of a volume hold.
struct VolumeStatistics {
  ValueRange range{0, 0};  ///< of the finite voxels, or of more (widen_range); {0, 0} when there is none
  double mean = 0, variance = 0;
  std::size_t nan_count = 0, inf_count = 0;
  std::vector<std::uint64_t> histogram;  ///< equal bins over the range, the last one closed
  /// Between two finite neighbours along each axis.
  glm::dvec3 largest_difference{0};
  /// Between these grid points, both ends included, lie all empty cells; max < min when there is none.
  glm::ivec3 empty_min{0}, empty_max{-1};
  /// Values that regions have throughout, ascending: those of at least a thousandth of the cells, at all
  /// eight corners. Of labels and masks, and of a background.
  std::vector<float> plateaus;
};

/// Where a volume's voxels are, for other programs to read.
struct VolumeFile {
  std::string path;  ///< absolute; empty where there is none
  /// Of a file without a header.
  struct Raw {
    bool big_endian = false;
    std::uint64_t offset = 0;
  };
  std::optional<Raw> raw;
};

/// A scalar field on a grid, x fastest.
struct Volume {
  Grid grid;
  Voxels values;
  VolumeStatistics statistics;
  ScalarType file_type = ScalarType::float32;
  glm::dmat3 direction{1};  ///< the file's direction cosines, as columns: kept and shown, not applied
  /// Whether that is in a patient's coordinates, as DICOM has them: to the left, the back and the head.
  bool is_in_patient = false;
  std::string name;  ///< short, for titles
  VolumeFile file;
  std::optional<GridPart> part;  ///< that was taken of its file's grid; nothing where that is all of it
  std::string note;              ///< what reading it took, e.g. "first of 3 components"; or empty
  int frames = 1;                ///< time steps, or other frames, that its source has
  int frame = 0;                 ///< which of them it is, counted from 0

  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) +
           std::size_t(grid.dims.x) * (std::size_t(j) + std::size_t(grid.dims.y) * std::size_t(k));
  }
  float at(int i, int j, int k) const { return values[index(i, j, k)]; }
  bool has_empty_cells() const { return statistics.nan_count + statistics.inf_count > 0; }
};

/// Histogram bins that a volume carries with it.
inline constexpr int histogram_bins = 1024;

/// `values` are those of the grid's points, x fastest. On all cores; the result does not depend on how many.
VolumeStatistics compute_statistics(const Grid& grid, const Voxels& values, int bins = histogram_bins,
                                    const TellShare& progress = {});

/// The range of its finite values; nothing when there is none.
std::optional<ValueRange> finite_range(const Volume& volume);
/// The least range that has both.
ValueRange joined(ValueRange a, ValueRange b);
/// Widens the range of the statistics, with their histogram, to have this one, too: so that what depends on
/// the range is the same for all time steps.
void widen_range(Volume& volume, ValueRange range);

/// The greatest gradient, in value per world unit, that the trilinear field can have: within a cell each
/// partial derivative is a mean of the differences along four edges.
double largest_gradient(const Grid& grid, const VolumeStatistics& statistics);

/// Counts of the finite values within `range` (closed), in equal bins: for a histogram zoomed further in.
std::vector<std::uint64_t> histogram_of(const Voxels& values, ValueRange range, int bins);

}  // namespace crest
