#pragma once

#include <functional>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/model/mesh.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

using ReadFunction = std::function<absl::StatusOr<RawMesh>(
    std::string_view bytes, MeshFormat format, double coordinate_limit)>;

/// The life of a reader process, from a request on stdin to an answer on stdout: confines itself,
/// and only then lets `read` look at the bytes. Does not return.
[[noreturn]] void RunReader(const ReadFunction& read);

}  // namespace slicefarm::slicing
