#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#include "files.h"
#include "render/files/file_request.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

/// A file of 24x16 pixels: value (x, y, channel) is 40 + 5 x + 3 y + 20 channel.
std::string jpeg(int channels, J_COLOR_SPACE space) {
  jpeg_compress_struct state{};
  jpeg_error_mgr faults{};
  state.err = jpeg_std_error(&faults);
  jpeg_create_compress(&state);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&state, &bytes, &size);
  state.image_width = 24;
  state.image_height = 16;
  state.input_components = channels;
  state.in_color_space = space;
  jpeg_set_defaults(&state);
  jpeg_set_quality(&state, 100, TRUE);
  jpeg_start_compress(&state, TRUE);
  for (int y = 0; y < 16; ++y) {
    std::vector<JSAMPLE> line;
    for (int x = 0; x < 24; ++x)
      for (int channel = 0; channel < channels; ++channel)
        line.push_back(JSAMPLE(40 + 5 * x + 3 * y + 20 * channel));
    JSAMPROW row = line.data();
    jpeg_write_scanlines(&state, &row, 1);
  }
  jpeg_finish_compress(&state);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&state);
  std::free(bytes);
  return file;
}

class Jpeg : public FileTest {
 protected:
  Jpeg() { std::filesystem::create_directory(path("stack")); }
  /// A folder of two such images.
  std::string stack_of(const std::string& first, const std::string& second) const {
    write("stack/1.jpg", first);
    write("stack/2.jpeg", second);
    return path("stack");
  }
};

TEST_F(Jpeg, HasTheValuesThatOthersSee) {
  for (const auto& [channels, space] : {std::pair(1, JCS_GRAYSCALE), std::pair(3, JCS_RGB)}) {
    const std::string file = jpeg(channels, space), folder = stack_of(file, file);
    const auto input = OIIO::ImageInput::open(path("stack/1.jpg"));
    ASSERT_TRUE(input);
    std::vector<unsigned char> wanted(24 * 16 * std::size_t(channels));
    ASSERT_TRUE(input->read_image(0, 0, 0, channels, OIIO::TypeUInt8, wanted.data()));
    const std::string query = channels == 3 ? "?component=1" : "";
    const std::size_t channel = channels == 3 ? 1 : 0;
    const Volume volume = load_volume(folder + query);
    EXPECT_EQ(volume.file_type, ScalarType::uint8);
    ASSERT_EQ(volume.grid.dims, glm::ivec3(24, 16, 2));
    for (std::size_t i = 0; i < 24 * 16; ++i)
      ASSERT_EQ(volume.values[i], wanted[i * std::size_t(channels) + channel]) << i;
    EXPECT_NEAR(volume.at(10, 8, 1), 40 + 50 + 24 + 20 * float(channel), 3);
  }
}

TEST_F(Jpeg, InksAreComponentsAsTheyAreStored) {
  const std::string file = jpeg(4, JCS_CMYK), folder = stack_of(file, file);
  expect_error(folder, {"4 components"});
  const Volume volume = load_volume(folder + "?component=3");
  EXPECT_NEAR(volume.at(10, 8, 1), 40 + 50 + 24 + 60, 3);
  EXPECT_NE(volume.note.find("cyan, magenta, yellow and black"), std::string::npos) << volume.note;
}

TEST_F(Jpeg, OneThatLacksPixelsIsNoImage) {
  const std::string whole = jpeg(1, JCS_GRAYSCALE);
  for (const std::size_t bytes : {whole.size() - 2, whole.size() * 4 / 5})
    expect_error(stack_of(whole, whole.substr(0, bytes)), {path("stack/2.jpeg"), "page 1", "ends early"});
  expect_error(stack_of(whole, whole.substr(0, 100)), {path("stack/2.jpeg"), "not an image"});
  expect_error(stack_of(whole, "no image"), {path("stack/2.jpeg"), "not an image"});
}

TEST(PageModule, LoadsFewLibraries) {
  const std::string module = (reader_program().parent_path() / "libcrest_page_files.so").string();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> list(
      ::popen(fmt::format("ldd '{}'", module).c_str(), "r"), ::pclose);
  std::string text(1 << 16, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), list.get()));
  EXPECT_NE(text.find("libtiff"), std::string::npos);
  EXPECT_EQ(text.find("OpenImageIO"), std::string::npos) << text;
  EXPECT_LT(std::ranges::count(text, '\n'), 40);
}

/// Two frames of 24 x `rows` pixels of so many bits, as the DICOM file says that holds these ones.
std::string in_dicom(const std::string& frame, int bits = 8, int rows = 16, int is_signed = 0) {
  const auto element = dicom_element;
  const auto even = frame + std::string(frame.size() % 2, '\0');
  return dicom_head("1.2.840.10008.5.1.4.1.1.7.2", "1.2.3.4", "1.2.840.10008.1.2.4.51") +
         element(0x28, 2, "US", dicom_us(1)) + element(0x28, 4, "CS", "MONOCHROME2") +
         element(0x28, 8, "IS", "2") + element(0x28, 0x10, "US", dicom_us(rows)) +
         element(0x28, 0x11, "US", dicom_us(24)) + element(0x28, 0x100, "US", dicom_us(bits)) +
         element(0x28, 0x101, "US", dicom_us(bits)) + element(0x28, 0x102, "US", dicom_us(bits - 1)) +
         element(0x28, 0x103, "US", dicom_us(is_signed)) + dicom_fragments({even, even});
}

TEST_F(Jpeg, InDicomIsWhatItsHeaderSays) {
  std::string frame = jpeg(1, JCS_GRAYSCALE);
  for (const int bits : {8, 16}) {
    const Volume volume = load_volume(write("right.dcm", in_dicom(frame, bits)));
    EXPECT_EQ(volume.file_type, ScalarType::uint8);
    EXPECT_NEAR(volume.at(10, 8, 1), 40 + 50 + 24, 3) << bits;
  }
  expect_error(write("signed.dcm", in_dicom(frame, 16, 16, 1)), {"1 x 16 bits", "24x16 of 1 x 8"});
  expect_error(write("rows.dcm", in_dicom(frame, 8, 12)), {"24x12", "24x16"});
  const std::size_t bits = frame.find("\xff\xc0") + 4;
  ASSERT_EQ(frame[bits], 8);
  frame[bits] = 12;
  expect_error(write("12.dcm", in_dicom(frame)), {"1 x 8 bits", "1 x 12"});
}

}  // namespace
}  // namespace crest::test
