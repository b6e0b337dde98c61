#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "render/readers/readers.h"
#include "render/readers/voxel_reader.h"
#include "render/readers/vti_file.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// 0 where they cannot be counted.
std::uint64_t bytes_of_array(const VoxelHeader& header) {
  const glm::u64vec3 dims = header.layout.dims;
  const auto points = checked_product(dims.x * dims.y, dims.z);
  const auto values = points ? checked_product(*points, header.layout.components) : points;
  return values ? checked_product(*values, size_of(header.type)).value_or(0) : 0;
}

/// The volume that `open` has the values of. Files of so many bytes hold them.
Volume read_grid(const FileRequest& request, const VoxelHeader& header, std::uint64_t file_bytes,
                 const std::function<std::unique_ptr<ByteStream>()>& open) {
  constexpr std::uint64_t greatest_inflation = 1032;  // of the deflate format; text takes a fourth at least
  const std::uint64_t promised = bytes_of_array(header);
  if (promised / greatest_inflation > file_bytes)
    throw Error(fmt::format("{}: its extent promises {} bytes of the array, and its files have {}",
                            request.name(), promised, file_bytes));
  std::unique_ptr<ByteStream> values;
  const std::size_t value_size = size_of(header.type);
  const auto read = [&](std::uint64_t first, std::span<std::byte> out) {
    if (!values) values = open();
    values->read(first * value_size, out);
  };
  // What is passed over is inflated, too, a block at a time.
  Volume volume = read_voxels(request.reading_also(promised), header, ",array", read, 0);
  if (values) values->finish();
  return volume;
}

/// A piece of a parallel file, in a file of its own.
struct PieceFile {
  VtiExtent extent{};
  fs::path path;
};

std::vector<PieceFile> piece_files(const VtiFile& file, const VtiExtent& whole) {
  std::vector<PieceFile> pieces;
  for (const pugi::xml_node piece : file.image.children("Piece")) {
    const std::string source = piece.attribute("Source").value();
    const std::string name = fmt::format("{}: its piece {}", file.name, pieces.size() + 1);
    if (source.empty()) throw Error(fmt::format("{} names no file", name));
    const VtiExtent extent = vti_extent(name, piece, "Extent", whole);
    if (joined({extent, whole}) != whole) throw Error(fmt::format("{} is not within the whole extent", name));
    const fs::path path = file.path.parent_path() / source;
    std::error_code fault;
    if (!fs::is_regular_file(path, fault))
      throw Error(fmt::format("{} is in {}, which is not there", name, path.string()));
    pieces.push_back({extent, path});
  }
  return pieces;
}

/// A file of a piece may hold more points than the piece: those that it shares with others.
VtiSource open_piece(const std::string& name, const PieceFile& piece, const VtiChoice& choice,
                     std::uint64_t most_bytes) {
  const auto file =
      open_vti(fmt::format("{}: {}", name, piece.path.string()), piece.path, "ImageData", most_bytes);
  const std::vector<VtiPiece> inner = vti_pieces(*file, choice);
  std::vector<VtiExtent> extents;
  for (const VtiPiece& one : inner) extents.push_back(one.extent);
  const VtiExtent whole = joined(extents);
  if (joined({whole, piece.extent}) != whole)
    throw Error(
        fmt::format("{}: it has other points than its piece of {} is said to have", file->name, name));
  return {open_vti_grid(file, inner, choice), dims_of(whole, choice.of_cells), place_of(piece.extent, whole)};
}

}  // namespace

Volume read_vti(const FileRequest& request) {
  const auto file = open_vti(request.name(), request.path, "ImageData", request.reading.memory / 4);
  VoxelHeader header;
  const VtiChoice choice = choose_vti_array(request, "", file->image.child("Piece"), header.note);
  const std::vector<VtiPiece> pieces = vti_pieces(*file, choice);
  std::vector<VtiExtent> extents;
  for (const VtiPiece& piece : pieces) extents.push_back(piece.extent);
  const VtiExtent whole = joined(extents);
  if (whole != vti_extent(file->name, file->image, "WholeExtent", whole))
    add_note(header.note, "the file holds a part of its whole extent");
  if (pieces.size() > 1) add_note(header.note, fmt::format("joined from {} pieces", pieces.size()));
  take_vti_geometry(*file, whole, choice, header);
  return read_grid(request, header, fs::file_size(request.path),
                   [&] { return open_vti_grid(file, pieces, choice); });
}

Volume read_pvti(const FileRequest& request) {
  const std::string name = request.name();
  const std::uint64_t most_bytes = request.reading.memory / 4;
  const auto file = open_vti(name, request.path, "PImageData", most_bytes);
  VoxelHeader header;
  const VtiChoice choice = choose_vti_array(request, "P", file->image, header.note);
  if (!file->image.attribute("WholeExtent")) throw Error(fmt::format("{}: it says no WholeExtent", name));
  const VtiExtent whole = vti_extent(name, file->image, "WholeExtent", {});
  const std::vector<PieceFile> pieces = piece_files(*file, whole);
  add_note(header.note, fmt::format("joined from {} files", pieces.size()));
  take_vti_geometry(*file, whole, choice, header);
  std::uint64_t bytes = 0;
  for (const PieceFile& piece : pieces) bytes += fs::file_size(piece.path);
  return read_grid(request.reading_also(bytes), header, bytes, [&] {
    std::vector<VtiPart> parts;
    for (const PieceFile& piece : pieces)
      parts.push_back({place_of(piece.extent, whole), dims_of(piece.extent, choice.of_cells),
                       [&] { return open_piece(name, piece, choice, most_bytes); }});
    return std::make_unique<VtiGrid>(name, header.layout.dims, choice.components * size_of(choice.type),
                                     std::move(parts));
  });
}

}  // namespace crest
