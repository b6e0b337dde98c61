#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "render/volume/grid_part.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"
#include "render/volume/tell_share.h"

namespace crest {

/// The program that reads files for Crest (render/reader), beside which it lies.
std::filesystem::path reader_program();

/// How files are read.
struct Reading {
  std::uint64_t memory = available_memory();  ///< bytes that it may take
  bool asks = false;          ///< ChoiceNeeded also where the query left something open that has a default
  std::stop_token stop = {};  ///< ends the reader at once
  TellShare progress = {};    ///< until the volume is there, with its statistics
  std::filesystem::path reader = reader_program();  ///< tests have others
  std::chrono::seconds patience{30};                ///< with a reader that does nothing
};

/// What load_volume asks of a reader. The path is there, and readable.
struct FileRequest {
  std::filesystem::path path;
  Query query = {};
  Reading reading = {};
  /// Called before what takes so many bytes is read.
  std::function<void(std::uint64_t bytes)> expect = {};

  std::string name() const { return path.string(); }  ///< what errors call it
  /// What the query says of a grid of so many points (grid_part.h).
  GridPart part_of(glm::u64vec3 dims) const { return part_from_query(name(), query, dims); }
  /// As crest::require_memory, by what reading may take; then the reader gets that much.
  void require_memory(const MemoryNeed& need) const;
  /// The same, where so many bytes are read besides those of the path itself. The reader gets them at once.
  FileRequest reading_also(std::uint64_t bytes) const;
};

/// A lower-case extension with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace crest
