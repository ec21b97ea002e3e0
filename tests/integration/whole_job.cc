#include "tests/integration/whole_job.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "common/stage/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/coordinator/algo/job_pipeline.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/corpus_file.h"

namespace slicefarm {
namespace {

std::string Computed() {
  const auto slicing = slicing::MakeLocalSlicing();
  const auto beading = beading::MakeLocalBeading();
  const auto infill = infill::MakeLocalInfill();
  const auto ordering = ordering::MakeLocalOrdering();
  const auto motion = motion::MakeLocalMotion();
  coordinator::Dispatcher dispatcher;
  dispatcher.Join({.name = "here",
                   .ranges = std::make_shared<LayerChain>(*beading, *infill, *ordering, *motion)});
  absl::StatusOr<std::string> gcode = GcodeOf(*slicing, *motion, dispatcher);
  if (!gcode.ok()) {
    std::fprintf(stderr, "%s\n", gcode.status().ToString().c_str());
    std::abort();
  }
  return *std::move(gcode);
}

}  // namespace

SliceInput TextBox() {
  SliceInput input;
  input.files = {{"textbox.stl", MeshFormat::kStl, CorpusFile("models/textbox.stl")}};
  input.placements.resize(1);
  return input;
}

JobSettings JobSettingsOfTest() { return {}; }

absl::StatusOr<std::string> GcodeOf(const SlicingStage& slicing, const MotionStage& motion,
                                    coordinator::Dispatcher& dispatcher,
                                    const std::function<void(int32_t)>& layers_done) {
  const coordinator::JobPipeline pipeline(slicing, motion, dispatcher);
  StageCall call;
  call.job_id = "textbox";
  absl::StatusOr<coordinator::JobOutput> output =
      pipeline.Run(call, {TextBox(), JobSettingsOfTest(), "perimeters = 3\n"},
                   [&](const coordinator::PipelineProgress& progress) {
                     if (layers_done) layers_done(progress.layers_done);
                   });
  if (!output.ok()) return output.status();
  return std::move(output->gcode);
}

const std::string& GcodeOfThisProcess() {
  static const std::string gcode = Computed();
  return gcode;
}

}  // namespace slicefarm
