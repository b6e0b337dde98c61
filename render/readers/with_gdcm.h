#pragma once

#include <functional>
#include <string>

namespace crest {

/// Runs `work`, which tells whether GDCM could. A failure becomes an Error that begins with `name`. One
/// thread at a time.
void with_gdcm(const std::string& name, const std::function<bool()>& work);

}  // namespace crest
