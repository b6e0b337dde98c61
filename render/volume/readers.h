#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/volume/query.h"
#include "render/volume/volume.h"

namespace crest {

/// What load_volume asks of a reader. The path is there, and readable.
struct Request {
  std::filesystem::path path;
  Query query;
  std::uint64_t memory = 0;  ///< bytes that reading may take

  std::string name() const { return path.string(); }  ///< what errors call it
};

// Each fills the grid, the values, the file's type, the direction and the note; load_volume does the rest.
Volume read_raw(const Request& request);
Volume read_nrrd(const Request& request);
Volume read_metaimage(const Request& request);
Volume read_nifti(const Request& request);
Volume read_mrc(const Request& request);
Volume read_vtk(const Request& request);
Volume read_dicom_file(const Request& request);
Volume read_dicom_series(const Request& request);  ///< of the folder's DICOM files
Volume read_image_pages(const Request& request);   ///< of one file
Volume read_image_folder(const Request& request);  ///< of the images in it, sorted by name

/// Whether the folder holds a DICOM file, or image files.
bool has_dicom(const std::filesystem::path& folder);
bool has_images(const std::filesystem::path& folder);

/// A lower-case extension with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace crest
