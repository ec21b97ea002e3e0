#include <CLI/CLI.hpp>

#include "common/rpc/serve.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/motion/server/motion_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("motion");
  CLI::App app("slicefarm-motion: Paths to G-code, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  CLI11_PARSE(app, argc, argv);

  const auto stage = slicefarm::motion::MakeLocalMotion();
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  slicefarm::motion::MotionService service(*stage, gate, flags.threads);
  return program.Run(flags, {&service});
}
