#pragma once

#include <cstdint>

namespace slicefarm::slicing::threemf {

/// Id of a resource: any positive number below 2^31. No memory is ever allocated according to its
/// value.
using ResourceId = uint32_t;

}  // namespace slicefarm::slicing::threemf
