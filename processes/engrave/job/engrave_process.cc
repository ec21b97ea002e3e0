#include "processes/engrave/job/engrave_process.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/stage/job_memory.h"
#include "processes/engrave/task/engrave_task.h"

namespace slicefarm::coordinator {
namespace {

/// Part `engraving` of the report of an engraving job.
struct EngraveJobReport : ProcessReport {
  EngraveReport report;

  void AddTo(nlohmann::ordered_json& json) const override { json["engraving"] = JsonOf(report); }
};

/// Indices of the objects that are the surface and the texture of a job.
struct Roles {
  size_t surface = 0;
  size_t texture = 0;  ///< equal to `surface`: no object is the texture
};

absl::StatusOr<Roles> RolesOf(const std::vector<ObjectInput>& objects,
                              const TextureSettings& settings) {
  const auto named = std::ranges::find(objects, settings.texture, &ObjectInput::name);
  const bool is_object = settings.image.empty() && named != objects.end() && objects.size() > 1;
  if (objects.size() != (is_object ? 2u : 1u))
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     "an engraving job needs one object as the surface, and a second one only if "
                     "`texture` names it");
  if (!is_object) return Roles();
  const auto texture = static_cast<size_t>(named - objects.begin());
  return Roles{1 - texture, texture};
}

/// Returns the memory of a surface, in bytes. The job holds this memory until it ends.
int64_t BytesOf(const SurfaceMesh& mesh) {
  return static_cast<int64_t>(mesh.points_mm.size() * sizeof(mesh.points_mm[0]) +
                              mesh.triangles.size() * sizeof(mesh.triangles[0]));
}

int64_t OpenEdgesOf(const SurfaceMesh& mesh) {
  std::vector<std::pair<int32_t, int32_t>> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& corners : mesh.triangles)
    for (size_t k = 0; k < 3; ++k) sides.push_back(std::minmax(corners[k], corners[(k + 1) % 3]));
  std::ranges::sort(sides);
  int64_t open = 0;
  for (size_t i = 0; i < sides.size();) {
    const size_t first = i;
    while (i < sides.size() && sides[i] == sides[first]) ++i;
    open += i - first == 1;
  }
  return open;
}

MeshReport ReportOf(const std::string& name, const SurfaceMesh& mesh) {
  MeshReport report{.name = name,
                    .triangles = std::ssize(mesh.triangles),
                    .vertices = std::ssize(mesh.points_mm),
                    .open_edges = OpenEdgesOf(mesh)};
  if (mesh.triangles.empty()) return report;
  Eigen::Vector3d low = mesh.points_mm[mesh.triangles[0][0]], high = low;
  for (const auto& corners : mesh.triangles) {
    for (const int32_t corner : corners) {
      low = low.cwiseMin(mesh.points_mm[corner]);
      high = high.cwiseMax(mesh.points_mm[corner]);
    }
  }
  report.min_mm = {low.x(), low.y(), low.z()};
  report.max_mm = {high.x(), high.y(), high.z()};
  return report;
}

absl::StatusOr<EngraveInput> InputOf(std::vector<SurfaceMesh> meshes, const Roles& roles,
                                     EngraveSettings settings, MappedSurface surface) {
  auto image = ImageBytes("texture_image", settings.texture.image);
  if (!image.ok()) return image.status();
  auto mask = ImageBytes("mask_image", settings.texture.mask);
  if (!mask.ok()) return mask.status();
  settings.texture.image.clear();
  settings.texture.mask.clear();
  EngraveInput input{
      std::move(settings), {}, *std::move(image), *std::move(mask), std::move(surface)};
  if (roles.texture != roles.surface) input.solid = std::move(meshes[roles.texture]);
  return input;
}

/// A job with the map of its surface.
struct LaidOut {
  Shared<EngraveInput> input;
  EngraveLayout layout;
  MeshReport surface;
};

absl::StatusOr<LaidOut> LayOutJob(const StageCall& call, const PlacingStage& placing,
                                  const TextureStage& texture, JobInput input, StageTimes& times) {
  EngraveSettings& settings = EngraveOf(input.settings);
  const auto roles = RolesOf(input.meshes.objects, settings.texture);
  if (!roles.ok()) return roles.status();
  const std::string name = input.meshes.objects[roles->surface].name;
  auto meshes = Timed(times[Stage::kPlacing], [&] {
    const ScopedSpan span(call.spans, "reading");
    return placing.ReadSurfaces(call, std::move(input.meshes), input.settings.slicing);
  });
  if (!meshes.ok()) return meshes.status();
  const absl::Status held =
      HoldMemory(call, JobMemory::Kind::kMeshes, 4 * BytesOf((*meshes)[roles->surface]));
  if (!held.ok()) return held;
  MeshReport report = ReportOf(name, (*meshes)[roles->surface]);
  const SurfaceInput surface{std::move((*meshes)[roles->surface]), settings.lines.seam};
  auto mapped = Timed(times[Stage::kTexture], [&] {
    const ScopedSpan span(call.spans, "map");
    return texture.Map(call, surface);
  });
  if (!mapped.ok()) return mapped.status();
  auto whole = InputOf(*std::move(meshes), *roles, std::move(settings), *std::move(mapped));
  if (!whole.ok()) return whole.status();
  LaidOut job{*std::move(whole), {}, std::move(report)};
  auto layout = Timed(times[Stage::kTexture], [&] {
    const ScopedSpan span(call.spans, "layout");
    return texture.LayOut(call, job.input);
  });
  if (!layout.ok()) return layout.status();
  if (layout->layer_count == 0)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "the texture has no layer");
  job.layout = *std::move(layout);
  return job;
}

/// Returns the time of a layer. Point files state no time; for them, the tip moves at constant feed
/// rates.
double SecondsOf(const LayerNumbers& numbers, const ProgramFacts& program,
                 const EngraveMachineSettings& machine) {
  if (program.moves > 0) return program.seconds;
  return 60 * (numbers.on_mm / machine.feed_mm_min + numbers.off_mm / machine.link_mm_min);
}

/// Number of layers in an estimate's sample; they are evenly spaced.
constexpr int32_t kSampledLayers = 5;

/// Returns the estimated time of all layers, in s, from a few layers that are made. REQUIRES: the
/// executor has a slot.
absl::StatusOr<double> SampledSeconds(const StageCall& call, const LaidOut& job,
                                      TaskExecutor& executor) {
  const int32_t layers = job.layout.layer_count, samples = std::min(layers, kSampledLayers);
  std::vector<Task> tasks;
  for (int32_t i = 0; i < samples; ++i) {
    const auto layer = static_cast<int32_t>((2 * int64_t{i} + 1) * layers / (2 * samples));
    tasks.emplace_back(EngraveTask{{layer, layer + 1}, job.input});
  }
  std::vector<double> seconds(tasks.size(), 0);
  const EngraveMachineSettings& machine = job.input->settings.machine;
  const auto take = [&](size_t task, TaskResult result) {
    for (const EngravedLayer& layer : result.As<EngraveResult>().layers)
      seconds[task] += SecondsOf(layer.numbers, layer.program, machine);
    return absl::OkStatus();
  };
  if (absl::Status made = executor.Execute(call, tasks, take, nullptr); !made.ok()) return made;
  return layers * std::accumulate(seconds.begin(), seconds.end(), 0.0) / samples;
}

/// A layer of the file. Its text is in a spool.
struct SpooledLayer {
  EngravedLayer layer;  ///< the layer without its text
  SpoolFile::Chunk text;
};

class EngraveJob : public PlannedJob {
 public:
  EngraveJob(LaidOut job, JobReport report, std::unique_ptr<SpoolFile> spool)
      : input_(std::move(job.input)),
        layout_(std::move(job.layout)),
        report_(std::move(report)),
        spool_(std::move(spool)) {}

  int32_t Weight() const override { return layout_.layer_count; }

  /// Returns few tasks with long ranges of layers, because each task calculates the lines of its
  /// layers' styles anew.
  absl::StatusOr<std::vector<Task>> Tasks(int slots) override {
    const int32_t pieces = PieceCount();
    const int32_t parts = std::clamp(2 * slots, 1, pieces);
    std::vector<Task> tasks;
    for (int32_t i = 0; i < parts; ++i) {
      const auto begin = [&](int64_t part) { return static_cast<int32_t>(pieces * part / parts); };
      tasks.emplace_back(EngraveTask{{begin(i), begin(i + 1)}, input_});
    }
    ranges_.resize(tasks.size());
    return tasks;
  }

  absl::Status Take(size_t task, TaskResult result) override {
    auto& made = result.As<EngraveResult>();
    ranges_[task].times = made.times;
    for (EngravedLayer& layer : made.layers) {
      const auto chunk = spool_->Add(layer.text);
      if (!chunk.ok()) return chunk.status();
      std::string().swap(layer.text);
      ranges_[task].layers.push_back({std::move(layer), *chunk});
    }
    return absl::OkStatus();
  }

  absl::StatusOr<JobOutput> Assemble(const StageCall& call) override {
    const ScopedSpan span(call.spans, "assembly");
    std::vector<SpooledLayer> layers;
    for (Range& range : ranges_) {
      report_.stage_times.Add(range.times);
      std::ranges::move(range.layers, std::back_inserter(layers));
    }
    if (absl::Status whole = CheckLayers(layers); !whole.ok()) return whole;
    SpooledText file(std::move(spool_));
    file.Add(std::move(layout_.header));
    for (const SpooledLayer& layer : layers) file.Add(layer.text);
    file.Add(std::move(layout_.footer));
    Report(layers);
    return JobOutput{std::move(file), std::move(report_)};
  }

 private:
  /// Result of one task.
  struct Range {
    std::vector<SpooledLayer> layers;
    StageTimes times;
  };

  bool IsOfLayers() const { return !IsWhole(input_->settings.format); }
  /// Returns the number of texts in the file: one per layer, or one for a format that is a single
  /// whole.
  int32_t PieceCount() const { return IsOfLayers() ? layout_.layer_count : 1; }

  absl::Status CheckLayers(const std::vector<SpooledLayer>& layers) const {
    const int32_t count = PieceCount();
    for (int32_t i = 0; i < static_cast<int32_t>(layers.size()); ++i) {
      const int32_t want = input_->settings.texture.outside ? count - 1 - i : i;
      const int32_t got = layers[static_cast<size_t>(i)].layer.numbers.layer;
      if (got != want)
        return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                         absl::StrCat("layer ", want, " came back as ", got));
    }
    if (std::ssize(layers) == count) return absl::OkStatus();
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     absl::StrCat(layers.size(), " of ", count, " layers came back"));
  }

  void Report(const std::vector<SpooledLayer>& layers) {
    auto own = std::make_unique<EngraveJobReport>();
    own->report.map = layout_.map;
    if (IsOfLayers())
      for (const SpooledLayer& spooled : layers) ReportLayer(spooled.layer, own->report);
    report_.layer_count = layout_.layer_count;
    std::ranges::move(WarningsOf(own->report.map, own->report.layers),
                      std::back_inserter(report_.warnings));
    report_.own = std::move(own);
  }

  void ReportLayer(const EngravedLayer& layer, EngraveReport& engraving) {
    engraving.layers.push_back(layer.numbers);
    engraving.program.Add(layer.program);
    report_.print_time_s += SecondsOf(layer.numbers, layer.program, input_->settings.machine);
    report_.object_height_mm = std::max(report_.object_height_mm, layer.numbers.height_mm);
  }

  const Shared<EngraveInput> input_;
  EngraveLayout layout_;
  JobReport report_;
  std::unique_ptr<SpoolFile> spool_;
  std::vector<Range> ranges_;  ///< one per task
};

}  // namespace

absl::StatusOr<std::unique_ptr<PlannedJob>> EngraveProcess::Plan(const StageCall& call,
                                                                 JobInput input) const {
  JobReport report;
  report.warnings = std::move(input.warnings);
  auto job = LayOutJob(call, placing_, texture_, std::move(input), report.stage_times);
  if (!job.ok()) return job.status();
  report.meshes = {job->surface};
  auto spool = SpoolFile::Make(spool_directory_);
  if (!spool.ok()) return spool.status();
  return std::make_unique<EngraveJob>(*std::move(job), std::move(report), *std::move(spool));
}

absl::StatusOr<JobEstimate> EngraveProcess::Estimate(const StageCall& call, SlicedJob /*sliced*/,
                                                     JobInput input, TaskExecutor& executor) const {
  StageTimes times;
  const auto job = LayOutJob(call, placing_, texture_, std::move(input), times);
  if (!job.ok()) return job.status();
  JobEstimate estimate;
  estimate.layers = job->layout.layer_count;
  estimate.meshes = {job->surface};
  if (IsWhole(job->input->settings.format)) return estimate;  // this format has no toolpaths
  if (executor.Slots(Process::kEngrave) > 0) {
    const auto seconds = SampledSeconds(call, *job, executor);
    if (!seconds.ok()) return seconds.status();
    estimate.print_time_s = *seconds;
    return estimate;
  }
  const MapReport& map = job->layout.map;
  if (map.line_distance_mm.p50 > 0)
    estimate.print_time_s = 60 * job->layout.layer_count * map.area_mm2 /
                            (map.line_distance_mm.p50 * job->input->settings.machine.feed_mm_min);
  return estimate;
}

std::unique_ptr<JobProcess> EngraveProcess::Over(const Stages& stages,
                                                 const std::string& spool_directory) {
  if (stages.placing == nullptr || stages.texture == nullptr) return nullptr;
  return std::make_unique<EngraveProcess>(*stages.placing, *stages.texture, spool_directory);
}

}  // namespace slicefarm::coordinator
