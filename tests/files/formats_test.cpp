#include <fmt/core.h>

#include <glm/geometric.hpp>

#include "files.h"
#include "presets/error.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"
#include "render/volume/random.h"
#include "render/volume/take_part.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;
constexpr ScalarType all_types[] = {uint8, int8,   uint16, int16,   uint32,
                                    int32, uint64, int64,  float32, float64};

struct Format {
  const char* name;
  Sample (*sample)(ScalarType, endian);
  std::vector<ScalarType> types{std::begin(all_types), std::end(all_types)};
  std::vector<endian> orders{endian::little, endian::big};
};

const Format formats[] = {
    {"nrrd", nrrd},
    {"nrrd_gzip", nrrd_gzip},
    {"nrrd_detached", nrrd_detached},
    {"mha", mha},
    {"mha_compressed", mha_compressed},
    {"mhd", mhd},
    {"nifti", nifti},
    {"nifti_gzip", nifti_gzip},
    {"vtk", vtk, {std::begin(all_types), std::end(all_types)}, {endian::big}},
    {"vtk_ascii", vtk_ascii, {uint8, int8, uint16, int16, uint32, int32, float32, float64}, {endian::big}},
    {"mrc", mrc, {int8, int16, uint16, float32}},
};

/// The name that ctest shows.
void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

class EveryFormat : public FileTest, public testing::WithParamInterface<Format> {
 protected:
  std::string write_sample(const Sample& sample) const {
    if (!sample.data_name.empty()) write(sample.data_name, sample.data);
    return write(sample.name, sample.content);
  }
};

void expect_small_volume(const Volume& volume, ScalarType type, bool nifti_axes) {
  EXPECT_EQ(volume.file_type, type) << name_of(volume.file_type);
  EXPECT_EQ(volume.grid.dims, glm::ivec3(5, 4, 3));
  EXPECT_LT(glm::distance(volume.grid.spacing, glm::dvec3(1, 2, 3)), 1e-6);
  const glm::dvec3 origin = nifti_axes ? glm::dvec3(-10, -20, 30) : glm::dvec3(10, 20, 30);
  EXPECT_LT(glm::distance(volume.grid.origin, origin), 1e-6);
  ASSERT_EQ(volume.values.size(), std::size_t(points));
  const bool is_kept = is_integer(type) && size_of(type) <= 2;
  EXPECT_EQ(volume.values.are_floats(), !is_kept) << name_of(type);
  EXPECT_EQ(volume.values.byte_count(), std::size_t(points) * (is_kept ? size_of(type) : sizeof(float)));
  for (int i = 0; i < points; ++i)
    ASSERT_EQ(volume.values[std::size_t(i)], float(stored_value(type, i))) << i;
}

TEST_P(EveryFormat, IsReadInEveryTypeAndByteOrder) {
  const Format& format = GetParam();
  const bool nifti_axes = std::string_view(format.name).starts_with("nifti");
  for (const ScalarType type : format.types) {
    for (const endian order : format.orders) {
      SCOPED_TRACE(fmt::format("{} {}", name_of(type), order == endian::big ? "big" : "little"));
      expect_small_volume(load_volume(write_sample(format.sample(type, order))), type, nifti_axes);
    }
  }
}

TEST_P(EveryFormat, OneByteShortIsAnError) {
  const Format& format = GetParam();
  for (const ScalarType type : {int16, float32}) {
    Sample sample = format.sample(type, format.orders.front());
    std::string& last = sample.data_name.empty() ? sample.content : sample.data;
    // Text can lose its last line end, and a digit of its last number; not that number.
    last.resize(format.sample == vtk_ascii ? last.find_last_of(' ') : last.size() - 1);
    SCOPED_TRACE(error_of(write_sample(sample)));
  }
}

TEST_P(EveryFormat, HalfOfTheHeaderIsAnError) {
  Sample sample = GetParam().sample(int16, GetParam().orders.front());
  for (const std::size_t length : {std::size_t(0), std::size_t(3), std::size_t(40), std::size_t(90)}) {
    sample.content.resize(std::min(length, sample.content.size()));
    expect_error(write_sample(sample), {path(sample.name)});
  }
}

/// A header with a few bytes changed is read or refused; it never ends the program.
TEST_P(EveryFormat, DamagedHeadersAreReadOrRefused) {
  const Sample sample = GetParam().sample(int16, GetParam().orders.front());
  const std::size_t header = sample.content.size() - (sample.data_name.empty() ? points * 2 : 0);
  Random random(7);
  const auto below = [&](std::size_t n) { return std::size_t(random.uniform(0, double(n))); };
  for (int round = 0; round < 60; ++round) {
    Sample damaged = sample;
    for (std::size_t i = 0, changes = 1 + below(3); i < changes; ++i) {
      damaged.content[below(std::min(header, damaged.content.size()))] =
          round % 2 == 0 ? char(below(256)) : char('0' + below(10));
    }
    try {
      load_volume(write_sample(damaged), {.memory = 1u << 24});
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

TEST_P(EveryFormat, UpperCaseSymlinksAndOddNamesAreRead) {
  const Sample sample = GetParam().sample(int16, GetParam().orders.front());
  const std::string plain = write_sample(sample), extension = sample.name.substr(sample.name.find('.'));
  std::string upper = extension;
  for (char& c : upper) c = char(std::toupper(c));
  const Voxels expected = load_volume(plain).values;
  for (const std::string& name : {"UPPER" + upper, "what is this?" + extension, "a?b=c&d" + extension}) {
    EXPECT_EQ(load_volume(write(name, sample.content)).values, expected) << name;
  }
  std::filesystem::create_symlink(plain, path("link" + extension));
  EXPECT_EQ(load_volume(path("link" + extension)).values, expected);
}

TEST_P(EveryFormat, TooLittleMemoryIsRefused) {
  const std::string file = write_sample(GetParam().sample(int16, GetParam().orders.front()));
  EXPECT_THROW(load_volume(file, {.memory = points * sizeof(std::int16_t)}), ChoiceNeeded);
  EXPECT_NO_THROW(load_volume(file, {.memory = points * 64}));
}

/// As NumPy cuts: values[0:3:2, :, 1:5:2]; every format, also where the values are text or compressed.
TEST_P(EveryFormat, PartsAreReadAlone) {
  const Format& format = GetParam();
  for (const ScalarType type : {int16, float32}) {
    const std::string file = write_sample(format.sample(type, format.orders.back()));
    const Volume whole = load_volume(file), part = load_volume(file + "?crop=1:5,:,:3&stride=2,1,2");
    ASSERT_EQ(part.grid.dims, glm::ivec3(2, 4, 2));
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 2; ++i)
          ASSERT_EQ(part.at(i, j, k), whole.at(1 + 2 * i, j, 2 * k)) << i << " " << j << " " << k;
    const glm::dvec3 spacing = whole.grid.spacing;
    EXPECT_EQ(part.grid.spacing, spacing * glm::dvec3(2, 1, 2));
    EXPECT_EQ(part.grid.origin, whole.grid.origin + spacing * glm::dvec3(1, 0, 0));
    EXPECT_EQ(part.file_type, type);
    EXPECT_FALSE(whole.part);
    ASSERT_TRUE(part.part);
    EXPECT_EQ(part.part->full, glm::u64vec3(5, 4, 3));
    EXPECT_EQ(full_grid(part), whole.grid);
    EXPECT_TRUE(
        part.note.starts_with("every 2nd point on x, every 2nd point on z of 5x4x3, of the box "
                              "1:5,0:4,0:3"))
        << part.note;
  }
}

INSTANTIATE_TEST_SUITE_P(Volume, EveryFormat, testing::ValuesIn(formats),
                         [](const auto& format) { return std::string(format.param.name); });

class NiftiTest : public FileTest {};

TEST_F(NiftiTest, SlopeAndInterceptAreApplied) {
  for (const endian order : {endian::little, endian::big}) {
    for (const ScalarType type : {uint8, int16, int32, float32, float64}) {
      const std::string file =
          write("scaled.nii", nifti_header(type, order, 0.5f, -10) + voxel_bytes(type, order));
      const Volume volume = load_volume(file);
      EXPECT_EQ(volume.file_type, type);
      EXPECT_NE(volume.note.find("0.5"), std::string::npos) << volume.note;
      for (int i = 0; i < points; ++i) {
        const double exact = stored_value(type, i) * 0.5 - 10;
        EXPECT_NEAR(volume.values[std::size_t(i)], exact, 1e-6 * std::abs(exact)) << name_of(type);
      }
    }
  }
}

TEST_F(NiftiTest, SlopeOfOneStillAddsTheIntercept) {
  const std::string header = nifti_header(int16, endian::little, 1, 7);
  const Volume volume = load_volume(write("shifted.nii", header + voxel_bytes(int16, endian::little)));
  for (int i = 0; i < points; ++i)
    EXPECT_EQ(volume.values[std::size_t(i)], float(stored_value(int16, i) + 7));
}

class MrcTest : public FileTest {};

TEST_F(MrcTest, BytesOfOldFilesAreUnsigned) {
  Sample sample = mrc(int8, endian::little);
  sample.content.replace(108, 4, std::string(4, '\0'));  // no version: before MRC2014
  const Volume volume = load_volume(write("old.mrc", sample.content));
  EXPECT_EQ(volume.file_type, uint8);
  EXPECT_GE(volume.statistics.range.min, 0);
}

}  // namespace
}  // namespace crest::test
