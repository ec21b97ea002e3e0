#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/byte_budget.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Isolation of the code that reads meshes.
enum class MeshSandbox {
  kOff,     ///< meshes are read in the service itself
  kLimits,  ///< each mesh is read by a separate program with resource limits
  kStrict,  ///< like kLimits, and with only a few system calls (Confinement::kStrict)
};

/// Returns the values of --mesh-sandbox: off, limits, strict.
std::vector<std::string> MeshSandboxNames();

/// Returns the sandbox of a name. REQUIRES: `name` is one of MeshSandboxNames.
MeshSandbox MeshSandboxOf(std::string_view name);

/// Tests that `sandbox` works on this machine, then returns its mesh source. slicefarm-mesh-reader
/// must be in the same folder as this program. All readers share `memory`, which must outlive the
/// source. Errors: FailedPrecondition or Unavailable, with advice in the message.
absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox,
                                                                 ByteBudget& memory);

}  // namespace slicefarm::slicing
