#pragma once

#include <itkImageIOBase.h>

#include <functional>
#include <string>
#include <vector>

#include "render/files/open_choice.h"
#include "render/volume/volume.h"

namespace crest {

/// Runs `work`; what ITK and its libraries throw becomes a one-line Error that begins with `name`.
void with_itk(const std::string& name, const std::function<void()>& work);

/// Throws Error, which begins with `name`, for a type that is not a number.
ScalarType scalar_type(const std::string& name, itk::CommonEnums::IOComponent component);

/// The components by the names that they have by the pixel's kind: colours, a complex number's parts; none
/// for other kinds.
std::vector<ChoiceOption> component_options(const itk::ImageIOBase& io);

/// Fills the volume's spacing, origin and direction from the header's first three axes.
void take_geometry(const itk::ImageIOBase& io, Volume& volume);

}  // namespace crest
