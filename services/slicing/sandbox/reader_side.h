#pragma once

#include <functional>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"

namespace slicefarm::slicing {

/// Function that reads a mesh.
using ReadFunction = std::function<absl::StatusOr<MeshFileContents>(
    std::string_view bytes, MeshFormat format, double coordinate_limit, ReadDepth depth)>;

/// Main function of a reader program: reads a request on stdin, writes the answer to stdout and
/// exits. The reader confines itself before it calls `read`. Does not return.
[[noreturn]] void RunReader(const ReadFunction& read);

}  // namespace slicefarm::slicing
