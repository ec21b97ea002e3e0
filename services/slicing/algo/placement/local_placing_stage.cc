#include "services/slicing/algo/placement/local_placing_stage.h"

#include <utility>

#include "common/stage/job_memory.h"
#include "services/slicing/algo/placement/prepared_object.h"
#include "services/slicing/algo/placement/surfaces.h"

namespace slicefarm::slicing {
namespace {

PlacedSceneObject Placed(PreparedObject object) {
  PlacedSceneObject placed{std::move(object.name), {}, object.to_origin, std::move(object.shifts)};
  for (PreparedPart& part : object.parts)
    placed.parts.push_back(
        {part.input.role, std::move(part.connected.mesh), std::move(part.report)});
  placed.parts.front().report.copies_off_bed = object.copies_off_bed;
  return placed;
}

class LocalPlacing : public PlacingStage {
 public:
  explicit LocalPlacing(std::unique_ptr<const MeshSource> source) : source_(std::move(source)) {}

  absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                    const SlicingOptions& options) const override {
    auto objects = PrepareObjects(std::move(input), *source_, options, call.cancel);
    if (!objects.ok()) return objects.status();
    PlacedScene scene;
    for (PreparedObject& object : *objects) scene.objects.push_back(Placed(std::move(object)));
    const absl::Status held = HoldMemory(call, JobMemory::Kind::kMeshes, MemoryOf(scene));
    if (!held.ok()) return held;
    return scene;
  }

  absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& /*options*/) const override {
    return SurfacesOf(std::move(input), *source_, call.cancel);
  }

 private:
  const std::unique_ptr<const MeshSource> source_;
};

}  // namespace

std::unique_ptr<PlacingStage> MakeLocalPlacing(std::unique_ptr<const MeshSource> source) {
  return std::make_unique<LocalPlacing>(std::move(source));
}

}  // namespace slicefarm::slicing
