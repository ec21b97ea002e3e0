#include "tests/integration/fake_stages.h"

#include "common/geometry/text_format.h"

namespace slicefarm {
namespace {

LayerFrame FrameOf(int32_t index) { return {index, 200'000 * (index + 1), 200'000}; }

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

SlicedLayer OutlinesOf(int32_t index) { return {FrameOf(index), {{0, Islands()}, {2, Islands()}}}; }

void AddLayer(int32_t index, Sample* sample) {
  const LayerFrame frame = FrameOf(index);
  const Path wall = PathOf(Feature::kExternalPerimeter, "(0 0, 9 0, 9 9, 0 9)", true);
  const Path line = PathOf(Feature::kSolidInfill, "(1 1, 8 8)", false);
  sample->walled.push_back({frame, {{0, {wall}, Islands()}}});
  sample->filled.push_back({frame, {{0, {wall}, {{true, {line, line}}}}}});
  sample->plans.push_back({{1, 2}, {{3, 4}, {5, index}}});
  sample->ordered.push_back({frame, {wall, line, line}});
  LayerProgram program;
  program.frame = frame;
  program.gcode = "G1 X" + std::to_string(index) + "\n";
  program.entry = {0, 0};
  program.exit = {8'000'000, 8'000'000};
  program.stats.features[0] = {1, 2, 3, 4};
  program.stats.bounds = {{0, 0}, {9, 9}};
  sample->programs.push_back(program);
}

Sample MakeSample() {
  Sample sample;
  sample.input.files = {{"a.stl", MeshFormat::kStl, std::string(150'000, 'a')},
                        {"empty.obj", MeshFormat::kObj, ""},
                        {"b", MeshFormat::kUnknown, std::string("b\0b", 3)}};
  sample.input.placements.resize(3);
  sample.input.placements[2].centers = {{1, 2}};
  for (int32_t i = 0; i < 3; ++i) sample.job.layers.push_back(OutlinesOf(i));
  sample.job.object_names = {"a.stl", "b"};
  sample.job.meshes.resize(3);
  sample.job.meshes[1].triangles = 12;
  sample.job.thumbnails = {{32, 32, "\x89PNG"}};
  for (int32_t i = 2; i < 6; ++i) sample.outlines.push_back(OutlinesOf(i));
  for (int32_t i = Sample::kRange.first; i < Sample::kRange.last; ++i) AddLayer(i, &sample);
  sample.summary.layers = {{FrameOf(0), {1, 2}, {3, 4}, 5, false}};
  sample.summary.object_names = {"a.stl"};
  sample.summary.settings_text = "perimeters = 3\n";
  sample.frame = {"start\n", {"", "M73 P50\n"}, "end\n", 12.5, 30};
  sample.settings.slicing.layer_height_nm = 123'000;
  sample.settings.beading.perimeters = 7;
  sample.settings.infill.density = 0.33;
  sample.settings.ordering.infill_first = true;
  sample.settings.motion.start_gcode = "G28\n";
  sample.times = {0, 1, 2, 3, 4};
  return sample;
}

/// What a fake does first: note the call, do what the test wants done.
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
  fakes->layer_count = neighbourhood.layer_count;
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

absl::StatusOr<std::vector<WalledLayer>> FakeBeading::Bead(const StageCall& call,
                                                           const Neighbourhood& neighbourhood,
                                                           const BeadingOptions& options) const {
  Note(neighbourhood, &fakes_);
  fakes_.beading_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().walled, fakes_);
}

absl::StatusOr<std::vector<FilledLayer>> FakeInfill::Fill(const StageCall& call,
                                                          std::vector<WalledLayer> walled,
                                                          const Neighbourhood& neighbourhood,
                                                          const InfillOptions& options) const {
  Note(neighbourhood, &fakes_);
  fakes_.walled = std::move(walled);
  fakes_.infill_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().filled, fakes_);
}

absl::StatusOr<std::vector<OrderedLayer>> FakeOrdering::Order(
    const StageCall& call, std::vector<FilledLayer> layers, std::span<const LayerPlan> plans,
    const OrderingOptions& options) const {
  fakes_.filled = std::move(layers);
  fakes_.plans.assign(plans.begin(), plans.end());
  fakes_.ordering_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().ordered, fakes_);
}

absl::StatusOr<std::vector<LayerProgram>> FakeMotion::Program(const StageCall& call,
                                                              std::vector<OrderedLayer> layers,
                                                              const MotionOptions& options) const {
  fakes_.ordered = std::move(layers);
  fakes_.motion_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return Answer(TheSample().programs, fakes_);
}

absl::StatusOr<ProgramFrame> FakeMotion::Frame(const StageCall& call, const ProgramSummary& summary,
                                               const MotionOptions& options) const {
  fakes_.summary = summary;
  fakes_.motion_options = options;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return TheSample().frame;
}

absl::StatusOr<RangeResult> FakeRunner::Run(const StageCall& call, const RangeTask& task) const {
  Note({task.range, task.layer_count, task.layers}, &fakes_);
  fakes_.plans.assign(task.plans.begin(), task.plans.end());
  fakes_.settings = *task.settings;
  if (absl::Status status = Begin(call, &fakes_); !status.ok()) return status;
  return RangeResult{Answer(TheSample().programs, fakes_), TheSample().times};
}

}  // namespace slicefarm
