#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/byte_budget.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Where the service lets meshes be read.
enum class MeshSandbox {
  kOff,     ///< in the service's own process
  kLimits,  ///< in a process for each, with resource limits
  kStrict,  ///< and with system calls denied
};

/// What --mesh-sandbox takes: off, limits, strict.
std::vector<std::string> MeshSandboxNames();

/// `name`: one of MeshSandboxNames.
MeshSandbox MeshSandboxOf(std::string_view name);

/// The source of meshes for `sandbox`, tried out on this machine; slicefarm-mesh-reader must lie
/// beside this program. `memory`, which all readers share, must outlive it. Errors:
/// FailedPrecondition, Unavailable and the like, with what to do.
absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox,
                                                                 ByteBudget& memory);

}  // namespace slicefarm::slicing
