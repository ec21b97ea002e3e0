#pragma once

#include <string_view>

namespace slicefarm::motion {

/// Why a variable of PrusaSlicer's is not known to a template that asks for it: what was made has
/// to be made first, or the value would be another one each time. Empty for any other name.
std::string_view WhyAbsent(std::string_view variable);

}  // namespace slicefarm::motion
