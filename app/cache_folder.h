#pragma once

#include <filesystem>

namespace crest {

/// Where the program keeps what it can make again: $XDG_CACHE_HOME/crest, or ~/.cache/crest; empty where
/// neither is known. It need not exist.
std::filesystem::path cache_folder();

/// Where no file can be made in it, or the disk is full, Mesa is told so, which else prints that on stderr.
/// Before any thread begins.
void tell_driver_of_cache();

/// The part of it for linked shader programs; empty where the cache folder is.
std::filesystem::path program_folder();

/// The part of it for small pictures (ThumbnailStore); empty where the cache folder is.
std::filesystem::path thumbnail_folder();

}  // namespace crest
