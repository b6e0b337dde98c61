#pragma once

#include "presets/exchange/importers.h"

namespace crest {

// Each format's two functions, as Importer describes them, in files of their own: import_*.cpp.

bool is_color_map_json(std::string_view content, std::string_view extension);
std::vector<Imported> read_color_map_json(std::string_view content);

bool is_slicer_json(std::string_view content, std::string_view extension);
std::vector<Imported> read_slicer_json(std::string_view content);
bool is_slicer_vp(std::string_view content, std::string_view extension);
std::vector<Imported> read_slicer_vp(std::string_view content);
bool is_slicer_presets(std::string_view content, std::string_view extension);
std::vector<Imported> read_slicer_presets(std::string_view content);

bool is_paraview_xml(std::string_view content, std::string_view extension);
std::vector<Imported> read_paraview_xml(std::string_view content);
bool is_inviwo(std::string_view content, std::string_view extension);
std::vector<Imported> read_inviwo(std::string_view content);

bool is_1dt(std::string_view content, std::string_view extension);
std::vector<Imported> read_1dt(std::string_view content);
bool is_csv(std::string_view content, std::string_view extension);
std::vector<Imported> read_csv(std::string_view content);

}  // namespace crest
