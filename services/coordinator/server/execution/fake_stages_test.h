#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/geometry/text_format_test.h"
#include "common/stage/motion_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/plates.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/task.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/coordinator/remote/remote_projects.h"

namespace slicefarm {
struct MotionJob;
struct MotionOptions;
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// Fake stages for tests of the coordinator. The bytes of a mesh control the stage:
/// - `x`: a layer
/// - `!`: slicing fails (MESH_MALFORMED)
/// - `~`: slicing is unreachable (UNAVAILABLE)
/// - `?`: slicing is of another build (BUILD_MISMATCH)
class FakeSlicing : public SlicingStage {
 public:
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions&) const override {
    ++runs_;
    {
      const std::lock_guard lock(mutex_);
      traces_.push_back(call.trace);
    }
    SlicedJob job;
    const std::string& bytes = input.files.at(0).bytes;
    if (bytes.find('!') != std::string::npos) {
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, "a bad mesh",
                       {{"line", "7"}});
    }
    if (bytes.find('?') != std::string::npos && mismatches_-- > 0) {
      return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, "old");
    }
    if (bytes.find('~') != std::string::npos && unavailable_-- > 0) {
      return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "not there");
    }
    for (int32_t i = 0; i < std::ssize(bytes); ++i) {
      SlicedLayer layer;
      layer.frame = {i, FromMm(0.2) * (i + 1), FromMm(0.2)};
      for (const ObjectInput& object : input.objects)
        layer.sections.push_back(Square(object, layer, std::ssize(bytes)));
      job.layers.push_back(std::move(layer));
    }
    if (input.advise_orientations) job.orientations = {{"part", {0, 90, 0}, {}, {}}};
    job.meshes.resize(input.objects.size());
    for (const ObjectInput& object : input.objects) {
      const auto index = static_cast<int32_t>(job.object_names.size());
      job.object_names.push_back(object.name);
      job.copies.insert(job.copies.end(), object.copies.size(), PlacedCopy{index, {}, {}});
    }
    return job;
  }

  /// Returns the number of calls.
  int runs() const { return runs_; }
  /// Returns the trace contexts of the calls.
  std::vector<TraceContext> traces() const {
    const std::lock_guard lock(mutex_);
    return traces_;
  }
  mutable std::atomic<int> unavailable_ = 0;  ///< number of calls that fail because of `~`
  mutable std::atomic<int> mismatches_ = 0;   ///< number of calls that fail because of `?`

 private:
  /// Returns the section of the layer's next object.
  static ObjectSection Square(const ObjectInput& object, const SlicedLayer& layer,
                              int64_t layer_count) {
    ObjectSection section;
    section.stack = static_cast<int32_t>(layer.sections.size());
    section.layer = layer.frame.index;
    section.layer_count = static_cast<int32_t>(layer_count);
    section.height_nm = layer.frame.height_nm;
    section.regions = {{.settings = object.parts.at(0).regions.back(),
                        .outlines = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9)")}};
    return section;
  }

  mutable std::atomic<int> runs_ = 0;
  mutable std::mutex mutex_;
  mutable std::vector<TraceContext> traces_;
};

/// Arranging stage that puts each unplaced copy on a plate of its own. Refuses a mesh with a `!`,
/// as slicing does.
class FakeArranging : public ArrangingStage {
 public:
  absl::StatusOr<std::vector<PlatePosition>> PutOnPlates(const StageCall& call, SliceInput input,
                                                         const SlicingOptions&) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    ++runs_;
    for (const MeshFile& file : input.files)
      if (file.bytes.find('!') != std::string::npos)
        return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, "a bad mesh");
    std::vector<PlatePosition> positions;
    int32_t plates = 0;
    for (const ObjectInput& object : input.objects)
      for (const CopyInput& copy : object.copies)
        positions.push_back(
            {copy.place == CopyInput::Place::kAnywhere ? plates++ : 0, {FromMm(50), 0}});
    return positions;
  }
  /// Returns the number of calls.
  int runs() const { return runs_; }

 private:
  mutable std::atomic<int> runs_ = 0;
};

/// Project reader that returns one plate for each `p` in a file. Refuses a file with a `!`.
class FakeProjects : public ProjectReader {
 public:
  absl::StatusOr<v1::ReadProjectResponse> Read(const StageCall& call,
                                               MeshFile file) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    if (file.bytes.find('!') != std::string::npos)
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, "a bad project");
    v1::ReadProjectResponse project;
    project.set_application("fake");
    for (const char c : file.bytes) {
      if (c != 'p') continue;
      v1::ReadProjectResponse::Plate& plate = *project.add_plates();
      plate.set_number(project.plates_size());
      plate.mutable_spec()->add_objects()->set_mesh_sha256(Sha256Hex(file.bytes));
    }
    return project;
  }
};

/// Planning stage that returns the given copies and empty layers.
class FakePlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                               const PlanningOptions&) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    JobPlan plan;
    plan.layers.resize(job.layers.size());
    for (const PlacedCopy& copy : job.copies) plan.copies.push_back({copy.object, copy.shift});
    return plan;
  }
};

/// Motion stage that supports only the frame of a program.
class FakeMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&, std::vector<OrderedLayer>,
                                                    const Shared<MotionJob>&) const override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall&, const ProgramSummary& summary,
                                           const MotionOptions&) const override {
    ProgramEnvelope frame;
    frame.prologue = "; " + summary.copies.at(0).name.object_name + "\n";
    frame.epilogue = "; end\n";
    frame.times.travel_s = summary.total.TimeS();
    return frame;
  }
};

/// Runner that returns programs of one line per layer. While it is held, calls wait until they are
/// released or cancelled.
class FakeRanges : public FdmRunner {
 public:
  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override {
    ++calls_;
    {
      std::unique_lock lock(mutex_);
      waiting_ = true;
      changed_.notify_all();
      while (held_ && !call.cancel.Cancelled()) {
        changed_.wait_for(lock, std::chrono::milliseconds(5));
      }
    }
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) {
      ++cancelled_;
      return wanted;
    }
    FdmResult result;
    for (const Stage stage : {Stage::kBeading, Stage::kInfill, Stage::kOrdering})
      result.times[stage] = 0.001;
    for (int i = task.range.first; i < task.range.last; ++i) {
      LayerProgram program;
      program.frame.index = i;
      program.gcode = absl::StrCat("G1 X", i, "\n");
      program.gcode.resize(std::max(program.gcode.size(), bytes_a_layer_.load()), ' ');
      program.stats.features[0] = {1, 2, 3, 4};
      result.programs.push_back(std::move(program));
    }
    return result;
  }

  /// Makes later calls wait.
  void Hold() {
    std::lock_guard lock(mutex_);
    held_ = true;
    waiting_ = false;
  }
  /// Releases all calls.
  void LetGo() {
    std::lock_guard lock(mutex_);
    held_ = false;
    changed_.notify_all();
  }
  /// Waits until a call is waiting.
  void AwaitCall() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_; });
  }
  /// Returns the number of calls that were cancelled.
  int cancelled() const { return cancelled_; }
  std::atomic<size_t> bytes_a_layer_ = 0;  ///< smallest size of a layer's program

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  bool held_ = false;
  mutable bool waiting_ = false;
  mutable std::atomic<int> calls_ = 0;
  mutable std::atomic<int> cancelled_ = 0;
};

}  // namespace slicefarm::coordinator
