#pragma once

namespace slicefarm {

class SlicingStage;
class PlanningStage;
class BeadingStage;
class InfillStage;
class OrderingStage;
class MotionStage;
class ExposureStage;
class PlacingStage;
class MillingStage;
class TextureStage;

// Interfaces of the stages that the pipeline calls. Each stage has a local implementation
// (services/<name>/algo) and a remote one (services/coordinator/remote). The embedded process, the
// fused worker and the split services run the same pipeline with either implementation, with the
// same result to the byte.
//
// All stages are pure: equal input gives equal output. They may be called from many threads, and a
// call may be repeated. Errors have a Reason (error.h). A stage returns Cancelled soon after
// `call.cancel` is cancelled.

/// Stages that a process has, local or remote; null for a stage that it does not have. The stages
/// must outlive their users.
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
