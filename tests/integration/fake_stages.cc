#include "tests/integration/fake_stages.h"

#include <utility>

#include "common/geometry/text_format_test.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/stage/print_layers.h"
#include "common/stage/slice_input_test.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm {
namespace {

constexpr Coord kHeightNm = 200'000;

LayerFrame FrameOf(int32_t index) { return {index, kHeightNm * (index + 1), kHeightNm}; }

Path PathOf(Feature feature, const char* text, bool closed) {
  Path path;
  path.feature = feature;
  path.closed = closed;
  path.points = MakeLineOrDie(text);
  path.widths_nm.assign(path.points.size(), 450'000);
  return path;
}

MultiPolygon Islands() {
  return MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) ; (20 0, 30 0, 30 10)");
}

ObjectSection SectionOf(Stack stack, int32_t layer, std::vector<Region> regions) {
  ObjectSection section;
  section.stack = stack;
  section.layer = layer;
  section.layer_count = Sample::kLayerCount;
  section.height_nm = kHeightNm;
  section.regions = std::move(regions);
  return section;
}

SlicedLayer OutlinesOf(int32_t index) {
  SlicedLayer layer{FrameOf(index), {}};
  const MultiPolygon whole = Islands();
  layer.sections.push_back(
      SectionOf(0, index, {{Role::kPart, 0, 0, {whole[0]}}, {Role::kPart, 1, 0, {whole[1]}}}));
  layer.sections.back().whole = whole;
  layer.sections.push_back(SectionOf(2, index, {{Role::kPart, 1, 0, whole}}));
  if (index == Sample::kRange.first) {
    const Stack brim(3, kPlateObject, StackKind::kBrim);
    layer.sections.push_back(SectionOf(brim, 0, {{Role::kBrim, 0, 0, Islands()}}));
    layer.sections.back().layer_count = 1;
  }
  return layer;
}

void AddProgram(int32_t index, int32_t pass, Sample* sample) {
  LayerProgram program;
  program.frame = FrameOf(index);
  program.pass = pass;
  program.gcode = "G1 X" + std::to_string(index) + " Y" + std::to_string(pass) + "\n";
  program.entry = {0, 0};
  program.exit = {8'000'000, 8'000'000};
  program.stats.features[0] = {1, 2, 3, 4};
  program.stats.bounds = {{0, 0}, {9, 9}};
  sample->programs.push_back(program);
}

void AddLayer(int32_t index, Sample* sample) {
  const LayerFrame frame = FrameOf(index);
  Path wall = PathOf(Feature::kExternalPerimeter, "(0 0, 9 0, 9 9, 0 9)", true);
  wall.ring = 0;
  Path line = PathOf(Feature::kSolidInfill, "(1 1, 8 8)", false);
  line.settings = 1;
  const Path skirt = PathOf(Feature::kSkirt, "(-5 -5, 40 -5)", false);
  const std::vector<FillArea> areas = {{Role::kPart, 0, 0, Islands()},
                                       {Role::kPart, 1, 0, Islands()}};
  sample->walled.push_back({frame, {{0, index, kHeightNm, {{{wall}, areas}}}}, index});
  sample->filled.push_back({frame,
                            {{0,
                              index,
                              kHeightNm,
                              {{{wall}, {{true, {line, line}}}}},
                              {{.settings = 1, .pattern = FillPattern::kGrid}}}}});
  sample->plans.push_back(
      {{1, 2},
       index % 2 != 0,
       index % 2 == 0,
       {{0, {3, 4}, Point{8, index}, {{5, index}}}, {2, {6, 7}, {}, {}}},
       {skirt},
       {{0, 0, FillPattern::kLightning, {{{1, 2}, {3, index}}}, {}, {}, 0, {{5, index}}}}});
  sample->ordered.push_back(
      {frame,
       {{kSkirtStack, 0, kHeightNm, {skirt}}, {0, index, kHeightNm, {wall, line, line}}},
       {{0, -1, 0, {}}, {1, 0, 0, {1'000, -2'000}}, {1, 1, 1, {}}}});
  AddProgram(index, 0, sample);
  if (index == Sample::kRange.first) AddProgram(index, 1, sample);
}

SliceInput InputWithAll() {
  SliceInput input = InputOf({{"a.stl", MeshFormat::kStl, std::string(150'000, 'a')},
                              {"empty.obj", MeshFormat::kObj, ""},
                              {"b", MeshFormat::kUnknown, std::string("b\0b", 3)}},
                             {{.scale = {1, 2, 3}}, {}, {.centers = {{1, 2}, {3, 4}}}});
  ObjectInput& object = input.objects[2];
  object.ranges = {{1'000'000, 2'000'000, 100'000}};
  object.copies.push_back({CopyInput::Place::kOriginAt, {5, 6}});
  object.sunk_mm = 0.5;
  object.parts[0].regions = {1, 0};
  PartInput modifier;
  modifier.name = "modifier";
  modifier.mesh = {2, 1, 12, 24};
  modifier.role = PartRole::kModifier;
  modifier.to_object.col(3) << 1, 2, 3;
  modifier.regions.clear();
  modifier.changes = {{0, 1}, {1, 0}};
  object.parts.push_back(modifier);
  return input;
}

/// Returns tables of two rows. The second row has no default values.
JobSettings SettingsWithAll() {
  JobSettings settings;
  settings.slicing.objects.resize(3);
  settings.slicing.objects[2].layer_height_nm = 123'000;
  FdmOf(settings).objects.resize(3);
  FdmOf(settings).objects[2].seam = SeamPosition::kRear;
  FdmOf(settings).regions.resize(2);
  FdmOf(settings).regions[1].walls.perimeters = 7;
  FdmOf(settings).regions[1].infill.density = 0.33;
  FdmOf(settings).machine.order.infill_first = true;
  FdmOf(settings).regions[1].order.inner_outer_inner = true;
  FdmOf(settings).regions[1].motion.small_perimeter_speed_mm_s = 7;
  FdmOf(settings).machine.motion.start_gcode = "G28\n";
  FdmOf(settings).machine.motion.labels = ObjectLabels::kFirmware;
  return settings;
}

JobPlan PlanWithAll(std::span<const SlicedLayer> outlines) {
  JobPlan plan;
  const Stack brim(3, 0, StackKind::kBrim);
  plan.stacks = {{brim, 5'000, {SectionOf(brim, 0, {{Role::kBrim, 1, 0, Islands()}})}}};
  plan.skirt = {{PathOf(Feature::kSkirt, "(-5 -5, 40 -5)", false)}, 2};
  plan.lifts_nm = {300'000, 0, 0};
  const size_t layers = PrintLayerCount(outlines, plan.lifts_nm, plan.stacks);
  for (size_t i = 0; i < layers; ++i)
    plan.layers.push_back(
        {{1, static_cast<Coord>(i)}, false, false, {{0, {2, 3}, {}, {{4, 5}}}}, {}, {}});
  plan.copies = {{0, {1'000, -2'000}, 0}, {0, {}, 1}, {2, {7'000, 0}, 0}};
  plan.seams = {9, 8, 1, 2.5, 4, 3, 1};
  return plan;
}

Sample MakeSample() {
  Sample sample;
  sample.input = InputWithAll();
  for (int32_t i = 0; i < 3; ++i) sample.job.layers.push_back(OutlinesOf(i));
  sample.job.object_names = {"a.stl", "empty.obj", "b"};
  sample.job.copies = {{0, {1'000, -2'000}, {{0, 0}, {9, 0}, {9, 9}}}, {0, {}, {}}, {2, {}, {}}};
  sample.job.meshes.resize(3);
  sample.job.meshes[1].triangles = 12;
  sample.job.thumbnails = {{32, 32, "\x89PNG"}};
  sample.plan = PlanWithAll(sample.job.layers);
  for (int32_t i = 2; i < 6; ++i) sample.outlines.push_back(OutlinesOf(i));
  for (int32_t i = Sample::kRange.first; i < Sample::kRange.last; ++i) AddLayer(i, &sample);
  sample.facts = {Sample::kLayerCount,
                  {{"a.stl", 0, 0, 2}, {"a.stl", 0, 1, 2}, {"b", 2, 0, 1}},
                  {{0, 0, 0}, {3, 1, 600'000}}};
  sample.warnings = {{Sample::kRange.first, 2}};
  sample.fills = {{.settings = 1, .pattern = FillPattern::kGrid, .paths = 8}, {}};
  for (int32_t i = Sample::kRange.first; i < Sample::kRange.last; ++i) {
    ExposedProgram& exposed = sample.exposed.emplace_back();
    exposed.frame = FrameOf(i);
    exposed.text = "exposed\n";
    exposed.report.jumps = i;
  }
  sample.summary.layers = {{FrameOf(0), 1, {1, 2}, {3, 4}, 5, false, {}}};
  sample.summary.copies = {{{"a.stl", 0, 1, 2}, {{0, 0}, {9, 0}, {9, 9}}}};
  sample.summary.settings_text = "perimeters = 3\n";
  PrintTimes times;
  times.travel_s = 12.5;
  times.layer_s = {5};
  sample.frame = {"start\n",        {"", "M73 P50\n"}, "end\n",  times,    30,
                  {"", "; code\n"}, "head\n",          "tail\n", "a.gcode"};
  sample.settings = SettingsWithAll();
  sample.exposure_settings.regions.resize(2);
  sample.exposure_settings.regions[1].spot_nm = 77;
  double seconds = 0;
  for (const Stage stage : {Stage::kBeading, Stage::kInfill, Stage::kOrdering, Stage::kMotion})
    sample.times[stage] = ++seconds;
  return sample;
}

/// Records the call, then runs the action of the test.
absl::Status Begin(const StageCall& call, FakeStages* fakes) {
  fakes->call = call;
  return fakes->before(call);
}

template <typename Layers>
Layers Answer(Layers layers, const FakeStages& fakes) {
  if (fakes.lose_a_layer) layers.pop_back();
  return layers;
}

void Note(const Neighbourhood& neighbourhood, FakeStages* fakes) {
  fakes->range = neighbourhood.range;
  fakes->layers.assign(neighbourhood.layers.begin(), neighbourhood.layers.end());
}

}  // namespace

const Sample& TheSample() {
  static const Sample sample = MakeSample();
  return sample;
}

absl::StatusOr<SlicedJob> FakeSlicing::Slice(const StageCall& call, SliceInput input,
                                             const SlicingOptions& options) const {
  fakes_.slice_input = std::move(input);
  fakes_.slicing_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return TheSample().job;
}

grpc::Status FakePlanning::PlanJob(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::PlanResponse, v1::PlanRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "PlanJob", [&](rpc::Call& call) { return Plan(call, buffered); });
}

absl::Status FakePlanning::Plan(rpc::Call& call, Stream& stream) {
  absl::StatusOr<PlanStart> start = ReadStart<v1::PlanRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  fakes_.placed = start->copies;
  fakes_.planning_options = start->options;
  fakes_.layers.clear();
  absl::Status status = ReadEach<v1::PlanRequest>(stream, [&](const v1::PlanRequest& request) {
    return AppendNext(FromProto(request.layer()), &fakes_.layers);
  });
  if (!status.ok()) return status;
  if (status = Begin(start->call, &fakes_); !status.ok()) return status;
  const JobPlan& plan = TheSample().plan;
  status = WriteEach<v1::PlanResponse>(stream, Answer(plan.layers, fakes_),
                                       [](const LayerPlan& layer, v1::PlanResponse* proto) {
                                         return ToProto(layer, proto->mutable_layer());
                                       });
  for (const AddedStack& added : plan.stacks) {
    v1::PlanResponse head;
    status.Update(ToProto(added, head.mutable_stack()));
    stream.Write(head);
    status.Update(WriteEach<v1::PlanResponse>(
        stream, added.sections, [](const ObjectSection& section, v1::PlanResponse* proto) {
          return ToProto(section, proto->mutable_section());
        }));
  }
  v1::PlanResponse skirt;
  status.Update(ToProto(plan.skirt, skirt.mutable_skirt()));
  stream.Write(skirt);
  v1::PlanResponse end;
  end.mutable_end()->mutable_lifts_nm()->Assign(plan.lifts_nm.begin(), plan.lifts_nm.end());
  *end.mutable_end()->mutable_seams() = ToProto(plan.seams);
  for (const Copy& copy : plan.copies) {
    status.Update(ToProto(copy, end.mutable_end()->add_copies()));
  }
  stream.Write(end);
  return status;
}

absl::StatusOr<std::vector<WalledLayer>> FakeBeading::Bead(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<BeadingTable>& regions) const {
  Note(neighbourhood, &fakes_);
  fakes_.beading_options = *regions;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().walled, fakes_);
}

absl::StatusOr<std::vector<FilledLayer>> FakeInfill::Fill(
    const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
    std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const {
  Note(neighbourhood, &fakes_);
  fakes_.infill_plans.assign(plans.begin(), plans.end());
  fakes_.walled = std::move(walled);
  fakes_.infill_options = *regions;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().filled, fakes_);
}

absl::StatusOr<std::vector<OrderedLayer>> FakeOrdering::Order(
    const StageCall& call, std::vector<FilledLayer> layers, std::span<const LayerPlan> plans,
    const Shared<OrderingJob>& job) const {
  fakes_.filled = std::move(layers);
  fakes_.plans.assign(plans.begin(), plans.end());
  fakes_.copies = job->copies;
  fakes_.ordering_options = job->options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().ordered, fakes_);
}

absl::StatusOr<std::vector<LayerProgram>> FakeMotion::Program(const StageCall& call,
                                                              std::vector<OrderedLayer> layers,
                                                              const Shared<MotionJob>& job) const {
  fakes_.ordered = std::move(layers);
  fakes_.facts = job->facts;
  fakes_.motion_options = job->options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().programs, fakes_);
}

absl::StatusOr<ProgramEnvelope> FakeMotion::Envelope(const StageCall& call,
                                                     const ProgramSummary& summary,
                                                     const MotionOptions& options) const {
  fakes_.summary = summary;
  fakes_.motion_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return TheSample().frame;
}

absl::StatusOr<std::vector<ExposedProgram>> FakeExposure::Expose(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<ExposureJob>& job) const {
  Note(neighbourhood, &fakes_);
  fakes_.copies = job->copies;
  fakes_.exposure = job->settings;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().exposed, fakes_);
}

absl::StatusOr<ExposureEnvelope> FakeExposure::Envelope(const StageCall& call,
                                                        const ExposureSummary& summary,
                                                        const ExposureSettings& settings) const {
  fakes_.exposure_summary = summary;
  fakes_.exposure = settings;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return ExposureEnvelope{"header", {"head"}, "footer"};
}

absl::StatusOr<FdmResult> RunFdm(const TaskRunner& runner, const StageCall& call,
                                 const FdmTask& task) {
  absl::StatusOr<TaskResult> result = runner.RunTask(call, task);
  if (!result.ok()) return result.status();
  return std::move(result->As<FdmResult>());
}

absl::StatusOr<FdmResult> FakeRunner::Run(const StageCall& call, const FdmTask& task) const {
  Note({task.range, task.layers}, &fakes_);
  fakes_.plans.assign(task.plans.begin(), task.plans.end());
  fakes_.copies = task.job->copies;
  fakes_.facts = task.job->facts;
  fakes_.fdm_settings = task.job->settings;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  const Sample& sample = TheSample();
  return FdmResult{Answer(sample.programs, fakes_), sample.warnings, sample.fills, sample.times};
}

}  // namespace slicefarm
