#pragma once

#include <utility>

#include "processes/mill/model/mill_input.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling {

inline IndexedMesh InNm(const TriangleMesh& mesh) {
  IndexedMesh in_nm;
  for (const Eigen::Vector3d& p : mesh.points_mm)
    in_nm.vertices.push_back({FromMm(p.x()), FromMm(p.y()), FromMm(p.z())});
  in_nm.triangles = mesh.triangles;
  return in_nm;
}

inline MillInput InputOf(const TriangleMesh& part, const MillingOptions& how) {
  MillInput input;
  input.part = InNm(part);
  input.settings.how = how;
  return input;
}

}  // namespace slicefarm::milling
