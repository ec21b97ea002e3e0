#pragma once

#include <memory>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/mesh_source.h"

namespace CLI {
class App;
}

namespace slicefarm::slicing {

/// Where the service lets meshes be read.
enum class MeshSandbox {
  kOff,     ///< in the service's own process
  kLimits,  ///< in a process for each, with resource limits
  kStrict,  ///< and with system calls denied
};

/// `strict`, as --mesh-sandbox has it.
std::string_view MeshSandboxName(MeshSandbox sandbox);

/// --mesh-sandbox.
void AddMeshSandboxFlag(CLI::App& app, MeshSandbox* sandbox);

/// The source of meshes for `sandbox`, tried out on this machine; slicefarm-mesh-reader must lie
/// beside this program. Errors: FailedPrecondition, Unavailable and the like, with what to do.
absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox);

}  // namespace slicefarm::slicing
