#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "common/rpc/server/serve.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/placement/arranging/local_arranging_stage.h"
#include "services/slicing/server/mesh_sandbox.h"
#include "services/slicing/server/slicing_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("slicing");
  CLI::App app("slicefarm-slicing: Meshes to outlines, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  AddConcurrencyFlag(app, &flags);
  int threads = 1;
  app.add_option("--threads", threads, "Threads that one call may use")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  auto sandbox = slicefarm::slicing::MeshSandbox::kStrict;
  AddMeshSandboxFlag(app, &sandbox);
  CLI11_PARSE(app, argc, argv);

  auto meshes = slicefarm::slicing::MakeMeshSource(sandbox);
  auto meshes_to_arrange = slicefarm::slicing::MakeMeshSource(sandbox);
  for (const absl::Status& status : {meshes.status(), meshes_to_arrange.status()}) {
    if (status.ok()) continue;
    program.log().Error("cannot serve", {{"error", std::string(status.message())}});
    return 1;
  }
  program.log().Info("how meshes are read",
                     {{"mesh_sandbox", std::string(MeshSandboxName(sandbox))}});
  const auto slicing = slicefarm::slicing::MakeLocalSlicing(*std::move(meshes));
  const auto arranging = slicefarm::slicing::MakeLocalArranging(*std::move(meshes_to_arrange));
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  const auto service = slicefarm::slicing::MakeSlicingService(*slicing, *arranging, gate, threads);
  return program.Run(flags, {service.get()});
}
