#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/rpc/server/serve.h"
#include "common/rpc/server/shared_store.h"
#include "common/rpc/server/stage_command_line.h"
#include "processes/list/tasks.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/texture/algo/local_texture_stage.h"
#include "services/worker/server/worker_service.h"

namespace {

/// Returns the runners of the processes in `names`; of all processes if `names` is empty.
slicefarm::ProcessRunners RunnersOf(const std::vector<std::string>& names,
                                    const slicefarm::Stages& stages) {
  std::vector<std::shared_ptr<const slicefarm::TaskRunner>> runners;
  for (slicefarm::TaskChain& chain : slicefarm::ChainsOver(stages)) {
    const bool named = std::ranges::find(names, ProcessName(chain.process)) != names.end();
    if (names.empty() || named) runners.push_back(std::move(chain.runner));
  }
  return slicefarm::ProcessRunners(std::move(runners));
}

}  // namespace

int main(int argc, char** argv) {
  slicefarm::rpc::ServerProgram program("worker");
  slicefarm::rpc::ServeFlags flags;
  std::vector<std::string> names, all;
  for (const slicefarm::ProcessInfo& info : slicefarm::kProcesses) all.emplace_back(info.name);
  slicefarm::rpc::StageCommandLine command_line("worker",
                                                "runs all stages of layers in one process", &flags);
  command_line.AddCount(
      "--slots", &flags.max_concurrent,
      "Number of layer ranges that are computed at the same time; 0: one for each core", 0, 1024);
  command_line.AddChoices(
      "--processes", &names,
      "Manufacturing processes that the worker serves, separated by commas; default: all", all);
  if (const auto code = command_line.Parse(argc, argv)) return *code;

  const auto beading = slicefarm::beading::MakeLocalBeading();
  const auto infill = slicefarm::infill::MakeLocalInfill();
  const auto ordering = slicefarm::ordering::MakeLocalOrdering();
  const auto motion = slicefarm::motion::MakeLocalMotion();
  const auto exposure = slicefarm::exposure::MakeLocalExposure();
  const auto milling = slicefarm::milling::MakeLocalMilling();
  const auto texture = slicefarm::texture::MakeLocalTexture();
  const slicefarm::ProcessRunners runners = RunnersOf(names, {.beading = beading.get(),
                                                              .infill = infill.get(),
                                                              .ordering = ordering.get(),
                                                              .motion = motion.get(),
                                                              .exposure = exposure.get(),
                                                              .milling = milling.get(),
                                                              .texture = texture.get()});
  slicefarm::rpc::CallLimiter gate(program.GateOptions(flags), program.log());
  program.Show(gate);
  slicefarm::rpc::SharedStore keeper(program.log());
  program.Show(keeper.cache());
  const auto service = slicefarm::worker::MakeWorkerService(runners, gate, keeper.cache());
  return program.Run(flags, {service.get(), &keeper.service()});
}
