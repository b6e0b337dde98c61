#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "presets/error.h"
#include "render/readers/readers.h"
#include "render/readers/voxel_reader.h"
#include "render/readers/vti_file.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// The volume that `open` has the values of. Files of so many bytes hold them, of which so many are held in
/// memory.
Volume read_grid(const FileRequest& request, const VoxelHeader& header, std::uint64_t file_bytes,
                 std::uint64_t held_bytes, const std::function<std::unique_ptr<ByteStream>()>& open) {
  const glm::u64vec3 dims = header.layout.dims;
  const std::uint64_t promised =
      checked_product({dims.x, dims.y, dims.z, header.layout.components, size_of(header.type)}).value_or(0);
  if (promised / greatest_inflation > file_bytes)  // text takes a fourth at least
    throw Error(fmt::format("{}: its extent promises {} bytes of the array, and its files have {}",
                            request.name(), promised, file_bytes));
  std::unique_ptr<ByteStream> values;
  const std::size_t value_size = size_of(header.type);
  const auto read = [&](std::uint64_t first, std::span<std::byte> out) {
    if (!values) values = open();
    values->read(first * value_size, out);
  };
  // What is passed over is inflated, too, a block at a time.
  Volume volume = read_voxels(request.reading_also(promised), header, ",array", read, held_bytes);
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
    if (joined(extent, whole) != whole) throw Error(fmt::format("{} is not within the whole extent", name));
    const fs::path path = file.path.parent_path() / source;
    std::error_code fault;
    if (!fs::is_regular_file(path, fault))
      throw Error(fmt::format("{} is in {}, which is not there", name, path.string()));
    pieces.push_back({extent, path});
  }
  return pieces;
}

/// Of files that share a layer, which are read side by side, each holds its text, at most so much of it.
std::uint64_t held_at_once(const std::vector<PieceFile>& pieces, std::uint64_t most_of_each) {
  std::map<double, std::int64_t> changes;  // by layer
  for (const PieceFile& piece : pieces) {
    const auto bytes = std::int64_t(std::min<std::uint64_t>(fs::file_size(piece.path), most_of_each));
    changes[piece.extent[4]] += bytes;
    changes[piece.extent[5] + 1] -= bytes;
  }
  std::int64_t held = 0, most = 0;
  for (const auto& [layer, change] : changes) most = std::max(most, held += change);
  return std::uint64_t(most);
}

std::shared_ptr<const VtiFile> open_piece_file(const std::string& name, const PieceFile& piece,
                                               std::uint64_t most_bytes) {
  return open_vti(fmt::format("{}: {}", name, piece.path.string()), piece.path, "ImageData", most_bytes);
}

/// A file of a piece may hold more points than the piece: those that it shares with others.
VtiSource open_piece(const std::string& name, const PieceFile& piece, const VtiChoice& choice,
                     std::uint64_t most_bytes) {
  const auto file = open_piece_file(name, piece, most_bytes);
  const std::vector<VtiPiece> inner = vti_pieces(*file, choice);
  const VtiExtent whole = joined(inner);
  if (joined(whole, piece.extent) != whole)
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
  const VtiExtent whole = joined(pieces);
  if (whole != vti_extent(file->name, file->image, "WholeExtent", whole))
    add_note(header.note, "the file holds a part of its whole extent");
  if (pieces.size() > 1) add_note(header.note, fmt::format("joined from {} pieces", pieces.size()));
  take_vti_geometry(*file, whole, choice, header);
  return read_grid(request, header, fs::file_size(request.path), file->xml.capacity(),
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
  const auto first = open_piece_file(name, pieces[0], most_bytes);
  constexpr std::uint64_t a_head = std::uint64_t(1) << 17;
  const std::uint64_t held =
      file->xml.capacity() + held_at_once(pieces, first->appended ? a_head : most_bytes);
  return read_grid(request.reading_also(bytes), header, bytes, held, [&] {
    std::vector<VtiPart> parts;
    for (const PieceFile& piece : pieces)
      parts.push_back({place_of(piece.extent, whole), dims_of(piece.extent, choice.of_cells),
                       [&] { return open_piece(name, piece, choice, most_bytes); }});
    return std::make_unique<VtiGrid>(name, header.layout.dims, choice.components * size_of(choice.type),
                                     std::move(parts));
  });
}

}  // namespace crest
