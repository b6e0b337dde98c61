#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/files/file_request.h"
#include "render/files/open_choice.h"
#include "render/volume/volume.h"

namespace crest {

/// What people call components or frames, in their order; as many, or none.
using Names = std::vector<std::string>;

/// "red", "green", "blue", and "alpha" of four; none of other counts.
Names colour_names(std::uint64_t components);
/// "real part" and "imaginary part".
Names complex_names();

/// One of `count` components or frames, counted from 0: ChoiceNeeded when there are more than one and the
/// query does not say which. What was taken goes to `note`. `kind` is component or frame.
std::uint64_t select_one(const FileRequest& request, ChoiceKind kind, std::uint64_t count, std::string& note,
                         const Names& names = {});
/// The same of frames, told to `volume`, whose frame it is.
std::uint64_t select_frame(const FileRequest& request, std::uint64_t count, Volume& volume,
                           const Names& names = {});

}  // namespace crest
