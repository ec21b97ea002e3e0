#include <string>
#include <utility>

#include "common/rpc/server/serve.h"
#include "common/rpc/server/stage_command_line.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/placement/arranging/local_arranging_stage.h"
#include "services/slicing/server/mesh_sandbox.h"
#include "services/slicing/server/slicing_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("slicing");
  slicefarm::rpc::ServeFlags flags;
  int threads = 1;
  std::string sandbox_name = "strict";
  slicefarm::rpc::StageCommandLine command_line("slicing", "meshes to outlines", &flags);
  command_line.AddConcurrency(&flags);
  command_line.AddCount("--threads", &threads, "Threads that one call may use", 1, 1024);
  command_line.AddChoice("--mesh-sandbox", &sandbox_name,
                         "Where strangers' meshes are read: off: in this process; limits: in a "
                         "process for each, with resource limits; strict: and without system calls",
                         slicefarm::slicing::MeshSandboxNames());
  if (const auto code = command_line.Parse(argc, argv)) return *code;

  const auto sandbox = slicefarm::slicing::MeshSandboxOf(sandbox_name);
  auto meshes = slicefarm::slicing::MakeMeshSource(sandbox);
  auto meshes_to_arrange = slicefarm::slicing::MakeMeshSource(sandbox);
  for (const absl::Status& status : {meshes.status(), meshes_to_arrange.status()}) {
    if (status.ok()) continue;
    program.log().Error("cannot serve", {{"error", std::string(status.message())}});
    return 1;
  }
  program.log().Info("how meshes are read", {{"mesh_sandbox", sandbox_name}});
  const auto slicing = slicefarm::slicing::MakeLocalSlicing(*std::move(meshes));
  const auto arranging = slicefarm::slicing::MakeLocalArranging(*std::move(meshes_to_arrange));
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  const auto service = slicefarm::slicing::MakeSlicingService(*slicing, *arranging, gate, threads);
  return program.Run(flags, {service.get()});
}
