#include "common/stage/job_memory.h"

#include "common/base/error.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"

namespace slicefarm {
namespace {

/// Estimated overhead of one memory allocation, in bytes.
constexpr int64_t kAllocation = 16;

template <typename T>
int64_t MemoryOfList(const std::vector<T>& list) {
  return list.empty() ? 0 : std::ssize(list) * static_cast<int64_t>(sizeof(T)) + kAllocation;
}

int64_t MemoryOfPolygons(const MultiPolygon& polygons) {
  int64_t bytes = MemoryOfList(polygons);
  for (const PolygonWithHoles& polygon : polygons) bytes += MemoryOfList(polygon.holes);
  ForEachRing(polygons, [&](const Polygon& ring) { bytes += MemoryOfList(ring); });
  return bytes;
}

int64_t MemoryOfRegions(const std::vector<Region>& regions) {
  int64_t bytes = MemoryOfList(regions);
  for (const Region& region : regions) bytes += MemoryOfPolygons(region.outlines);
  return bytes;
}

int64_t MemoryOfPaths(const std::vector<Path>& paths) {
  int64_t bytes = MemoryOfList(paths);
  for (const Path& path : paths) bytes += MemoryOfList(path.points) + MemoryOfList(path.widths_nm);
  return bytes;
}

}  // namespace

bool IsOutOfMemory(const absl::Status& status) {
  return !status.ok() && DetailOf(status).metadata.contains(kMemoryKind);
}

absl::Status HoldMemory(const StageCall& call, JobMemory::Kind kind, int64_t bytes) {
  return call.memory == nullptr ? absl::OkStatus() : call.memory->Hold(kind, bytes);
}

int64_t MemoryOf(const ObjectSection& section) {
  int64_t bytes = MemoryOfRegions(section.regions) + MemoryOfPolygons(section.whole) +
                  MemoryOfList(section.marks);
  for (const Mark& mark : section.marks) bytes += MemoryOfPolygons(mark.outlines);
  return bytes;
}

int64_t MemoryOf(const SlicedLayer& layer) {
  int64_t bytes = static_cast<int64_t>(sizeof layer) + MemoryOfList(layer.sections);
  for (const ObjectSection& section : layer.sections) bytes += MemoryOf(section);
  return bytes;
}

int64_t MemoryOf(const LayerPlan& plan) {
  int64_t bytes = static_cast<int64_t>(sizeof plan) + MemoryOfList(plan.sections) +
                  MemoryOfPaths(plan.paths) + MemoryOfList(plan.infill);
  for (const SectionPlan& section : plan.sections)
    bytes += MemoryOfList(section.seams) + MemoryOfPolygons(section.above_supports) +
             MemoryOfPolygons(section.curled) + MemoryOfPolygons(section.air);
  for (const PlannedInfill& infill : plan.infill) {
    bytes += MemoryOfList(infill.lines) + MemoryOfPolygons(infill.left_out) +
             MemoryOfPolygons(infill.combined) + MemoryOfList(infill.body_middles);
    for (const Polyline& line : infill.lines) bytes += MemoryOfList(line);
  }
  return bytes;
}

int64_t MemoryOf(const Skirt& skirt) {
  return static_cast<int64_t>(sizeof skirt) + MemoryOfPaths(skirt.loops) +
         MemoryOfPaths(skirt.upper_loops);
}

int64_t MemoryOf(const PlacedScene& scene) {
  int64_t bytes = 0;
  for (const PlacedSceneObject& object : scene.objects)
    for (const PlacedScenePart& part : object.parts)
      bytes += MemoryOfList(part.mesh.vertices) + MemoryOfList(part.mesh.triangles);
  return bytes;
}

}  // namespace slicefarm
