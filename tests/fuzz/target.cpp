#include "tests/fuzz/target.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "presets/error.h"
#include "presets/printable.h"
#include "tests/fuzz/target_list.h"

namespace crest::fuzz {
namespace {

constexpr Target list[] = {
    {"preset", read_preset, preset_seeds, 3000},
    {"export", read_exported, preset_seeds, 100},
    {"points", read_points, points_seeds, 4000},
    {"set", read_assignments, assignment_seeds, 2000},
    {"import", read_imported, import_seeds, 3000},
    {"number", read_typed_number, number_seeds, 20000},
    {"printable", read_printable, printable_seeds, 10000},
    {"query", read_query, query_seeds, 5000},
    {"builtin", read_builtin, builtin_seeds, 200},
    {"answer", read_answer, answer_seeds, 10000},
    {"recovery", read_recovery, recovery_seeds, 2000},
    {"settings", read_settings_file, settings_seeds, 4000},
    {"config", read_config, config_seeds, 5000},
    {"nrrd", read_nrrd, nrrd_seeds, 2000},
    {"nhdr", read_nhdr, nhdr_seeds, 2000},
    {"mha", read_mha, mha_seeds, 2000},
    {"mhd", read_mhd, mhd_seeds, 2000},
    {"nifti", read_nifti, nifti_seeds, 2000},
    {"analyze", read_analyze, analyze_seeds, 2000},
    {"mrc", read_mrc, mrc_seeds, 2000},
    {"vtk", read_vtk_file, vtk_seeds, 2000},
    {"vti", read_vti_file, vti_seeds, 2000},
    {"npy", read_npy, npy_seeds, 2000},
    {"raw", read_raw_sidecar, raw_seeds, 2000},
    {"tiff", read_tiff, tiff_seeds, 2000},
    {"png", read_png, png_seeds, 2000},
    {"pnm", read_pnm, pnm_seeds, 2000},
    {"pvti", read_pvti_file, pvti_seeds, 2000},
    {"dicom", read_dicom, dicom_seeds, 2000},
    {"dicom_pixels", read_dicom_pixels, dicom_pixel_seeds, 2000},
};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-+.", c) != nullptr;
}

}  // namespace

std::span<const Target> targets() { return list; }

void require(bool holds, std::string_view promise) {
  if (!holds) throw Find("it is not so that " + std::string(promise));
}

void run(const Target& target, std::string_view input) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  try {
    target.read(input);
  } catch (const Error& error) {
    require(*error.what() != 0, "an error says something");
    require(printable(error.what()) == error.what(), "an error is one line for people");
  }
}

std::vector<std::string> words_of(const std::vector<std::string>& seeds) {
  std::vector<std::string> words = {"-1",
                                    "0",
                                    "1e308",
                                    "1e-320",
                                    "1e999",
                                    "nan",
                                    "-inf",
                                    "127",
                                    "128",
                                    "255",
                                    "256",
                                    "32768",
                                    "65535",
                                    "2147483647",
                                    "2147483648",
                                    "4294967295",
                                    "4294967296",
                                    "9223372036854775807",
                                    "9223372036854775808",
                                    "-9223372036854775808",
                                    "18446744073709551615",
                                    "18446744073709551616",
                                    "null",
                                    "true",
                                    "[]",
                                    "{}",
                                    "\"\""};
  for (const char byte : {'\0', '\x01', '\x7f', '\x80', '\xff'})
    for (const std::size_t length : {1, 2, 4, 8}) words.emplace_back(length, byte);
  constexpr std::size_t longest = 40;
  for (const std::string& seed : seeds) {
    for (auto at = seed.begin(); at != seed.end();) {
      const auto end = std::find_if_not(at, seed.end(), is_word);
      if (const auto length = std::size_t(end - at); length > 0 && length <= longest)
        words.emplace_back(at, end);
      at = std::find_if(end, seed.end(), is_word);
    }
  }
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

}  // namespace crest::fuzz
