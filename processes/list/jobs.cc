#include "processes/list/jobs.h"

#include "processes/engrave/job/engrave_process.h"
#include "processes/fdm/job/fdm_process.h"
#include "processes/laser/job/laser_process.h"
#include "processes/mill/job/mill_process.h"

namespace slicefarm {
namespace {

/// Returns the job process over these stages, or null if a stage is missing.
std::unique_ptr<coordinator::JobProcess> JobOver(Process process, const Stages& stages,
                                                 const std::string& spool_directory) {
  switch (process) {
    case Process::kFdm:
      return coordinator::FdmProcess::Over(stages, spool_directory);
    case Process::kLaser:
      return coordinator::LaserProcess::Over(stages, spool_directory);
    case Process::kMill:
      return coordinator::MillProcess::Over(stages, spool_directory);
    case Process::kEngrave:
      return coordinator::EngraveProcess::Over(stages, spool_directory);
  }
  return nullptr;
}

}  // namespace

std::vector<std::unique_ptr<coordinator::JobProcess>> JobsOver(const Stages& stages,
                                                               const std::string& spool_directory) {
  std::vector<std::unique_ptr<coordinator::JobProcess>> jobs;
  for (const ProcessInfo& info : kProcesses)
    if (auto job = JobOver(info.process, stages, spool_directory)) jobs.push_back(std::move(job));
  return jobs;
}

std::vector<Stage> JobStagesOf(Process process) {
  switch (process) {
    case Process::kFdm:
      return {Stage::kSlicing, Stage::kPlanning, Stage::kMotion};
    case Process::kLaser:
      return {Stage::kSlicing, Stage::kExposure};
    case Process::kMill:
      return {Stage::kSlicing, Stage::kMilling};
    case Process::kEngrave:
      return {Stage::kSlicing, Stage::kTexture};
  }
  return {};
}

}  // namespace slicefarm
