#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/byte_budget.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Process in which the service reads meshes.
enum class MeshSandbox {
  kOff,     ///< the service's own process
  kLimits,  ///< a separate process per mesh, with resource limits
  kStrict,  ///< like kLimits, with system calls denied too
};

/// Returns the values of --mesh-sandbox: off, limits, strict.
std::vector<std::string> MeshSandboxNames();

/// Returns the sandbox with a name. `name`: one of MeshSandboxNames.
MeshSandbox MeshSandboxOf(std::string_view name);

/// Returns the source of meshes for `sandbox` after testing it on this machine.
/// slicefarm-mesh-reader must be in the same folder as this program. `memory` is shared by all
/// readers and must outlive the source. Errors: FailedPrecondition, Unavailable and similar, with
/// advice.
absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox,
                                                                 ByteBudget& memory);

}  // namespace slicefarm::slicing
