#pragma once

#include <filesystem>

namespace crest::test {

/// The project's own folder, and the built program.
std::filesystem::path source_folder();
std::filesystem::path crest_program();
/// A reader that fails (tests/files/reader).
std::filesystem::path bad_reader_program();

}  // namespace crest::test
