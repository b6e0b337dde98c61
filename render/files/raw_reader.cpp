#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <limits>
#include <optional>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "render/files/geometry.h"
#include "render/files/open_choice.h"
#include "render/files/raw_layout.h"
#include "render/files/raw_reader.h"
#include "render/files/read_slabs.h"
#include "render/volume/memory.h"
#include "render/volume/voxel_store.h"

namespace crest {
namespace {

constexpr std::string_view keys = "size,type,spacing,origin,endian,offset,crop,stride,subtract";
constexpr std::string_view hint =
    "say them as ?size=AxBxC&type=uint8, in a sidecar NAME.raw.json, or in the name (name_AxBxC_uint8.raw)";

/// A sidecar's value as the query would have it: "64x64x93", [64, 64, 93], "uint8", 16.
std::string as_query_text(const nlohmann::json& value, std::string_view separator) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const auto& item : value) {
    if (!text.empty()) text += separator;
    text += item.dump();
  }
  return text;
}

Query query_from_sidecar(const std::filesystem::path& sidecar) {
  constexpr std::size_t size_limit = 1 << 20;
  if (!std::filesystem::is_regular_file(sidecar))
    throw Error(fmt::format("{}: not a file, as what says the size of raw voxels is", sidecar.string()));
  const auto json = nlohmann::json::parse(read_file(sidecar, size_limit), nullptr, false);
  if (!json.is_object()) throw Error(fmt::format("{}: not a JSON object with {}", sidecar.string(), keys));
  Query query;
  for (const auto& [key, value] : json.items()) query[key] = as_query_text(value, key == "size" ? "x" : ",");
  require_known_keys(sidecar.string(), query, keys);
  return query;
}

/// The query wins over the sidecar, and that over the name.
Query gather(const FileRequest& request) {
  Query query = request.query;
  require_known_keys(request.name(), query, keys);
  const std::filesystem::path sidecar = request.name() + ".json";
  if (std::filesystem::exists(sidecar)) query.merge(query_from_sidecar(sidecar));
  query.merge(query_from_name(request.path.stem().string()));
  return query;
}

const std::string* find(const Query& query, std::string_view key) {
  const auto found = query.find(key);
  return found == query.end() ? nullptr : &found->second;
}

/// What a person is asked where the size or the type is missing, or the file is of another length.
[[noreturn]] void throw_unknown(const std::string& text, const std::string& path, const Query& query) {
  throw ChoiceNeeded(text, {ChoiceKind::raw_layout, path, query, 0, {}});
}

glm::u64vec3 parse_size(const std::string& name, const Query& query) {
  const std::string* text = find(query, "size");
  if (!text) throw_unknown(fmt::format("{}: raw voxels of unknown size; {}", name, hint), name, query);
  if (const auto size = raw_size(*text)) return *size;
  throw Error(fmt::format("{}: size={} is not like 256x256x128", name, *text));
}

ScalarType parse_type(const std::string& name, const Query& query) {
  const std::string* text = find(query, "type");
  if (!text) throw_unknown(fmt::format("{}: raw voxels of unknown type; {}", name, hint), name, query);
  if (const auto type = raw_type(*text)) return *type;
  throw Error(fmt::format("{}: type={} is not one of uint8, int8 ... int64, float32, float64", name, *text));
}

glm::dvec3 parse_vector(const std::string& name, const Query& query, std::string_view key,
                        glm::dvec3 fallback) {
  const std::string* text = find(query, key);
  if (!text) return fallback;
  const auto vector = to_vector(*text, ',');
  if (!vector) throw Error(fmt::format("{}: {}={} is not three numbers like 1,1,2.5", name, key, *text));
  return *vector;
}

std::endian parse_endian(const std::string& name, const Query& query) {
  const std::string* text = find(query, "endian");
  if (!text || *text == "little") return std::endian::little;
  if (*text == "big") return std::endian::big;
  throw Error(fmt::format("{}: endian={} is neither little nor big", name, *text));
}

void require_byte_count(const FileRequest& request, const Query& query, glm::u64vec3 size, ScalarType type,
                        std::uint64_t offset) {
  const std::uint64_t promised = offset + size.x * size.y * size.z * size_of(type);
  const std::uint64_t held = std::filesystem::file_size(request.path);
  if (promised == held) return;
  throw_unknown(fmt::format("{}: {}x{}x{} voxels of {} after {} bytes are {} bytes, and the file holds {}",
                            request.name(), size.x, size.y, size.z, name_of(type), offset, promised, held),
                request.name(), query);
}

SlabsRead read_values(const FileRequest& request, const VoxelLayout& layout, const StoredAs& stored,
                      std::uint64_t offset) {
  std::ifstream file(request.path, std::ios::binary);
  const auto read = [&](std::uint64_t first, std::span<std::byte> out) {
    if (request.reading.stop.stop_requested()) throw Error(request.name() + ": reading it was stopped");
    file.seekg(std::streamoff(offset + first * size_of(stored.type)));
    if (!file.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size())))
      throw Error(fmt::format("{}: it could not be read to its end", request.name()));
  };
  return read_slabs(layout, stored, read, request.reading.progress);
}

}  // namespace

Volume read_raw(const FileRequest& request) {
  const std::string name = request.name();
  const Query query = gather(request);
  const glm::u64vec3 size = parse_size(name, query);
  const ScalarType type = parse_type(name, query);
  const std::endian endian = parse_endian(name, query);
  const auto offset = std::uint64_t(integer_in(name, query, "offset", 0, 0, std::int64_t(1) << 60));

  Volume volume;
  volume.file_type = type;
  volume.file.raw = {.big_endian = endian == std::endian::big, .offset = offset};
  volume.grid.spacing = parse_vector(name, query, "spacing", glm::dvec3(1));
  volume.grid.origin = parse_vector(name, query, "origin", glm::dvec3(0));
  require_memory(name, {whole_grid(size), sizeof(double)}, std::numeric_limits<std::uint64_t>::max());
  require_byte_count(request, query, size, type, offset);
  const GridPart part = part_from_query(name, query, size);
  request.require_memory({part, held_size_of(type)});
  constexpr double most = 1e300;
  const double subtracted = number_in(name, query, "subtract", 0, -most, most);
  const LinearMap map{1, -subtracted};
  SlabsRead read = read_values(request, part_of(interleaved(size), part), {type, endian, map}, offset);
  volume.values = std::move(read.values);
  if (subtracted != 0) volume.note = fmt::format("{} is subtracted from all values", subtracted);
  if (const std::string lost = rounding_note(read.rounding, type, map); !lost.empty())
    volume.note += (volume.note.empty() ? "" : "; ") + lost;
  place_part(volume, part);
  return volume;
}

}  // namespace crest
