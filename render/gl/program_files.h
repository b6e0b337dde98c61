#pragma once

#include <cstdint>
#include <filesystem>
#include <future>
#include <string>

#include "render/gl/handle.h"

namespace crest::gl {

/// The folder of linked programs keeps to so much; a program takes some 10 to 100 KiB.
inline constexpr std::uintmax_t program_files_bytes = std::uintmax_t(64) << 20;

/// A program that was linked before from the same `source` - the text of all its shaders - by the same
/// driver, from a file in `folder`; nothing where there is none, or the driver does not take it any more.
ProgramHandle read_program(const std::filesystem::path& folder, const std::string& source);

/// Keeps a linked program for read_program, where the driver gives its binary: it is written in a thread,
/// since the disk may be busy. What cannot be written is compiled again next time.
[[nodiscard]] std::future<void> write_program(const std::filesystem::path& folder, const std::string& source,
                                              GLuint program);

}  // namespace crest::gl
