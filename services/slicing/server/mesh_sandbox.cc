#include "services/slicing/server/mesh_sandbox.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "common/base/error.h"
#include "services/slicing/sandbox/sandboxed_mesh_source.h"

namespace slicefarm::slicing {
namespace {

const std::map<std::string, MeshSandbox>& Names() {
  static const std::map<std::string, MeshSandbox> names = {{"off", MeshSandbox::kOff},
                                                           {"limits", MeshSandbox::kLimits},
                                                           {"strict", MeshSandbox::kStrict}};
  return names;
}

std::string ReaderProgram() {
  std::error_code none;  // an empty path names no program, which the trial will tell
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path() /
         "slicefarm-mesh-reader";
}

absl::Status WithAdvice(MeshSandbox sandbox, const absl::Status& error) {
  const std::string weaker =
      sandbox == MeshSandbox::kStrict
          ? "let this container use seccomp, or say --mesh-sandbox limits (resource limits alone)"
          : "see that a process may set its resource limits";
  const ErrorDetail detail = DetailOf(error);
  return MakeError(
      error.code(), detail.reason,
      fmt::format("--mesh-sandbox {} cannot be had here: {}; {}, or --mesh-sandbox off (whoever "
                  "finds a fault in the readers has this process)",
                  MeshSandboxName(sandbox), std::string(error.message()), weaker),
      detail.metadata);
}

}  // namespace

std::string_view MeshSandboxName(MeshSandbox sandbox) {
  for (const auto& [name, value] : Names())
    if (value == sandbox) return name;
  return "";
}

void AddMeshSandboxFlag(CLI::App& app, MeshSandbox* sandbox) {
  app.add_option("--mesh-sandbox", *sandbox,
                 "Where strangers' meshes are read: off: in this process; limits: in a process "
                 "for each, with resource limits; strict: and without system calls")
      ->transform(CLI::CheckedTransformer(Names()))
      ->option_text(fmt::format("off|limits|strict={}", MeshSandboxName(*sandbox)));
}

absl::StatusOr<std::unique_ptr<const MeshSource>> MakeMeshSource(MeshSandbox sandbox) {
  if (sandbox == MeshSandbox::kOff) return MakeDirectMeshSource();
  auto source = std::make_unique<SandboxedMeshSource>(SandboxOptions{
      .confinement = sandbox == MeshSandbox::kStrict ? Confinement::kStrict : Confinement::kLimits,
      .program = ReaderProgram()});
  if (absl::Status status = source->Probe(); !status.ok()) return WithAdvice(sandbox, status);
  return source;
}

}  // namespace slicefarm::slicing
