#include <CLI/CLI.hpp>

#include "common/rpc/server/serve.h"
#include "common/stage/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/worker/server/worker_service.h"

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("worker");
  CLI::App app("slicefarm-worker: the four layer stages in one process, as a gRPC service");
  slicefarm::rpc::ServeFlags flags;
  AddServeFlags(app, &flags);
  app.add_option("--slots", flags.max_concurrent, "Ranges worked on at once; 0: one for each core")
      ->check(CLI::Range(0, 1024));
  CLI11_PARSE(app, argc, argv);

  const auto beading = slicefarm::beading::MakeLocalBeading();
  const auto infill = slicefarm::infill::MakeLocalInfill();
  const auto ordering = slicefarm::ordering::MakeLocalOrdering();
  const auto motion = slicefarm::motion::MakeLocalMotion();
  const slicefarm::LayerChain chain(*beading, *infill, *ordering, *motion);
  slicefarm::rpc::CallGate gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  slicefarm::worker::WorkerService service(chain, gate);
  return program.Run(flags, {&service});
}
