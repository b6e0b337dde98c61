#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "render/files/file_request.h"
#include "render/readers/voxel_header.h"
#include "render/readers/vti_data.h"
#include "render/readers/vti_pieces.h"

namespace crest {

/// Where the values of an array may begin in the text.
struct VtiLine {
  std::size_t begin = 0, line = 1;
};

/// A VTK XML file up to its appended data, which is not read.
struct VtiFile {
  std::filesystem::path path;
  std::string name;                            ///< begins the errors
  std::string xml;                             ///< as the parser leaves it, which holds the document in it
  std::vector<VtiLine> arrays = {};            ///< where their tags end, in the text as it was
  std::optional<std::uint64_t> appended = {};  ///< where that data begins
  bool appended_is_base64 = false;
  pugi::xml_document document = {};
  VtiCoding coding = {};
  pugi::xml_node image = {};  ///< which holds the pieces, one at least
};
/// `type`: "ImageData" or "PImageData". Throws Error for what is no such file, or longer than `most_bytes`.
std::shared_ptr<const VtiFile> open_vti(const std::string& name, const std::filesystem::path& path,
                                        const std::string& type, std::uint64_t most_bytes);

/// The array that becomes a volume.
struct VtiChoice {
  std::string name;
  bool of_cells = false;
  ScalarType type = ScalarType::float32;
  std::uint64_t components = 1;
};
/// By what `parent` lists, whose elements have `prefix` before their names. As choose_array().
VtiChoice choose_vti_array(const FileRequest& request, const std::string& prefix, pugi::xml_node parent,
                           std::string& note);

/// Of an element; `fallback` where it says none. Throws Error where it is none.
VtiExtent vti_extent(const std::string& name, pugi::xml_node element, const char* key,
                     const VtiExtent& fallback);
/// Layout, spacing, origin and direction of a grid of this extent, and that its values are the machine's.
void take_vti_geometry(const VtiFile& file, const VtiExtent& extent, const VtiChoice& choice,
                       VoxelHeader& header);

/// What each piece of a file has of the array, which has to be alike in all.
struct VtiPiece {
  VtiExtent extent{};
  pugi::xml_node array;
};
std::vector<VtiPiece> vti_pieces(const VtiFile& file, const VtiChoice& choice);
/// The least extent that holds all of them. There is one at least.
VtiExtent joined(const std::vector<VtiPiece>& pieces);
/// The values of all pieces together: of the extent that holds them.
std::unique_ptr<ByteStream> open_vti_grid(const std::shared_ptr<const VtiFile>& file,
                                          const std::vector<VtiPiece>& pieces, const VtiChoice& choice);

}  // namespace crest
