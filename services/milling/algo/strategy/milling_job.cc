#include "services/milling/algo/strategy/milling_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "processes/mill/model/check_milling.h"
#include "services/milling/algo/strategy/level_passes.h"

namespace slicefarm::milling {
namespace {

/// Largest coordinate. Regions of levels use 32-bit nm, and passes extend beyond the stock.
constexpr double kMostCoordinateMm = 1'500;
/// Height difference below which two levels count as one.
constexpr double kSameLevelMm = 1e-6;

absl::Status MillingError(Reason reason, std::string_view setting, std::string message) {
  std::map<std::string, std::string> metadata;
  if (!setting.empty()) metadata.emplace("setting", std::string(setting));
  return MakeError(absl::StatusCode::kInvalidArgument, reason, message, std::move(metadata));
}

Eigen::AlignedBox3d BoxOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& t : mesh.triangles)
    for (const uint32_t p : t) box.extend(mesh.points_mm[p]);
  return box;
}

/// Returns for each point of a mesh the index of the first point at the same position. Some files
/// repeat points for each triangle.
std::vector<uint32_t> CornersOf(const TriangleMesh& mesh) {
  std::vector<uint32_t> order(mesh.points_mm.size()), corner(mesh.points_mm.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const Eigen::Vector3d &p = mesh.points_mm[a], &q = mesh.points_mm[b];
    return p == q ? a < b : ByCoordinates(p, q);
  });
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.points_mm[order[i]] == mesh.points_mm[order[i - 1]];
    corner[order[i]] = same ? corner[order[i - 1]] : order[i];
  }
  return corner;
}

/// Checks that a mesh is closed: every edge has equally many triangles in both directions.
absl::Status CheckClosed(const TriangleMesh& mesh, std::string_view what) {
  const std::vector<uint32_t> corner = CornersOf(mesh);
  std::vector<std::pair<uint64_t, int>> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const uint64_t a = corner[t[k]], b = corner[t[(k + 1) % 3]];
      if (a != b) sides.emplace_back(std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : -1);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (size_t i = 0; i < sides.size();) {
    const size_t first = i;
    int turns = 0;
    for (; i < sides.size() && sides[i].first == sides[first].first; ++i) turns += sides[i].second;
    if (turns == 0) continue;
    const Eigen::Vector3d& p = mesh.points_mm[sides[first].first >> 32];
    return MillingError(Reason::kMeshMalformed, "",
                        fmt::format("the {} is not closed: an edge at x {:.3f} y {:.3f} z {:.3f} "
                                    "has a triangle on one side only; open_mesh = 1 mills it as a "
                                    "surface",
                                    what, p.x(), p.y(), p.z()));
  }
  return absl::OkStatus();
}

TriangleMesh BoxMesh(const Eigen::AlignedBox3d& box) {
  TriangleMesh mesh;
  for (const double z : {box.min().z(), box.max().z()}) {
    mesh.points_mm.push_back({box.min().x(), box.min().y(), z});
    mesh.points_mm.push_back({box.max().x(), box.min().y(), z});
    mesh.points_mm.push_back({box.max().x(), box.max().y(), z});
    mesh.points_mm.push_back({box.min().x(), box.max().y(), z});
  }
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t n = (k + 1) % 4;
    mesh.triangles.push_back({k, n, n + 4});
    mesh.triangles.push_back({k, n + 4, k + 4});
  }
  return mesh;
}

absl::Status CheckMeshes(const MillingJob& job) {
  if (job.part.triangles.empty() || job.stock.triangles.empty())
    return MillingError(Reason::kMeshEmpty, "", "the mesh has no triangles to mill");
  for (const TriangleMesh* mesh : {&job.part, &job.stock})
    for (const Eigen::Vector3d& p : mesh->points_mm)
      if (!p.allFinite())
        return MillingError(Reason::kMeshNotFinite, "",
                            "the mesh has a coordinate that is not finite");
  if (!job.options.open_mesh)
    if (absl::Status status = CheckClosed(job.part, "part"); !status.ok()) return status;
  return job.stock_is_box ? absl::OkStatus() : CheckClosed(job.stock, "stock");
}

absl::Status CheckReach(const MillingJob& job) {
  const Eigen::AlignedBox3d& part = job.part_box;
  const Eigen::AlignedBox3d& stock = job.stock_box;
  const double far = std::max(stock.max().cwiseAbs().maxCoeff(), stock.min().cwiseAbs().maxCoeff());
  if (far > kMostCoordinateMm) {
    return MillingError(
        Reason::kOutOfRange, "",
        fmt::format("the stock reaches {:.0f} mm from the origin, at most {} mm are allowed", far,
                    kMostCoordinateMm));
  }
  const double out =
      std::max((part.max() - stock.max()).maxCoeff(), (stock.min() - part.min()).maxCoeff());
  if (out > kSameLevelMm) {
    return MillingError(Reason::kOutOfRange, "",
                        fmt::format("the part extends {:.3f} mm beyond its stock", out));
  }
  const double diameter = 2 * job.options.cutter.radius_mm();
  if (diameter > std::max(stock.sizes().x(), stock.sizes().y())) {
    return MillingError(Reason::kSettingOutOfRange, "cutter",
                        fmt::format("the cutter, {} mm wide, is wider than the stock of {:.3f} x "
                                    "{:.3f} mm",
                                    diameter, stock.sizes().x(), stock.sizes().y()));
  }
  if (job.floor_mm >= part.max().z()) {
    return MillingError(Reason::kSettingOutOfRange, "bottom",
                        fmt::format("bottom = {} mm leaves no level to mill: the top of the part "
                                    "is {:.3f} mm above the bottom of the stock",
                                    job.options.bottom_mm, part.max().z() - stock.min().z()));
  }
  const double depth = stock.max().z() - job.floor_mm;
  const double length = job.options.machining.tool_length_mm;
  if (length > 0 && depth > length) {
    return MillingError(
        Reason::kSettingOutOfRange, "tool_length",
        fmt::format("tool_length = {} mm is too short: the tool must reach {:.3f} mm deep", length,
                    depth));
  }
  return absl::OkStatus();
}

/// Returns the heights of the part's horizontal facets that face upwards and are large enough.
std::vector<double> FlatsOf(const MillingJob& job) {
  std::map<double, double> areas;
  for (const auto& t : job.part.triangles) {
    const Eigen::Vector3d &a = job.part.points_mm[t[0]], &b = job.part.points_mm[t[1]],
                          &c = job.part.points_mm[t[2]];
    if (a.z() != b.z() || a.z() != c.z()) continue;
    const double turn = (b - a).cross(c - a).z();
    if (turn > 0 || job.options.open_mesh) areas[a.z()] += std::abs(turn) / 2;
  }
  const double radius = job.options.cutter.radius_mm();
  std::vector<double> flats;
  for (const auto& [z, area] : areas)
    if (area >= std::numbers::pi * radius * radius) flats.push_back(z);
  return flats;
}

/// Returns levels from below `top` down to `bottom`: all of `wanted` in this range, and evenly
/// spaced levels between them.
std::vector<double> LevelsOver(double top, double bottom, std::vector<double> wanted,
                               double stepdown) {
  std::sort(wanted.begin(), wanted.end(), std::greater<>());
  wanted.push_back(bottom);
  std::vector<double> levels;
  double last = top;
  for (const double z : wanted) {
    if (z > last - kSameLevelMm || z < bottom) continue;
    const double steps = std::ceil((last - z) / stepdown - 1e-9);
    for (double k = 1; k < steps; ++k) levels.push_back(last - (last - z) * k / steps);
    levels.push_back(z);
    last = z;
  }
  return levels;
}

/// Checks the number of steps before the steps are created.
absl::Status CheckStepCount(const MillingJob& job) {
  const MillingOptions& options = job.options;
  const Eigen::Vector3d size = job.stock_box.sizes();
  const double rings = (std::min(size.x(), size.y()) / 2 + options.cutter.radius_mm() +
                        options.machining.clearance_mm) /
                       options.stepover_mm();
  if (rings >= kMostRings) {
    return LimitError(Reason::kRequestTooLarge, "rings of a level", kMostRings,
                      static_cast<int64_t>(std::min(rings, 1e15)));
  }
  const double depth = job.stock_box.max().z() - job.floor_mm;
  double steps = depth / options.stepdown_mm;
  if (options.finishing) {
    steps += depth / options.finish_stepdown_mm;
    steps +=
        (job.part_box.sizes().y() + 2 * options.cutter.radius_mm()) / options.finish_stepover_mm;
  }
  if (steps <= static_cast<double>(limits::kMaxMillSteps)) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "levels and rows", limits::kMaxMillSteps,
                    static_cast<int64_t>(std::min(steps, 1e15)));
}

void LayOut(MillingJob& job) {
  const MillingOptions& options = job.options;
  const double top = job.stock_box.max().z();
  std::vector<double> flats = FlatsOf(job), raised = flats;
  for (double& z : raised) z += options.allowance_mm;
  for (const double z : LevelsOver(top, job.floor_mm, raised, options.stepdown_mm))
    job.steps.push_back({MillPhase::kRoughing, z});
  if (!options.finishing) return;
  for (const double z : LevelsOver(top, job.floor_mm, flats, options.finish_stepdown_mm))
    if (z < job.part_box.max().z()) job.steps.push_back({MillPhase::kFinishing, z});
  const double from = RestBox(job).min().y(), to = RestBox(job).max().y();
  const double rows = std::ceil((to - from) / options.finish_stepover_mm - 1e-9);
  for (double k = 0; k <= rows; ++k)
    job.steps.push_back({MillPhase::kRest, from + (to - from) * k / rows});
}

/// Returns the relative cost of a step: 4 for a level of roughing (waterlines and rings), 2 for a
/// level of finishing (waterlines), 1 for a row (drops). The ratios are estimated, not measured.
int32_t WeightOf(MillPhase phase) {
  switch (phase) {
    case MillPhase::kRoughing:
      return 4;
    case MillPhase::kFinishing:
      return 2;
    case MillPhase::kRest:
      return 1;
  }
  return 1;
}

}  // namespace

Eigen::AlignedBox2d RestBox(const MillingJob& job) {
  const Eigen::AlignedBox3d& box = job.options.finish_floor ? job.stock_box : job.part_box;
  const double radius = job.options.cutter.radius_mm();
  return {box.min().head<2>().array() - radius, box.max().head<2>().array() + radius};
}

absl::StatusOr<MillingJob> PrepareMilling(TriangleMesh part, std::optional<TriangleMesh> stock,
                                          const MillingOptions& options) {
  if (absl::Status status = CheckMillingOptions(options); !status.ok()) return status;
  MillingJob job{.options = options,
                 .part = std::move(part),
                 .stock = {},
                 .part_box = {},
                 .stock_box = {},
                 .steps = {}};
  job.stock_is_box = !stock.has_value();
  job.part_box = BoxOf(job.part);
  if (stock) {
    job.stock = *std::move(stock);
  } else if (!job.part.triangles.empty()) {
    const double margin = options.stock_margin_mm;
    job.stock_box = job.part_box;
    job.stock_box.min() -= Eigen::Vector3d(margin, margin, 0);
    job.stock_box.max().array() += margin;
    job.stock = BoxMesh(job.stock_box);
  }
  if (absl::Status status = CheckMeshes(job); !status.ok()) return status;
  job.stock_box = BoxOf(job.stock);
  job.floor_mm = job.stock_box.min().z() + options.bottom_mm;
  if (absl::Status status = CheckReach(job); !status.ok()) return status;
  if (absl::Status status = CheckStepCount(job); !status.ok()) return status;
  LayOut(job);
  return job;
}

std::vector<int32_t> StepWeights(const MillingJob& job) {
  std::vector<int32_t> weights;
  for (const MillStep& step : job.steps) weights.push_back(WeightOf(step.phase));
  return weights;
}

}  // namespace slicefarm::milling
