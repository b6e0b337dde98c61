#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/volume/volume.h"

namespace crest::test {

/// A folder of its own for each test, gone afterwards.
class FileTest : public testing::Test {
 protected:
  FileTest();
  ~FileTest() override;
  /// Writes a file in the folder and returns its path.
  std::string write(const std::string& name, const std::string& content) const;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

/// The one-line message of the Error that loading `source` throws; fails the test when it throws none.
std::string error_of(const std::string& source);
void expect_error(const std::string& source, const std::vector<std::string>& parts);

/// The volume that the small files hold: 5x4x3 points, spacing (1, 2, 3), origin (10, 20, 30).
inline constexpr int points = 60;
/// What is stored for point i: never symmetric in its bytes, negative in places where the type can be.
double stored_value(ScalarType type, int i);
/// The voxels as the file holds them.
std::string voxel_bytes(ScalarType type, std::endian endian, int count = points);
void append_value(std::string& bytes, double value, ScalarType type, std::endian endian);

/// A file of some format: its name, its content, and a second file where the voxels are apart.
struct Sample {
  std::string name, content;
  std::string data_name = {}, data = {};
};
Sample nrrd(ScalarType type, std::endian endian);
Sample nrrd_gzip(ScalarType type, std::endian endian);
Sample nrrd_detached(ScalarType type, std::endian endian);
Sample mha(ScalarType type, std::endian endian);
Sample mha_compressed(ScalarType type, std::endian endian);
Sample mhd(ScalarType type, std::endian endian);
Sample nifti(ScalarType type, std::endian endian);
Sample nifti_gzip(ScalarType type, std::endian endian);
Sample vtk(ScalarType type, std::endian endian);        ///< big-endian only
Sample vtk_ascii(ScalarType type, std::endian endian);  ///< of no byte order
Sample mrc(ScalarType type, std::endian endian);        ///< int8, int16, uint16 and float32 only

/// Numbers as they are stored, little-endian; and `bytes` with some of them, from `at` on, in place of
/// others.
std::string bytes_of(std::initializer_list<double> numbers, ScalarType type);
std::string with(std::string bytes, std::size_t at, const std::string& part);

/// A NIfTI-1 header with the sizes of the small volume.
std::string nifti_header(ScalarType type, std::endian endian, float slope, float intercept);
/// Of the second version: int16, little-endian, voxels at 544.
std::string nifti2_header();
std::string gzip(const std::string& bytes);

/// An element of a little-endian DICOM file that says its types, and a number as such an element's value.
std::string dicom_element(unsigned group, unsigned number, const std::string& vr, std::string value);
std::string dicom_us(int value);
/// Its compressed pixels: an empty table of offsets, then the fragments.
std::string dicom_fragments(const std::vector<std::string>& parts);
/// Such a file to its first elements of group 8.
std::string dicom_head(const std::string& sop_class, const std::string& instance,
                       const std::string& syntax = "1.2.840.10008.1.2.1");
/// One DICOM slice of 16-bit signed pixels, columns x rows, at height z.
std::string dicom_slice(int columns, int rows, double z, int number, const std::vector<std::int16_t>& pixels,
                        const std::string& slope = "1", const std::string& intercept = "0",
                        const std::string& series = "1.2.3");

}  // namespace crest::test
