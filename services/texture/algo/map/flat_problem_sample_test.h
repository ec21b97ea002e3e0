#pragma once

#include "services/texture/algo/map/flat_problem.h"
#include "services/texture/algo/map/tutte.h"
#include "services/texture/algo/surface/disk.h"

namespace slicefarm::texture {

/// Problem with its first map.
struct FlatProblemSample {
  MapPoints points;
  FlatProblem problem;
};

inline FlatProblemSample SampleOf(const SurfaceMesh& mesh) {
  const auto loops = BoundaryOfDisk(mesh);
  const auto map = TutteEmbedding(mesh, *loops);
  const auto shell = ShellAround(*map, *loops);
  MapPoints points = map->points;
  points.insert(points.end(), shell->points.begin(), shell->points.end());
  FlatProblem problem(mesh, loops->front(), *shell, points);
  problem.WeighShell(0.01);
  return {points, problem};
}

inline MapPoints Along(const FlatProblemSample& sample, const MapPoints& direction, double step) {
  MapPoints points = sample.points;
  for (size_t i = 0; i < points.size(); ++i) points[i] += step * direction[i];
  return points;
}

}  // namespace slicefarm::texture
