#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/plate.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/cutter_text.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/fields/fields.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/scene_wire.h"
#include "common/wire/slicing_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/wire/fdm_work.h"
#include "processes/mill/wire/mill_work.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/texture/algo/local_texture_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/seeds.h"

// Writes seeds for the fuzzers of calls: the calls of a small job, as its stages receive them.
//
//   make_seeds tests/corpus/fuzz

namespace slicefarm::fuzz {
namespace {

/// Returns the value, or aborts if there is an error.
template <typename T>
T Must(absl::StatusOr<T> value) {
  if (value.ok()) return *std::move(value);
  std::fprintf(stderr, "%s\n", value.status().ToString().c_str());
  std::abort();
}
void Must(const absl::Status& status) {
  if (!status.ok()) Must<int>(status);
}

/// Seeds have no build id, because the fuzzers fill in their own.
template <typename Start>
void Anonymous(Start* start) {
  start->mutable_call()->clear_build_id();
}

/// A job in all intermediate states.
struct Job {
  JobSettings settings;
  StageCall call;
  SliceInput input;
  SlicedJob sliced;
  JobPlan plan;
  JobFacts facts;
  LayerRange range;  ///< with neighbours on both sides

  Neighbourhood neighbourhood() const { return {range, sliced.layers}; }
  std::vector<LayerPlan> plans() const {
    return {plan.layers.begin() + range.first, plan.layers.begin() + range.last};
  }
};

std::vector<Setting> Given(std::span<const std::pair<const char*, const char*>> settings) {
  std::vector<Setting> given;
  for (const auto& [key, value] : settings) given.push_back({key, value});
  return given;
}

SceneObject Box() { return ObjectOfFile("box.obj", 0, {}, 1); }

/// Returns two copies of a box. Its lower part and one corner have settings of their own.
SceneObject BoxesWithModifier() {
  constexpr std::pair<const char*, const char*> kInside[] = {{"fill_density", "100%"},
                                                             {"perimeters", "2"}};
  SceneObject object = ObjectOfFile("box.obj", 0, {}, 2);
  Part modifier = object.parts[0];
  modifier.name = "corner";
  modifier.role = PartRole::kModifier;
  modifier.to_object *= 0.5;
  modifier.settings = Given(kInside);
  object.parts.push_back(modifier);
  constexpr std::pair<const char*, const char*> kLow[] = {{"fill_density", "40%"}};
  object.ranges.push_back({0, 2, Given(kLow)});
  return object;
}

Job JobOf(const SceneObject& object) {
  Job job;
  job.call.job_id = "seed";
  const SceneObject objects[] = {object};
  config::ResolvedPlate plate =
      Must(config::ResolvePlate(Given(kSettings), objects, Process::kFdm));
  job.settings = std::move(plate.settings);
  job.settings.slicing.thumbnails = {{16, 16}};
  job.input.files.push_back({"box.obj", MeshFormat::kObj, std::string(kBox)});
  job.input.objects = std::move(plate.objects);
  return job;
}

void WriteSliceSeed(const Seeds& seeds, const std::string& name, Job& job) {
  SliceCall slice;
  v1::SliceStart& start = *slice.add_requests()->mutable_start();
  Must(ToProto(job.call, job.input, job.settings.slicing, &start));
  Anonymous(&start);
  slice.add_requests()->set_chunk(std::string(kBox));
  seeds.Write("slicing", name, slice);
  job.sliced = Must(slicing::MakeLocalSlicing()->Slice(job.call, job.input, job.settings.slicing));
  const auto count = static_cast<int32_t>(job.sliced.layers.size());
  job.range = {1, count - 1};
  job.facts.layer_count = count;
  const auto copies = static_cast<int32_t>(job.sliced.copies.size());
  for (int32_t i = 0; i < copies; ++i) job.facts.copies.push_back({"box.obj", 0, i, copies});
}

void WritePlanSeed(const Seeds& seeds, const std::string& name, Job& job) {
  PlanCall plan;
  v1::PlanStart& start = *plan.add_requests()->mutable_start();
  Must(ToProto(PlanStart{job.call, PlanningOf(FdmOf(job.settings)), job.sliced.copies,
                         job.sliced.object_names},
               &start));
  Anonymous(&start);
  for (const SlicedLayer& layer : job.sliced.layers)
    Must(ToProto(layer, plan.add_requests()->mutable_layer()));
  seeds.Write("planning", name, plan);
  job.plan = Must(planning::MakeLocalPlanning()->Plan(
      job.call, {job.sliced.layers, job.sliced.copies}, PlanningOf(FdmOf(job.settings))));
}

void WriteWorkSeed(const Seeds& seeds, const std::string& name, const Job& job) {
  WorkCall work;
  v1::WorkStart& start = *work.add_requests()->mutable_start();
  *start.mutable_call() = ToProto(job.call);
  Must(ToProto(FdmWork{job.range, job.plans()}, start.mutable_fdm()));
  Must(ToProto(FdmShared{FdmOf(job.settings), job.plan.copies, job.facts}, work.mutable_fdm()));
  Anonymous(&start);
  for (const SlicedLayer& layer : job.sliced.layers)
    Must(ToProto(layer, work.add_requests()->mutable_layer()));
  seeds.Write("worker", name, work);
}

std::vector<WalledLayer> WriteBeadSeeds(const Seeds& seeds, const std::string& name,
                                        const Job& job) {
  BeadCall bead;
  v1::StageStart& start = *bead.add_requests()->mutable_start();
  Must(ToProto(StageStart{job.call, {}, job.range}, &start));
  Must(ToProto(BeadingOf(FdmOf(job.settings)), bead.mutable_shared()));
  Anonymous(&start);
  for (const SlicedLayer& layer : job.sliced.layers)
    Must(ToProto(layer, bead.add_requests()->mutable_layer()));
  seeds.Write("beading", name, bead);
  BeadingTable classic = BeadingOf(FdmOf(job.settings));
  for (BeadingOptions& options : classic) options.generator = WallGenerator::kClassic;
  Must(ToProto(classic, bead.mutable_shared()));
  seeds.Write("beading", name + "_classic", bead);
  return Must(beading::MakeLocalBeading()->Bead(job.call, job.neighbourhood(),
                                                BeadingOf(FdmOf(job.settings))));
}

std::vector<FilledLayer> WriteFillSeed(const Seeds& seeds, const std::string& name, const Job& job,
                                       std::vector<WalledLayer> walled) {
  FillCall fill;
  v1::StageStart& start = *fill.add_requests()->mutable_start();
  Must(ToProto(StageStart{job.call, {}, job.range}, &start));
  Must(ToProto(InfillOf(FdmOf(job.settings)), fill.mutable_shared()));
  Anonymous(&start);
  for (const SlicedLayer& layer : job.sliced.layers)
    Must(ToProto(layer, fill.add_requests()->mutable_neighbour()));
  const std::vector<LayerPlan> plans = job.plans();
  for (size_t i = 0; i < walled.size(); ++i) {
    v1::PlannedWalls& planned = *fill.add_requests()->mutable_layer();
    Must(ToProto(walled[i], planned.mutable_layer()));
    Must(AllToProto(plans[i].infill, "infill", planned.mutable_infill()));
  }
  seeds.Write("infill", name, fill);
  return Must(infill::MakeLocalInfill()->Fill(job.call, std::move(walled), job.neighbourhood(),
                                              plans, InfillOf(FdmOf(job.settings))));
}

std::vector<OrderedLayer> WriteOrderSeed(const Seeds& seeds, const std::string& name,
                                         const Job& job, std::vector<FilledLayer> filled) {
  OrderCall order;
  v1::StageStart& start = *order.add_requests()->mutable_start();
  const OrderingJob shared{OrderingOf(FdmOf(job.settings)), job.plan.copies};
  Must(ToProto(StageStart{job.call, {}, job.range}, &start));
  Must(ToProto(shared, order.mutable_shared()));
  Anonymous(&start);
  const std::vector<LayerPlan> plans = job.plans();
  for (size_t i = 0; i < filled.size(); ++i) {
    v1::PlannedLayer& planned = *order.add_requests()->mutable_layer();
    Must(ToProto(filled[i], planned.mutable_layer()));
    Must(ToProto(plans[i], planned.mutable_plan()));
  }
  seeds.Write("ordering", name, order);
  return Must(ordering::MakeLocalOrdering()->Order(job.call, std::move(filled), plans, shared));
}

void WriteMotionSeed(const Seeds& seeds, const std::string& name, const Job& job,
                     std::vector<OrderedLayer> ordered) {
  MotionCall motion;
  v1::StageStart& start = *motion.add_requests()->mutable_start();
  const MotionJob shared{MotionOf(FdmOf(job.settings)), job.facts};
  Must(ToProto(StageStart{job.call, {}, job.range}, &start));
  Must(ToProto(shared, motion.mutable_shared()));
  Anonymous(&start);
  for (const OrderedLayer& layer : ordered)
    Must(ToProto(layer, motion.add_requests()->mutable_layer()));
  const auto programs =
      Must(motion::MakeLocalMotion()->Program(job.call, std::move(ordered), shared));
  ProgramSummary summary;
  for (const LayerProgram& program : programs) {
    summary.layers.push_back({.frame = program.frame,
                              .pass = program.pass,
                              .entry = program.entry,
                              .exit = program.exit,
                              .time_s = program.stats.TimeS(),
                              .edges = program.edges});
    summary.total.Add(program.stats);
  }
  for (size_t i = 0; i < job.facts.copies.size(); ++i)
    summary.copies.push_back({job.facts.copies[i], job.sliced.copies[i].footprint});
  summary.settings_text = "layer_height = 1\n";
  Must(ToProto(summary, motion.mutable_frame()));
  motion.mutable_frame()->set_options(PackFields(MotionOf(FdmOf(job.settings))));
  seeds.Write("motion", name, motion);
}

/// Writes a laser's calls for the same outlines: of its own stage, and of a worker.
void WriteExposureSeeds(const Seeds& seeds, const std::string& name, const Job& job) {
  ExposureSettings settings;
  settings.regions.resize(FdmOf(job.settings).regions.size());
  constexpr ScanStrategy kStrategies[] = {ScanStrategy::kRings, ScanStrategy::kStripes,
                                          ScanStrategy::kIslands, ScanStrategy::kHatch};
  for (const ScanStrategy strategy : kStrategies) {
    for (ExposureOptions& region : settings.regions) {
      region.strategy = strategy;
      region.hatch_distance_nm = 500'000;
      region.downskin_layers = 1;
    }
    ExposeCall call;
    v1::StageStart& start = *call.add_requests()->mutable_start();
    const ExposureJob shared{settings, job.plan.copies};
    Must(ToProto(StageStart{job.call, {}, job.range}, &start));
    Must(ToProto(shared, call.mutable_shared()));
    Anonymous(&start);
    for (const SlicedLayer& layer : job.sliced.layers)
      Must(ToProto(layer, call.add_requests()->mutable_layer()));
    Must(ToProto(ExposureSummary{{{0, 9, 9}}, {{0, 0}, {9, 9}}, {"box"}, 3, "contours = 1\n"},
                 call.mutable_frame()));
    call.mutable_frame()->set_settings(PackFields(settings));
    const std::string seed = name + std::to_string(static_cast<int>(strategy));
    seeds.Write("exposure", seed, call);
    WorkCall work;
    v1::WorkStart& whole = *work.add_requests()->mutable_start();
    *whole.mutable_call() = ToProto(job.call);
    *whole.mutable_laser()->mutable_range() = ToProto(job.range);
    Must(ToProto(shared, work.mutable_laser()));
    Anonymous(&whole);
    for (const SlicedLayer& layer : job.sliced.layers)
      Must(ToProto(layer, work.add_requests()->mutable_layer()));
    seeds.Write("worker", "laser_" + seed, work);
  }
}

/// Writes the calls of a small block: the call of its own stage with all steps, and a worker's
/// call.
void WriteMillSeeds(const Seeds& seeds) {
  MillInput input;
  constexpr Coord kSide = 6'000'000;
  for (const Coord z : {Coord{0}, Coord{2'000'000}})
    for (const Coord y : {Coord{0}, kSide})
      for (const Coord x : {Coord{0}, kSide}) input.part.vertices.push_back({x, y, z});
  input.part.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const auto stage = milling::MakeLocalMilling();
  for (const char* cutter : {"cyl:3", "ball:3", "bull:3:0.5", "cone:3:45", "ballcone:1:20:3"}) {
    input.settings.how.cutter = *ParseCutter(cutter);
    input.settings.how.finish_stepdown_mm = input.settings.how.finish_stepover_mm = 1;
    const Shared<MillInput> shared(input);
    const auto count = static_cast<int32_t>(Must(stage->LayOut({}, shared)).steps.size());
    MillCall call;
    v1::MillStart& start = *call.add_requests()->mutable_start();
    Must(ToProto(MillStart{{}, {}, {0, count}, count, "stepdown = 1\n"}, &start));
    Anonymous(&start);
    Must(ToProto(input, call.mutable_shared()));
    for (const MilledStep& step : Must(stage->Mill({}, shared, {0, count})))
      Must(ToProto(step, call.add_requests()->mutable_step()));
    const std::string name(cutter, std::string_view(cutter).find(':'));
    seeds.Write("milling", name, call);
    WorkCall work;
    v1::WorkStart& whole = *work.add_requests()->mutable_start();
    *whole.mutable_call() = ToProto(StageCall());
    Must(ToProto(MillTask{{0, count}, MillPhase::kRoughing, 0, 4, {}}, whole.mutable_mill()));
    Must(ToProto(input, work.mutable_mill()));
    Anonymous(&whole);
    seeds.Write("worker", "mill_" + name, work);
  }
}

/// Writes the calls of a roof: the calls of its own stages, and a worker's call.
void WriteEngraveSeeds(const Seeds& seeds) {
  const SurfaceInput surface{{{{0, 0, 0}, {2, 0, 1}, {4, 0, 0}, {0, 3, 0}, {2, 3, 1}, {4, 3, 0}},
                              {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}}};
  EngraveInput input;
  input.surface = Must(texture::MakeLocalTexture()->Map({}, surface));
  input.settings.lines.spacing = "0.5";
  for (const char* kind : {"bumps", "grooves", "letters"}) {
    input.settings.texture.texture = kind;
    input.settings.format = EngraveFormat::kGcode;
    TextureCall call;
    v1::StageStart& start = *call.mutable_request()->mutable_start();
    Must(ToProto(StageStart{{}, {}, {0, 3}}, &start));
    Anonymous(&start);
    Must(ToProto(surface, call.mutable_surface()));
    Must(ToProto(input, call.mutable_shared()));
    seeds.Write("engraving", kind, call);
    WorkCall work;
    v1::WorkStart& whole = *work.add_requests()->mutable_start();
    *whole.mutable_call() = ToProto(StageCall());
    *whole.mutable_engrave()->mutable_range() = ToProto(LayerRange{0, 3});
    Must(ToProto(input, work.mutable_engrave()));
    Anonymous(&whole);
    seeds.Write("worker", std::string("engrave_") + kind, work);
  }
}

/// Writes each stage's call, with the result of the stage before it.
void WriteStageSeeds(const Seeds& seeds, const std::string& name, Job job) {
  WriteSliceSeed(seeds, name, job);
  WritePlanSeed(seeds, name, job);
  WriteWorkSeed(seeds, name, job);
  WriteExposureSeeds(seeds, name, job);
  auto walled = WriteBeadSeeds(seeds, name, job);
  auto filled = WriteFillSeed(seeds, name, job, std::move(walled));
  WriteMotionSeed(seeds, name, job, WriteOrderSeed(seeds, name, job, std::move(filled)));
}

}  // namespace
}  // namespace slicefarm::fuzz

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: make_seeds FOLDER\n"), 1;
  const slicefarm::fuzz::Seeds seeds(argv[1]);
  slicefarm::fuzz::WriteCoordinatorSeeds(seeds);
  slicefarm::fuzz::WriteMillSeeds(seeds);
  slicefarm::fuzz::WriteEngraveSeeds(seeds);
  slicefarm::fuzz::WriteStageSeeds(seeds, "box", slicefarm::fuzz::JobOf(slicefarm::fuzz::Box()));
  slicefarm::fuzz::Job boxes = slicefarm::fuzz::JobOf(slicefarm::fuzz::BoxesWithModifier());
  FdmOf(boxes.settings).machine.motion.labels = slicefarm::ObjectLabels::kFirmware;
  slicefarm::fuzz::WriteStageSeeds(seeds, "boxes", std::move(boxes));
  return 0;
}
