#pragma once

#include <cstdint>

namespace slicefarm::slicing::threemf {

/// Id of a resource: any positive number below 2^31. A file may have any ids, so the size of a
/// table never depends on an id.
using ResourceId = uint32_t;

}  // namespace slicefarm::slicing::threemf
