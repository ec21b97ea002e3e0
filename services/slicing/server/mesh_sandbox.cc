#include "services/slicing/server/mesh_sandbox.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "common/base/error.h"
#include "services/slicing/sandbox/sandboxed_mesh_source.h"

namespace slicefarm::slicing {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"off", "limits", "strict"};

std::string ReaderProgram() {
  std::error_code none;  // an empty path names no program; the test run reports this
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path() /
         "slicefarm-mesh-reader";
}

absl::Status WithAdvice(MeshSandbox sandbox, const absl::Status& error) {
  const std::string weaker =
      sandbox == MeshSandbox::kStrict
          ? "allow seccomp in this container, or use --mesh-sandbox limits (resource limits only)"
          : "allow processes to set their resource limits";
  const ErrorDetail detail = DetailOf(error);
  return MakeError(
      error.code(), detail.reason,
      fmt::format("--mesh-sandbox {} does not work here: {}; {}, or use --mesh-sandbox off (a "
                  "fault in a mesh reader then endangers this process)",
                  kNames[static_cast<size_t>(sandbox)], std::string(error.message()), weaker),
      detail.metadata);
}

}  // namespace

std::vector<std::string> MeshSandboxNames() { return {kNames.begin(), kNames.end()}; }

MeshSandbox MeshSandboxOf(std::string_view name) {
  return static_cast<MeshSandbox>(std::ranges::find(kNames, name) - kNames.begin());
}

absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox,
                                                                 ByteBudget& memory) {
  if (sandbox == MeshSandbox::kOff) return MakeDirectMeshSource();
  auto source = std::make_unique<SandboxedMeshSource>(SandboxOptions{
      .confinement = sandbox == MeshSandbox::kStrict ? Confinement::kStrict : Confinement::kLimits,
      .program = ReaderProgram(),
      .memory = &memory});
  if (absl::Status status = source->Probe(); !status.ok()) return WithAdvice(sandbox, status);
  return source;
}

}  // namespace slicefarm::slicing
