#include <cstdint>
#include <string>
#include <utility>

#include "common/rpc/server/serve.h"
#include "common/rpc/server/stage_command_line.h"
#include "common/stage/memory_budget.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/placement/local_arranging_stage.h"
#include "services/slicing/algo/placement/local_placing_stage.h"
#include "services/slicing/server/mesh_sandbox.h"
#include "services/slicing/server/slicing_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("slicing");
  slicefarm::rpc::ServeFlags flags;
  int threads = 1;
  std::string sandbox_name = "strict";
  // Half of the available memory is for readers, and three eighths are for their results.
  const int64_t half = slicefarm::DefaultMemoryBudget() >> 20;
  int reader_memory_mib = static_cast<int>(half);
  int memory_mib = static_cast<int>(half * 3 / 4);
  slicefarm::rpc::StageCommandLine command_line("slicing", "slices meshes into outlines", &flags);
  command_line.AddConcurrency(&flags);
  command_line.AddCount("--threads", &threads, "Largest number of threads for one call", 1, 1024);
  command_line.AddCount("--memory", &memory_mib,
                        "MiB of memory for the meshes and outlines of all calls together", 64,
                        1 << 30);
  command_line.AddCount("--reader-memory", &reader_memory_mib,
                        "MiB of memory for all mesh readers together (--mesh-sandbox)", 64,
                        1 << 30);
  command_line.AddChoice(
      "--mesh-sandbox", &sandbox_name,
      "Isolation of the code that reads meshes. off: none. limits: each mesh is read by a separate "
      "program with resource limits. strict: as limits, and with only a few system calls",
      slicefarm::slicing::MeshSandboxNames());
  if (const auto code = command_line.Parse(argc, argv)) return *code;

  const auto sandbox = slicefarm::slicing::MeshSandboxOf(sandbox_name);
  slicefarm::ByteBudget reader_memory(int64_t{reader_memory_mib} << 20);
  slicefarm::MemoryBudget memory(int64_t{memory_mib} << 20);
  auto meshes = slicefarm::slicing::MakeMeshSource(sandbox, reader_memory);
  auto meshes_to_arrange = slicefarm::slicing::MakeMeshSource(sandbox, reader_memory);
  auto meshes_to_place = slicefarm::slicing::MakeMeshSource(sandbox, reader_memory);
  auto projects = slicefarm::slicing::MakeMeshSource(sandbox, reader_memory);
  for (const absl::Status& status :
       {meshes.status(), meshes_to_arrange.status(), meshes_to_place.status(), projects.status()}) {
    if (status.ok()) continue;
    program.log().Error("cannot serve", {{"error", std::string(status.message())}});
    return 1;
  }
  program.log().Info("how meshes are read", {{"mesh_sandbox", sandbox_name}});
  const auto slicing = slicefarm::slicing::MakeLocalSlicing(*std::move(meshes));
  const auto arranging = slicefarm::slicing::MakeLocalArranging(*std::move(meshes_to_arrange));
  const auto placing = slicefarm::slicing::MakeLocalPlacing(*std::move(meshes_to_place));
  slicefarm::rpc::CallLimiter gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  const auto service = slicefarm::slicing::MakeSlicingService(
      *slicing, *arranging, *placing, slicefarm::slicing::MakeReadProjects(*std::move(projects)),
      gate, threads, memory);
  return program.Run(flags, {service.get()});
}
