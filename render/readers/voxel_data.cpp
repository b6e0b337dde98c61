#include "render/readers/voxel_data.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/inflater.h"
#include "render/volume/memory.h"

namespace crest {

namespace fs = std::filesystem;

std::uint64_t bytes_from(const std::string& name, const fs::path& path, std::uint64_t offset) {
  std::error_code fault;
  const std::uint64_t size = fs::file_size(path, fault);
  if (fault) throw Error(fmt::format("{}: its voxels are in {}, which cannot be read", name, path.string()));
  return size > offset ? size - offset : 0;
}

void throw_short(const std::string& name, const VoxelData& data, std::uint64_t promised, std::uint64_t held,
                 std::string_view unit) {
  const std::string where = data.files.size() == 1 ? data.files[0].filename().string()
                                                   : fmt::format("its {} files", data.files.size());
  throw Error(fmt::format("{}: the header promises {} {} of voxels, and {} {} {}", name, promised, unit,
                          where, data.files.size() == 1 ? "has" : "have", held));
}

std::uint64_t share_of(const std::string& name, const VoxelData& data, std::uint64_t values) {
  const std::uint64_t files = data.files.size();
  if (files > 0 && values % files == 0) return values / files;
  throw Error(
      fmt::format("{}: {} numbers of voxels cannot be in {} files of one length", name, values, files));
}

void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size) {
  constexpr std::uint64_t most = std::uint64_t(1) << 60;  // which leaves room for digits, and to add
  const std::uint64_t share = share_of(name, data, values), files = data.files.size();
  const auto share_bytes = checked_product(share, value_size);
  const std::uint64_t bytes = std::min(share_bytes.value_or(most), most) + std::min(data.skip, most);
  if (bytes > most / files || data.offset > most)
    throw Error(fmt::format("{}: its header promises voxels beyond any file's end", name));
  std::uint64_t held = 0;
  for (const fs::path& path : data.files) held += bytes_from(name, path, data.at_file_end ? 0 : data.offset);
  switch (data.encoding) {
    case Encoding::raw:
      for (const fs::path& path : data.files) {
        const std::uint64_t here = bytes_from(name, path, data.at_file_end ? 0 : data.offset);
        if (here < bytes) throw_short(name, data, bytes * files, held, "bytes");
        if (here > bytes && files > 1 && !data.at_file_end) {
          throw Error(
              fmt::format("{}: its voxels are in {} files, of which each is to have {} bytes of them, "
                          "and {} has {}",
                          name, files, bytes - data.skip, path.string(), here - data.skip));
        }
      }
      break;
    case Encoding::deflate:
      if (data.skip > share * value_size + longest_skip) {
        throw Error(
            fmt::format("{}: its voxels begin after {} bytes of compressed data, and are {} themselves", name,
                        data.skip, share * value_size));
      }
      if (held < bytes * files / greatest_inflation)
        throw_short(name, data, bytes * files, held, "bytes (compressed)");
      break;
    case Encoding::decimal:
      if (held < values * 2 - 1) throw_short(name, data, values * 2 - 1, held, "characters");
      break;
    case Encoding::hexadecimal:
      if (held < bytes * files * 2) throw_short(name, data, bytes * files * 2, held, "hexadecimal digits");
      break;
  }
}

std::string read_head(const fs::path& path, std::size_t size, bool inflate) {
  if (!inflate) return read_head(path, size);
  std::string head(size, '\0');
  head.resize(Inflater(path, 0).read(head));
  return head;
}

}  // namespace crest
