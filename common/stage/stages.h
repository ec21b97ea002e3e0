#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layer.h"
#include "common/model/mesh.h"
#include "common/model/program_summary.h"
#include "common/model/settings.h"
#include "common/base/trace_context.h"

namespace slicefarm {

class SpanLog;

/// The stages as the pipeline sees them. Each has a local implementation (services/<name>/algo) and
/// a remote one (services/coordinator/remote); the embedded process, the fused worker and the split
/// services run the same pipeline over either, and give the same bytes.
///
/// All stages are pure: same input, same output; safe to call from many threads; safe to call
/// again. Errors: what Reason lists; Cancelled as soon as `call.cancel` asks for it.

/// Who is to be served where jobs share what there is.
struct Claimant {
  std::string tenant;
  int priority = 0;  ///< greater ones first, among the tenant's own
};

struct StageCall {
  std::string job_id;  ///< for logs
  Claimant claimant = {};
  CancelToken cancel;
  int threads = 1;           ///< how many a stage may use; never changes the result
  TraceContext trace = {};   ///< travels on with each call; empty: none
  SpanLog* spans = nullptr;  ///< notes what is done when, in this process; null: nobody asks
};

struct SliceInput {
  std::vector<MeshFile> files;
  std::vector<Placement> placements;  ///< one a file
};

/// Layers bottom up without gaps (a layer may be empty), and what was found on the way.
struct SlicedJob {
  std::vector<SlicedLayer> layers;
  std::vector<std::string> object_names;  ///< by object: copies count, and share their file's name
  std::vector<MeshReport> meshes;         ///< one a file
  std::vector<Thumbnail> thumbnails;
};

class SlicingStage {
 public:
  virtual ~SlicingStage() = default;
  /// Takes the input by value: the bytes of a big mesh are freed as soon as they are read.
  virtual absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                          const SlicingOptions& options) const = 0;
};

/// A stretch of consecutive layers of a job: the layers to work on and their halo.
struct Neighbourhood {
  LayerRange range;                     ///< to work on
  int32_t layer_count = 0;              ///< of the whole job: beyond it is air
  std::span<const SlicedLayer> layers;  ///< range.Grown(halo, layer_count), in order
};

/// Results are in order, one for each layer of the range.
class BeadingStage {
 public:
  virtual ~BeadingStage() = default;
  virtual absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                        const Neighbourhood& neighbourhood,
                                                        const BeadingOptions& options) const = 0;
};

class InfillStage {
 public:
  virtual ~InfillStage() = default;
  /// `walled`: the layers of neighbourhood.range.
  virtual absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                        std::vector<WalledLayer> walled,
                                                        const Neighbourhood& neighbourhood,
                                                        const InfillOptions& options) const = 0;
};

class OrderingStage {
 public:
  virtual ~OrderingStage() = default;
  /// `plans`: one a layer.
  virtual absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                          std::vector<FilledLayer> layers,
                                                          std::span<const LayerPlan> plans,
                                                          const OrderingOptions& options) const = 0;
};

class MotionStage {
 public:
  virtual ~MotionStage() = default;
  virtual absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                            std::vector<OrderedLayer> layers,
                                                            const MotionOptions& options) const = 0;
  virtual absl::StatusOr<ProgramFrame> Frame(const StageCall& call, const ProgramSummary& summary,
                                             const MotionOptions& options) const = 0;
};

/// What each stage took, in seconds of wall time as the caller sees it.
struct StageTimes {
  double slicing_s = 0;
  double beading_s = 0;
  double infill_s = 0;
  double ordering_s = 0;
  double motion_s = 0;

  void Add(const StageTimes& other);
};

/// A range of a job, with everything its layers depend on.
struct RangeTask {
  LayerRange range;
  int32_t layer_count = 0;
  std::span<const SlicedLayer> layers;  ///< the range and its halo
  std::span<const LayerPlan> plans;     ///< one for each layer of the range
  const JobSettings* settings = nullptr;
};

struct RangeResult {
  std::vector<LayerProgram> programs;
  StageTimes times;
};

/// Takes a range from outlines to programs: a chain of stages (LayerChain) or a worker that runs
/// one elsewhere.
class RangeRunner {
 public:
  virtual ~RangeRunner() = default;
  virtual absl::StatusOr<RangeResult> Run(const StageCall& call, const RangeTask& task) const = 0;
};

}  // namespace slicefarm
