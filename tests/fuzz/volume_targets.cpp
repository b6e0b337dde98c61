// Files of voxels, read by the code that the reader's program reads them with.
#include <algorithm>
#include <sstream>

#include "presets/error.h"
#include "render/files/load.h"
#include "render/readers/dicom_codestream.h"
#include "render/readers/dicom_pixels.h"
#include "render/readers/readers.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"
#include "tests/fuzz/volume_file.h"

namespace crest::fuzz {
namespace {

constexpr std::size_t voxel_bytes = 480;  // as many as the seeds' grids of the largest type take

template <FileForm form>
void read_file(std::string_view name, std::string_view input) {
  read_volume(write_scratch(name, input),
              [](const FileRequest& request) { return read_voxel_file(form, request); });
}

/// Voxels for the headers whose seeds name this file.
void write_voxels(std::string_view name) { write_scratch(name, std::string(voxel_bytes, 'v')); }

}  // namespace

void read_nrrd(std::string_view input) { read_file<FileForm::nrrd>("volume.nrrd", input); }
void read_nhdr(std::string_view input) {
  write_voxels("voxels.raw");
  read_file<FileForm::nrrd>("volume.nhdr", input);
}
void read_mha(std::string_view input) { read_file<FileForm::metaimage>("volume.mha", input); }
void read_mhd(std::string_view input) {
  write_voxels("voxels.raw");
  read_file<FileForm::metaimage>("volume.mhd", input);
}
void read_nifti(std::string_view input) { read_file<FileForm::nifti>("volume.nii", input); }
void read_analyze(std::string_view input) {
  write_voxels("pair.img");
  read_file<FileForm::nifti>("pair.hdr", input);
}
void read_mrc(std::string_view input) { read_file<FileForm::mrc>("volume.mrc", input); }
void read_vtk_file(std::string_view input) { read_file<FileForm::vtk>("volume.vtk", input); }
void read_vti_file(std::string_view input) { read_file<FileForm::vti>("volume.vti", input); }
void read_pvti_file(std::string_view input) {
  write_scratch("piece.vti", vti_seeds().front());
  read_file<FileForm::pvti>("volume.pvti", input);
}
void read_npy(std::string_view input) { read_file<FileForm::npy>("volume.npy", input); }

void read_raw_sidecar(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  write_scratch("volume.raw.json", input.substr(std::min(end + 1, input.size())));
  constexpr std::uint64_t memory = 16 << 20;
  const std::string source =
      write_scratch("volume.raw", std::string(voxel_bytes, 'v')) + "?" + std::string(input.substr(0, end));
  const Volume volume =
      load_volume(source, {.memory = memory, .asks = false, .stop = {}, .reader = {}, .patience = {}});
  require(volume.values.size() == volume.grid.point_count(), "there is a value for each point");
}

void read_dicom(std::string_view input) {
  const DicomStructure structure = read_dicom_structure(write_scratch("image.dcm", input));
  if (structure.pixels)
    require(structure.pixels->begin + structure.pixels->bytes <= input.size(), "pixels lie in the file");
}

void read_dicom_pixels(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  std::istringstream line{std::string(input.substr(0, end))};
  DicomImage image;
  DicomPlace place;
  std::size_t frames = 0;
  int numbers = 0;
  bool shares_colours = false;
  line >> image.columns >> image.rows >> image.samples >> image.bits >> image.bits_stored >> image.high_bit >>
      image.is_signed >> image.has_planes >> frames >> place.swapped >> numbers >> shares_colours;
  const auto is_in = [](std::uint64_t value, std::uint64_t most) { return value >= 1 && value <= most; };
  // What the walk over a file's elements lets through, and sizes that it holds against the pixels.
  if (!line || !is_in(image.columns, 65535) || !is_in(image.rows, 65535) || !is_in(frames, 1 << 20) ||
      !is_in(image.samples, 3) || !is_in(image.bits_stored, 64) || place.swapped > 2)
    throw Error("not how pixels lie");
  const std::string_view pixels = input.substr(std::min(end + 1, input.size()));
  image.file = write_scratch("pixels.dcm", pixels);
  place.bytes = pixels.size();
  read_codestream(std::as_bytes(std::span(pixels)));
  constexpr int run_lengths = 3;
  place.numbers = DicomNumbers(std::clamp(numbers, 0, 2));
  place.swapped = std::max<std::size_t>(place.swapped, 1);
  if (shares_colours) image.photometric = "YBR_FULL_422";
  if (numbers == run_lengths) frames = 1;
  const auto opened = numbers == run_lengths ? open_run_lengths(image, {{0, pixels.size()}})
                                             : open_plain_pixels(image, place);
  for (const std::size_t frame : {frames - 1, std::size_t(0)})
    require(
        opened->frame(frame).size() == image.columns * image.rows * image.samples * size_of(opened->type()),
        "a frame is whole");
}

}  // namespace crest::fuzz
