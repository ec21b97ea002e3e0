#include <CLI/CLI.hpp>

#include "common/rpc/serve.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/ordering/server/ordering_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("ordering");
  CLI::App app("slicefarm-ordering: The order and direction of paths, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  CLI11_PARSE(app, argc, argv);

  const auto stage = slicefarm::ordering::MakeLocalOrdering();
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  slicefarm::ordering::OrderingService service(*stage, gate, flags.threads);
  return program.Run(flags, {&service});
}
