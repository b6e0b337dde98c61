#include "render/files/load.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>

#include "presets/error.h"
#include "render/files/file_modules.h"
#include "render/files/geometry.h"
#include "render/files/header_text.h"
#include "render/files/kinds.h"
#include "render/files/open_choice.h"
#include "render/files/other_formats.h"
#include "render/files/raw_reader.h"
#include "render/files/read_beside.h"
#include "render/files/time_steps.h"
#include "render/volume/builtin.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view builtin_prefix = "builtin:";

/// A kind of file, by the end of its name.
struct Reader {
  VolumeFormat format;  ///< its extensions: with dots, separated by spaces
  Volume (*read)(const FileRequest&);
};

template <FileForm form>
Volume read_form(const FileRequest& request) {
  return read_beside(form, request);
}

constexpr Reader readers[] = {
    {{"NRRD", ".nrrd .nhdr", "attached or detached header; raw, gzip, ascii or hex"},
     read_form<FileForm::nrrd>},
    {{"MetaImage", ".mha .mhd", "attached or detached header; raw or compressed"},
     read_form<FileForm::metaimage>},
    {{"NIfTI", ".nii .nii.gz .hdr .hdr.gz .img .img.gz",
      "versions 1 and 2, one file or a pair, Analyze 7.5; slope and intercept are applied"},
     read_form<FileForm::nifti>},
    {{"MRC", ".mrc .map .rec .ccp4 .mrc.gz .map.gz .rec.gz .ccp4.gz",
      "electron microscopy; modes 0, 1, 2, 6, 12 and 16; axes put in order; stacks of volumes (?frame=)"},
     read_form<FileForm::mrc>},
    {{"VTK", ".vtk", "legacy structured points, binary or ASCII; ?array=NAME for one of several"},
     read_form<FileForm::vtk>},
    {{"VTK XML", ".vti",
      "image data, in pieces too: text, base64 or appended, also by zlib; ?array=NAME for one of several"},
     read_form<FileForm::vti>},
    {{"parallel VTK XML", ".pvti",
      "image data in pieces, each in a .vti file that this one names; ?array=NAME"},
     read_form<FileForm::pvti>},
    {{"NumPy", ".npy", "arrays [z][y][x], [frame][z][y][x] or [z][y][x][component], in C or Fortran order"},
     read_form<FileForm::npy>},
    {{"DICOM", ".dcm .dicom .ima",
      "a folder with a series (?series=UID for one of several), or a multi-frame file"},
     read_form<FileForm::dicom_file>},
    {{"RAW", ".raw",
      "?size=AxBxC&type=uint8&spacing=x,y,z&origin=x,y,z&endian=little|big&offset=bytes, or the same keys in "
      "NAME.raw.json, or name_AxBxC_uint8.raw"},
     read_raw},
    {{"image stack", ".tif .tiff", "a multi-page file, or a folder of images sorted by name; ?spacing=x,y,z"},
     read_form<FileForm::image_pages>},
};

const Reader* find_reader(const fs::path& path) {
  const std::string file = lower(path.filename().string());
  for (const Reader& reader : readers) {
    for (const std::string& extension : words(reader.format.extensions)) {
      if (file.ends_with(extension)) return &reader;
    }
  }
  return nullptr;
}

Volume read_folder(const FileRequest& request) {
  const auto has = [&](bool (*is_one)(const fs::path&)) {
    return std::ranges::any_of(fs::directory_iterator(request.path),
                               [=](const auto& entry) { return is_one(entry.path()); });
  };
  if (has(is_dicom)) return read_beside(FileForm::dicom_series, request);
  if (has(is_image)) return read_beside(FileForm::image_folder, request);
  throw Error(fmt::format("{}: a folder with neither a DICOM series nor images in it", request.name()));
}

Volume read_file_or_folder(const FileRequest& request) {
  const std::string name = request.name();
  if (access(request.path.c_str(), R_OK) != 0) throw Error(fmt::format("{}: {}", name, std::strerror(errno)));
  if (const std::string how = how_to_convert(request.path); !how.empty() && !request.query.contains("size"))
    throw Error(fmt::format("{}: {}", name, how));
  if (fs::is_directory(request.path)) return read_folder(request);
  if (request.path.filename() == "DICOMDIR" && is_dicom(request.path)) {
    FileRequest folder = request;
    folder.path = fs::absolute(request.path).parent_path();
    return read_folder(folder);
  }
  if (!fs::is_regular_file(request.path)) throw Error(fmt::format("{}: neither a file nor a folder", name));
  if (request.query.contains("size")) return read_raw(request);
  if (const Reader* reader = find_reader(request.path)) return reader->read(request);
  if (is_dicom(request.path))
    return read_beside(FileForm::dicom_file, request);  // often without an extension
  std::string known;
  for (const Reader& reader : readers)
    known += fmt::format("{}{}", known.empty() ? "" : " ", reader.format.extensions);
  throw ChoiceNeeded(fmt::format("{}: its extension is not known; those read are {}; for raw voxels add "
                                 "?size=AxBxC&type=uint8",
                                 name, known),
                     {ChoiceKind::raw_layout, name, request.query, 0, {}});
}

/// With what the standard library throws (no permission for a folder, no memory after all) as Errors.
Volume guarded(const FileRequest& request) {
  try {
    return read_file_or_folder(request);
  } catch (const TooLarge& fault) {
    throw part_needed(fault, request.name(), request.query);
  } catch (const fs::filesystem_error& fault) {
    throw Error(fmt::format("{}: {}", request.name(), fault.code().message()));
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: reading it takes more memory than there is", request.name()));
  }
}

Volume read_builtin(const std::string& source, const Reading& reading) {
  try {
    return make_builtin(source.substr(builtin_prefix.size()), reading.memory);
  } catch (const TooLarge& fault) {
    const std::size_t mark = source.find('?');
    const Query query = mark == source.npos ? Query() : parse_query(source, source.substr(mark + 1));
    throw part_needed(fault, source.substr(0, mark), query);
  }
}

/// The path alone, which is there.
Volume load_path(FileRequest request) {
  // Of a large volume most of the time goes into reading it, even where it is not compressed
  constexpr double until_read = 0.85;
  const TellShare progress = request.reading.progress;
  request.reading.progress = share_of(progress, 0, until_read);
  const fs::path& path = request.path;
  Volume volume = guarded(request);
  repair_geometry(volume);
  volume.file.path = fs::absolute(path).lexically_normal().string();
  volume.name = path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
  volume.statistics =
      compute_statistics(volume.grid, volume.values, histogram_bins, share_of(progress, until_read, 1));
  return volume;
}

/// One of a numbered list, as the query says.
Volume load_listed(const std::vector<fs::path>& list, FileRequest request) {
  const std::string name = request.name();
  const OpenChoice choice{ChoiceKind::frame, name, request.query, list.size(), {}};
  if (list.size() > 1 && !request.query.contains("frame"))
    throw ChoiceNeeded(fmt::format("{}: these are {} files, and a volume is one: take the first with "
                                   "?frame=0 (or --frame 0)",
                                   name, list.size()),
                       choice);
  const std::int64_t last = std::int64_t(list.size()) - 1;
  const auto frame = std::size_t(integer_in(name, request.query, "frame", 0, 0, last));
  request.query.erase("frame");
  request.path = list[frame];
  try {
    Volume volume = load_path(request);
    volume.frames = int(list.size());
    volume.frame = int(frame);
    return volume;
  } catch (ChoiceNeeded& needed) {
    if (needed.choice.kind == ChoiceKind::frame)
      throw Error(fmt::format("{}: one of a numbered list has to be a single volume, and it has {} frames",
                              needed.choice.path, needed.choice.count));
    needed.choice.path = name;
    if (const auto said = choice.query.find("frame"); said != choice.query.end())
      needed.choice.query.insert(*said);
    throw;
  }
}

}  // namespace

std::vector<VolumeFormat> volume_formats() {
  std::vector<VolumeFormat> formats;
  for (const Reader& reader : readers) formats.push_back(reader.format);
  return formats;
}

bool is_volume_there(const std::string& source) {
  return source.starts_with(builtin_prefix) || find_source(source);
}

Volume load_volume(const std::string& source, const Reading& reading) {
  if (source.starts_with(builtin_prefix)) return read_builtin(source, reading);
  const auto found = find_source(source);
  if (!found) {
    const std::string path = source.substr(0, source.find('?'));
    const char* what =
        path.find('*') == path.npos ? "file or folder" : "file, nor one with a number for the *";
    throw Error(fmt::format("{}: there is no such {}", path, what));
  }
  const FileRequest request{found->path, parse_query(found->path.string(), found->query), reading};
  return found->list.empty() ? load_path(request) : load_listed(found->list, request);
}

}  // namespace crest
