#pragma once

#include <string>

namespace slicefarm {

/// `1d 2h 3m 4s`: whole seconds, leading units of 0 left out; "0s" at least.
std::string DurationText(double seconds);

}  // namespace slicefarm
