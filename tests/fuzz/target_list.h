#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crest::fuzz {

// What targets read, and their seeds. Texts first.
void read_preset(std::string_view input);
std::vector<std::string> preset_seeds();
void read_exported(std::string_view input);  ///< a preset, written for all other programs
void read_points(std::string_view input);    ///< of the clipboard
std::vector<std::string> points_seeds();
void read_assignments(std::string_view input);  ///< of --set, one a line
std::vector<std::string> assignment_seeds();
void read_imported(std::string_view input);  ///< a file's name in the first line, then its content
std::vector<std::string> import_seeds();
void read_typed_number(std::string_view input);
std::vector<std::string> number_seeds();
void read_printable(std::string_view input);
std::vector<std::string> printable_seeds();
void read_query(std::string_view input);
std::vector<std::string> query_seeds();
void read_builtin(std::string_view input);
std::vector<std::string> builtin_seeds();
void read_answer(std::string_view input);  ///< of the reader's program, one line
std::vector<std::string> answer_seeds();
void read_recovery(std::string_view input);
std::vector<std::string> recovery_seeds();
void read_settings_file(std::string_view input);
std::vector<std::string> settings_seeds();
void read_config(std::string_view input);
std::vector<std::string> config_seeds();

// Files. Detached headers have a file of voxels beside them.
void read_nrrd(std::string_view input);
void read_nhdr(std::string_view input);
void read_mha(std::string_view input);
void read_mhd(std::string_view input);
void read_nifti(std::string_view input);
void read_analyze(std::string_view input);
void read_mrc(std::string_view input);
void read_vtk_file(std::string_view input);
void read_vti_file(std::string_view input);
void read_pvti_file(std::string_view input);
void read_npy(std::string_view input);
void read_raw_sidecar(std::string_view input);  ///< the query in the first line, then the sidecar
void read_tiff(std::string_view input);
void read_png(std::string_view input);
void read_pnm(std::string_view input);
void read_dicom(std::string_view input);         ///< its elements alone: what GDCM does is GDCM's
void read_dicom_pixels(std::string_view input);  ///< how they lie in the first line, then a frame or more
std::vector<std::string> nrrd_seeds();
std::vector<std::string> nhdr_seeds();
std::vector<std::string> mha_seeds();
std::vector<std::string> mhd_seeds();
std::vector<std::string> nifti_seeds();
std::vector<std::string> analyze_seeds();
std::vector<std::string> mrc_seeds();
std::vector<std::string> vtk_seeds();
std::vector<std::string> vti_seeds();
std::vector<std::string> pvti_seeds();
std::vector<std::string> npy_seeds();
std::vector<std::string> raw_seeds();
std::vector<std::string> tiff_seeds();
std::vector<std::string> png_seeds();
std::vector<std::string> pnm_seeds();
std::vector<std::string> dicom_seeds();
std::vector<std::string> dicom_pixel_seeds();

}  // namespace crest::fuzz
