#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "common/rpc/server/serve.h"
#include "services/slicing/algo/local_slicing_stage.h"
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
  if (!meshes.ok()) {
    program.log().Error("cannot serve", {{"error", std::string(meshes.status().message())}});
    return 1;
  }
  program.log().Info("how meshes are read",
                     {{"mesh_sandbox", std::string(MeshSandboxName(sandbox))}});
  const auto stage = slicefarm::slicing::MakeLocalSlicing(*std::move(meshes));
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  slicefarm::slicing::SlicingService service(*stage, gate, threads);
  return program.Run(flags, {&service});
}
