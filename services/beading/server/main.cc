#include <CLI/CLI.hpp>

#include "common/rpc/serve.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/beading/server/beading_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("beading");
  CLI::App app("slicefarm-beading: Outlines to walls, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  CLI11_PARSE(app, argc, argv);

  const auto stage = slicefarm::beading::MakeLocalBeading();
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  slicefarm::beading::BeadingService service(*stage, gate, flags.threads);
  return program.Run(flags, {&service});
}
