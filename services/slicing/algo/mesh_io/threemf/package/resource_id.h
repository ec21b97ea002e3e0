#pragma once

#include <cstdint>

namespace slicefarm::slicing::threemf {

/// The name of a resource; any positive number below 2^31, and nothing is ever allocated by it.
using ResourceId = uint32_t;

}  // namespace slicefarm::slicing::threemf
