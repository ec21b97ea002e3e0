#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/base/shared/shared.h"
#include "common/base/trace_context.h"
#include "common/model/engraving/engrave_input.h"
#include "common/model/engraving/engraved_layer.h"
#include "common/model/exposed_program.h"
#include "common/model/job_facts.h"
#include "common/model/job_plan.h"
#include "common/model/layer.h"
#include "common/model/milling/mill_input.h"
#include "common/model/milling/milled_program.h"
#include "common/model/options/settings.h"
#include "common/model/program_summary.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/orientation_advice.h"
#include "common/model/scene/placed_scene.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

class JobMemory;
class SpanLog;

/// The stages as the pipeline sees them. Each has a local implementation (services/<name>/algo) and
/// a remote one (services/coordinator/remote); the embedded process, the fused worker and the split
/// services run the same pipeline over either, and give the same bytes.
///
/// All stages are pure: same input, same output; safe to call from many threads; safe to call
/// again. Errors: what Reason lists; Cancelled as soon as `call.cancel` asks for it.

/// Tenant and priority, for fair sharing.
struct Claimant {
  std::string tenant;
  int priority = 0;  ///< greater ones first, among the tenant's own
};

struct StageCall {
  std::string job_id;  ///< for logs
  Claimant claimant = {};
  CancelToken cancel;
  int threads = 1;              ///< how many a stage may use; never changes the result
  TraceContext trace = {};      ///< travels on with each call; empty: none
  SpanLog* spans = nullptr;     ///< notes what is done when, in this process; null: nobody asks
  JobMemory* memory = nullptr;  ///< what the job holds in this process; null: nobody counts
};

/// A part of an object as slicing sees it: its settings are rows of the job's tables by now.
struct PartInput {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  /// Of solid parts: the row of the part's region; one for each of ObjectInput::ranges, then that
  /// of all other heights.
  std::vector<int32_t> regions = {0};
  /// Of modifiers: what row a region has inside of it, where it has the first one outside.
  std::map<int32_t, int32_t> changes = {};

  bool operator==(const PartInput&) const = default;
};

/// Heights of an object, above its bottom, with a layer height of their own.
struct RangeInput {
  Coord from_nm = 0;
  Coord to_nm = 0;
  Coord layer_height_nm = 0;

  friend bool operator==(const RangeInput&, const RangeInput&) = default;
};

/// Where a copy stands.
struct CopyInput {
  enum class Place : uint8_t {
    kAnywhere,  ///< to be arranged; alone on the plate: in the middle of the bed
    kMiddleAt,  ///< the middle of the object's box is over `at`
    kOriginAt,  ///< the object's origin is over `at`
  };
  Place place = Place::kAnywhere;
  Point at;

  friend bool operator==(const CopyInput&, const CopyInput&) = default;
};

/// An object and its copies, which are all alike.
struct ObjectInput {
  std::string name;
  std::vector<PartInput> parts;
  std::vector<RangeInput> ranges;
  std::vector<CopyInput> copies = {{}};
  /// Put before each part's to_object. Afterwards the object is lowered or raised until it stands
  /// on the bed.
  Transform to_plate = Transform::Identity();
  /// How far below the bed the object reaches, mm; what is below is not printed.
  double sunk_mm = 0;

  bool operator==(const ObjectInput&) const = default;
};

struct SliceInput {
  std::vector<MeshFile> files;
  std::vector<ObjectInput> objects;
  bool advise_orientations = false;  ///< whether SlicedJob::orientations is wanted
};

/// A copy as it stands on the plate.
struct PlacedCopy {
  int32_t object = 0;
  Point shift;        ///< from the object's origin; whole micrometres
  Polygon footprint;  ///< the object's convex hull at its place; no points: no area

  friend bool operator==(const PlacedCopy&, const PlacedCopy&) = default;
};

/// Layers bottom up without gaps (a layer may be empty), and what was found on the way.
struct SlicedJob {
  std::vector<SlicedLayer> layers;
  std::vector<std::string> object_names;  ///< by object
  std::vector<PlacedCopy> copies;         ///< by object, then as in the input
  std::vector<MeshReport> meshes;         ///< one a part, by object; none of surfaces for seams
  std::vector<Thumbnail> thumbnails;
  std::vector<OrientationAdvice> orientations;  ///< of objects that would print better otherwise
};

class SlicingStage {
 public:
  virtual ~SlicingStage() = default;
  /// Takes the input by value: the bytes of a big mesh are freed as soon as they are read.
  virtual absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                          const SlicingOptions& options) const = 0;
};

/// Reads meshes and puts them on the bed: what slicing begins with, for processes that work on the
/// meshes themselves. Errors: those of slicing up to there.
class PlacingStage {
 public:
  virtual ~PlacingStage() = default;
  virtual absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                            const SlicingOptions& options) const = 0;
  /// The objects as their files have them, transformed and not placed: for processes that need the
  /// doubles. Errors: REQUEST_MALFORMED for an object that is not one part and one copy;
  /// MESH_TOO_LARGE.
  virtual absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const = 0;
};

/// What planning looks at.
struct SlicedOutlines {
  std::span<const SlicedLayer> layers;
  std::span<const PlacedCopy> copies;
  std::span<const std::string> object_names = {};  ///< by object, for messages; may be fewer
};

class PlanningStage {
 public:
  virtual ~PlanningStage() = default;
  virtual absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                                       const PlanningOptions& options) const = 0;
};

/// A stretch of consecutive layers of a job: the layers to work on and their halo.
struct Neighbourhood {
  LayerRange range;                     ///< to work on
  std::span<const SlicedLayer> layers;  ///< consecutive, the range among them
};

/// What a stage is told of the whole job, the same in all its calls: it is sent and read once
/// (common/wire/shared_wire.h). What it is told of regions is by row of the job's tables.

using BeadingTable = std::vector<BeadingOptions>;
using InfillTable = std::vector<InfillOptions>;

struct OrderingJob {
  OrderingOptions options;
  std::vector<Copy> copies;

  friend bool operator==(const OrderingJob&, const OrderingJob&) = default;
};

struct MotionJob {
  MotionOptions options;
  JobFacts facts;

  friend bool operator==(const MotionJob&, const MotionJob&) = default;
};

struct ExposureJob {
  ExposureSettings settings;
  std::vector<Copy> copies;

  friend bool operator==(const ExposureJob&, const ExposureJob&) = default;
};

/// Results are in order, one for each layer of the range.
class BeadingStage {
 public:
  virtual ~BeadingStage() = default;
  virtual absl::StatusOr<std::vector<WalledLayer>> Bead(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<BeadingTable>& regions) const = 0;
};

class InfillStage {
 public:
  virtual ~InfillStage() = default;
  /// `walled` and `plans`: of the layers of neighbourhood.range; of a plan, its `infill`.
  virtual absl::StatusOr<std::vector<FilledLayer>> Fill(
      const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
      std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const = 0;
};

class OrderingStage {
 public:
  virtual ~OrderingStage() = default;
  /// `plans`: one a layer.
  virtual absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                          std::vector<FilledLayer> layers,
                                                          std::span<const LayerPlan> plans,
                                                          const Shared<OrderingJob>& job) const = 0;
};

class MotionStage {
 public:
  virtual ~MotionStage() = default;
  /// By layer, then pass: a layer has a program for each pass that prints something in it, and one
  /// at least.
  virtual absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                            std::vector<OrderedLayer> layers,
                                                            const Shared<MotionJob>& job) const = 0;
  virtual absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call,
                                                   const ProgramSummary& summary,
                                                   const MotionOptions& options) const = 0;
};

/// Layers to vectors that expose them: all that is done to a layer.
class ExposureStage {
 public:
  virtual ~ExposureStage() = default;
  /// A program for each layer of the range.
  virtual absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<ExposureJob>& job) const = 0;
  virtual absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& call,
                                                    const ExposureSummary& summary,
                                                    const ExposureSettings& settings) const = 0;
};

/// Meshes to programs of a milling machine. Any ranges of a job's steps can be made apart; their
/// results are put together at once.
class MillingStage {
 public:
  virtual ~MillingStage() = default;
  /// Errors: what cannot be milled so.
  virtual absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                            const Shared<MillInput>& input) const = 0;
  /// What the steps of the range come to. REQUEST_MALFORMED for a range that the job has not.
  virtual absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                                       const Shared<MillInput>& input,
                                                       StepRange range) const = 0;
  /// `steps`: all of the job's. `settings_text`: effective settings, quoted at the program's end.
  virtual absl::StatusOr<MilledProgram> Assemble(const StageCall& call,
                                                 const Shared<MillInput>& input,
                                                 std::vector<MilledStep> steps,
                                                 std::string_view settings_text) const = 0;
};

/// Surfaces to textures on them. Any ranges of a job's layers can be made apart.
class TextureStage {
 public:
  virtual ~TextureStage() = default;
  /// Lays the surface flat. Made once for all who ask with the same value.
  virtual absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                            const Shared<SurfaceInput>& surface) const = 0;
  virtual absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                               const Shared<EngraveInput>& input) const = 0;
  /// One for each layer of the range, in order of work. REQUEST_MALFORMED for a range that the job
  /// has not.
  virtual absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                             const Shared<EngraveInput>& input,
                                                             LayerRange range) const = 0;
};

/// The stages that somebody has, local or remote; null: not this one. What they are must outlive
/// who is given them.
struct Stages {
  const SlicingStage* slicing = nullptr;
  const PlanningStage* planning = nullptr;
  const BeadingStage* beading = nullptr;
  const InfillStage* infill = nullptr;
  const OrderingStage* ordering = nullptr;
  const MotionStage* motion = nullptr;
  const ExposureStage* exposure = nullptr;
  const PlacingStage* placing = nullptr;
  const MillingStage* milling = nullptr;
  const TextureStage* texture = nullptr;
};

}  // namespace slicefarm
