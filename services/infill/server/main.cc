#include <CLI/CLI.hpp>

#include "common/rpc/serve.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/infill/server/infill_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("infill");
  CLI::App app("slicefarm-infill: Skins and infill, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  CLI11_PARSE(app, argc, argv);

  const auto stage = slicefarm::infill::MakeLocalInfill();
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  slicefarm::infill::InfillService service(*stage, gate, flags.threads);
  return program.Run(flags, {&service});
}
