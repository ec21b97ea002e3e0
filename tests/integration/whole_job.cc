#include "tests/integration/whole_job.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "common/stage/slice_input_test.h"
#include "processes/list/jobs.h"
#include "services/cli/local/local_pipeline.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "tests/corpus_file.h"

namespace slicefarm {
namespace {

absl::StatusOr<std::string> GcodeBy(const coordinator::JobPipeline& pipeline,
                                    const std::function<void(int32_t)>& layers_done) {
  StageCall call;
  call.job_id = "textbox";
  absl::StatusOr<coordinator::JobOutput> output =
      pipeline.Run(call, {TextBox(), {}, "perimeters = 3\n"},
                   [&](const coordinator::PipelineProgress& progress) {
                     if (layers_done) layers_done(progress.done);
                   });
  if (!output.ok()) return output.status();
  return output->program.Whole();
}

std::string Computed() {
  absl::StatusOr<std::string> gcode = GcodeBy(cli::LocalPipeline(1).pipeline(), {});
  if (!gcode.ok()) {
    std::fprintf(stderr, "%s\n", gcode.status().ToString().c_str());
    std::abort();
  }
  return *std::move(gcode);
}

}  // namespace

SliceInput TextBox() {
  return InputOf({{"textbox.stl", MeshFormat::kStl, CorpusFile("models/textbox.stl")}});
}

absl::StatusOr<std::string> GcodeOf(const SlicingStage& slicing, const PlanningStage& planning,
                                    const MotionStage& motion, coordinator::Dispatcher& dispatcher,
                                    const std::function<void(int32_t)>& layers_done) {
  const Stages stages = {.slicing = &slicing, .planning = &planning, .motion = &motion};
  return GcodeBy(coordinator::JobPipeline(JobsOver(stages, ""), dispatcher), layers_done);
}

const std::string& GcodeOfThisProcess() {
  static const std::string gcode = Computed();
  return gcode;
}

}  // namespace slicefarm
