#pragma once

#include <string>

namespace slicefarm {

/// Returns a duration in the form `1d 2h 3m 4s`: whole seconds, without leading units of 0. The
/// shortest text is "0s".
std::string DurationText(double seconds);

}  // namespace slicefarm
