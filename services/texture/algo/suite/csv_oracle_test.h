#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Row of a table of points.
struct CsvPoint {
  int path = 0;
  int layer = 0;
  Eigen::Vector3d place;
  Eigen::Vector3d normal;
  bool on = false;
};

/// Judges a table of points by the surface's mesh alone. It shares no code with the producer of the
/// table: it finds the triangles under each point by brute force over a grid.
class CsvOracle {
 public:
  explicit CsvOracle(const SurfaceMesh& mesh) : mesh_(mesh) {
    low_ = high_ = mesh.points_mm[mesh.triangles[0][0]];
    for (const auto& t : mesh.triangles) {
      for (const int32_t v : t) {
        low_ = low_.cwiseMin(mesh.points_mm[v]);
        high_ = high_.cwiseMax(mesh.points_mm[v]);
      }
    }
    cell_ = (high_ - low_).maxCoeff() / 48;
    near_ = 1e-9 * (high_ - low_).norm();
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const auto& p = mesh.points_mm;
      const auto from = CellOf(p[a].cwiseMin(p[b]).cwiseMin(p[c]));
      const auto to = CellOf(p[a].cwiseMax(p[b]).cwiseMax(p[c]));
      for (int x = from[0] - 1; x <= to[0] + 1; ++x)
        for (int y = from[1] - 1; y <= to[1] + 1; ++y)
          for (int z = from[2] - 1; z <= to[2] + 1; ++z)
            cells_[{x, y, z}].push_back(static_cast<int32_t>(t));
    }
  }

  /// Returns the rows of a table; nothing if the text is no such table.
  static std::vector<CsvPoint> Read(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    if (line != "path,layer,x,y,z,nx,ny,nz,on") return {};
    std::vector<CsvPoint> points;
    while (std::getline(lines, line)) {
      CsvPoint p;
      int on = -1;
      if (std::sscanf(line.c_str(), "%d,%d,%lf,%lf,%lf,%lf,%lf,%lf,%d", &p.path, &p.layer,
                      &p.place[0], &p.place[1], &p.place[2], &p.normal[0], &p.normal[1],
                      &p.normal[2], &on) != 9 ||
          on < 0 || on > 1)
        return {};
      p.on = on == 1;
      points.push_back(p);
    }
    return points;
  }

  /// Returns the triangles that contain a position.
  std::vector<int32_t> TrianglesAt(const Eigen::Vector3d& place) const {
    std::vector<int32_t> there;
    const auto cell = cells_.find(CellOf(place));
    if (cell == cells_.end()) return there;
    for (const int32_t t : cell->second)
      if (DistanceFrom(t, place) <= near_) there.push_back(t);
    return there;
  }

  /// Returns the fault of a job's points, for layers at `offsets` from the surface; empty if there
  /// is none.
  std::string Judge(const std::vector<CsvPoint>& points, const std::vector<double>& offsets) const {
    std::vector<int32_t> before;
    int layer = -1, path = -1;
    for (size_t i = 0; i < points.size(); ++i) {
      const CsvPoint& p = points[i];
      const auto wrong = [&](const std::string& what) {
        std::ostringstream words;
        words << "row " << i + 2 << ": " << what;
        return words.str();
      };
      if (p.layer < 0 || p.layer >= static_cast<int>(offsets.size())) return wrong("no such layer");
      if (p.layer != layer) {
        if (p.layer < layer) return wrong("a lower layer");
        if (p.on || p.path != 0) return wrong("a layer begins without a link");
        path = -1;
      }
      if (p.path != path && p.path != path + 1) return wrong("paths are not in order");
      if (std::abs(p.normal.norm() - 1) > 1e-9) return wrong("a normal that is no unit");
      const Eigen::Vector3d foot = p.place - offsets[p.layer] * p.normal;
      const std::vector<int32_t> there = TrianglesAt(foot);
      if (there.empty()) return wrong("off its height, or beyond the surface");
      if (!NormalFits(there, p.normal, foot)) return wrong("a normal of no face, edge or vertex");
      if (p.layer == layer && !Touch(before, there)) return wrong("the way leaves the surface");
      before = there;
      layer = p.layer;
      path = p.path;
    }
    return "";
  }

 private:
  using Cell = std::array<int, 3>;

  Cell CellOf(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d c = (p - low_) / cell_;
    return {static_cast<int>(std::floor(c[0])), static_cast<int>(std::floor(c[1])),
            static_cast<int>(std::floor(c[2]))};
  }

  Eigen::Vector3d NormalOf(int32_t t) const {
    return DoubleAreaVector(mesh_, static_cast<size_t>(t)).normalized();
  }

  static double ToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b) {
    const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - s * (b - a)).norm();
  }

  double DistanceFrom(int32_t t, const Eigen::Vector3d& p) const {
    const auto& corners = mesh_.triangles[t];
    const Eigen::Vector3d normal = NormalOf(t);
    bool inside = true;
    double to_side = 1e300;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d &a = mesh_.points_mm[corners[k]],
                            &b = mesh_.points_mm[corners[(k + 1) % 3]];
      inside &= normal.dot((b - a).cross(p - a)) >= 0;
      to_side = std::min(to_side, ToSegment(p, a, b));
    }
    return inside ? std::abs(normal.dot(p - mesh_.points_mm[corners[0]])) : to_side;
  }

  /// Returns true if the normal is right. It is the normal of a face; on an edge the mean of its
  /// two faces; at a vertex the mean of its faces weighted by their angles.
  bool NormalFits(const std::vector<int32_t>& there, const Eigen::Vector3d& normal,
                  const Eigen::Vector3d& foot) const {
    for (const int32_t t : there)
      if ((normal - NormalOf(t)).norm() < 1e-9) return true;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int32_t t : there) {
      const auto& corners = mesh_.triangles[t];
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d& at = mesh_.points_mm[corners[k]];
        if ((at - foot).norm() > near_) continue;
        const Eigen::Vector3d u = mesh_.points_mm[corners[(k + 1) % 3]] - at;
        const Eigen::Vector3d v = mesh_.points_mm[corners[(k + 2) % 3]] - at;
        mean += std::atan2(u.cross(v).norm(), u.dot(v)) * NormalOf(t);
      }
    }
    if ((normal - mean.normalized()).norm() < 1e-9) return true;
    // On an edge, the foot may be so close to a vertex that it counts as on all faces of the
    // vertex.
    for (const int32_t a : there)
      for (const int32_t b : there)
        if ((normal - (NormalOf(a) + NormalOf(b)).normalized()).norm() < 1e-9) return true;
    return false;
  }

  /// Returns true if two positions are on one triangle, or on two triangles with a common edge.
  bool Touch(const std::vector<int32_t>& a, const std::vector<int32_t>& b) const {
    for (const int32_t t : a) {
      for (const int32_t u : b) {
        int shared = 0;
        for (const int32_t v : mesh_.triangles[t])
          shared += std::count(mesh_.triangles[u].begin(), mesh_.triangles[u].end(), v);
        if (shared >= 2) return true;
      }
    }
    return false;
  }

  const SurfaceMesh& mesh_;
  Eigen::Vector3d low_, high_;
  double cell_ = 1;
  double near_ = 0;
  std::map<Cell, std::vector<int32_t>> cells_;
};

}  // namespace slicefarm::texture
