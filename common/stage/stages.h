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

/// The stages as the pipeline sees them. Each has a local implementation (services/<name>/algo) and
/// a remote one (services/coordinator/remote); the embedded process, the fused worker and the split
/// services run the same pipeline over either, and give the same bytes.
///
/// All stages are pure: same input, same output; safe to call from many threads; safe to call
/// again. Errors: what Reason lists; Cancelled as soon as `call.cancel` asks for it.

/// Stages that a process has, local or remote; null: none. They must outlive their users.
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
