#include "services/milling/algo/waterline/waterline.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "common/base/error.h"
#include "common/base/parallel.h"
#include "services/milling/algo/push/fiber_push.h"
#include "services/milling/algo/push/local_push.h"
#include "services/milling/algo/waterline/refine.h"
#include "services/milling/algo/waterline/weave.h"

namespace slicefarm::milling {
namespace {

constexpr int64_t kMaxFibers = 50'000;  ///< fibers of one direction
constexpr int64_t kMaxFiberLevels = 20'000'000;

absl::Status RangeError(std::string_view setting, std::string_view what, double got) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} {}, not {}", setting, what, got),
                   {{"setting", std::string(setting)}, {"got", fmt::format("{}", got)}});
}

absl::Status CheckWaterline(const TriangleMesh& mesh, std::span<const double> levels_mm,
                            const WaterlineOptions& options) {
  if (mesh.triangles.empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the mesh has no triangles to mill");
  }
  if (!(options.sampling_mm > 0) || !std::isfinite(options.sampling_mm))
    return RangeError("sampling", "must be above 0", options.sampling_mm);
  if (!(options.tolerance_mm >= 0) || !std::isfinite(options.tolerance_mm))
    return RangeError("tolerance", "must be at least 0", options.tolerance_mm);
  if (!(options.least_sampling_mm > 0))
    return RangeError("least_sampling", "must be above 0", options.least_sampling_mm);
  for (const double z : levels_mm)
    if (!(std::abs(z) <= 1e6)) return RangeError("z", "must be a height within 1 km", z);
  return absl::OkStatus();
}

/// Grids of columns (x) and rows (y).
struct WaterlineGrids {
  FiberGrid x;
  FiberGrid y;
};

absl::StatusOr<FiberGrid> GridOver(double low, double high, double radius_mm, double sampling_mm) {
  const double first = low - 2 * radius_mm, width = high + 2 * radius_mm - first;
  const double steps = std::max(1.0, std::floor(width / sampling_mm));
  if (steps >= static_cast<double>(kMaxFibers)) {
    return LimitError(Reason::kRequestTooLarge, "fibers of one direction", kMaxFibers,
                      static_cast<int64_t>(std::min(steps, 1e15)));
  }
  return FiberGrid{first, width / steps, static_cast<int32_t>(steps) + 1};
}

absl::StatusOr<WaterlineGrids> GridsOver(const TriangleMesh& mesh, const Cutter& cutter,
                                         double sampling_mm, size_t levels) {
  Eigen::Vector3d low = mesh.points_mm[mesh.triangles[0][0]], high = low;
  for (const auto& t : mesh.triangles)
    for (const uint32_t p : t)
      low = low.cwiseMin(mesh.points_mm[p]), high = high.cwiseMax(mesh.points_mm[p]);
  const auto x = GridOver(low.x(), high.x(), cutter.radius_mm(), sampling_mm);
  if (!x.ok()) return x.status();
  const auto y = GridOver(low.y(), high.y(), cutter.radius_mm(), sampling_mm);
  if (!y.ok()) return y.status();
  const int64_t fibers = static_cast<int64_t>(levels) * (x->count + y->count);
  if (fibers > kMaxFiberLevels)
    return LimitError(Reason::kRequestTooLarge, "fibers of all levels", kMaxFiberLevels, fibers);
  return WaterlineGrids{*x, *y};
}

/// Returns twice the signed area.
double TurnOf(const std::vector<Eigen::Vector2d>& points) {
  double sum = 0;
  const Eigen::Vector2d o = points[0];
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    const Eigen::Vector2d a = points[i] - o, b = points[i + 1] - o;
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

/// Data that all levels share.
class WaterlineMaker {
 public:
  WaterlineMaker(const TriangleMesh& mesh, const Cutter& cutter, const WaterlineOptions& options)
      : cutter_(cutter),
        options_(options),
        edges_(EdgesOf(mesh)),
        x_(mesh, edges_, FiberAxis::kX),
        y_(mesh, edges_, FiberAxis::kY),
        triangles_(mesh) {}

  absl::StatusOr<std::vector<std::vector<WaterlineLoop>>> Run(const WaterlineGrids& grids,
                                                              std::span<const double> levels_mm,
                                                              const CancelToken& cancel) const {
    const auto rows = PushFibers(x_, cutter_, grids.y, levels_mm, options_.threads, cancel);
    if (!rows.ok()) return rows.status();
    const auto columns = PushFibers(y_, cutter_, grids.x, levels_mm, options_.threads, cancel);
    if (!columns.ok()) return columns.status();
    std::vector<std::vector<WaterlineLoop>> result(levels_mm.size());
    std::atomic<bool> cancelled = false;
    ForEachIndex(options_.threads, levels_mm.size(), [&](size_t level, int) {
      if (cancelled || cancel.Cancelled()) {
        cancelled = true;
        return;
      }
      const Weave weave{grids.x, grids.y, (*rows)[level], (*columns)[level]};
      result[level] = LoopsOf(weave, levels_mm[level], cancel);
    });
    if (cancelled || cancel.Cancelled()) return cancel.Check();
    return result;
  }

 private:
  bool GougedAt(double x, double y, double z_mm) const {
    const IntervalSet gouged = PushLocally(x_, cutter_, triangles_, {y, z_mm}, x, x);
    return std::any_of(gouged.items().begin(), gouged.items().end(),
                       [&](const Interval& i) { return i.low < x && x < i.high; });
  }

  std::vector<WaterlineLoop> LoopsOf(const Weave& weave, double z_mm,
                                     const CancelToken& cancel) const {
    const auto woven = WeaveLoops(weave, [&](double x, double y) { return GougedAt(x, y, z_mm); });
    std::vector<WaterlineLoop> loops;
    const LevelPush level{x_, y_, cutter_, triangles_, z_mm};
    const Refinement finer{options_.tolerance_mm, options_.least_sampling_mm};
    for (const WovenLoop& loop_of_grid : woven) {
      const WovenLoop crossings =
          finer.tolerance_mm > 0 ? Refined(loop_of_grid, level, finer, cancel) : loop_of_grid;
      WaterlineLoop loop{.z_mm = z_mm, .outer = true, .points_mm = {}, .contacts_mm = {}};
      for (const Crossing& c : crossings) {
        loop.points_mm.push_back({c.x, c.y});
        if (options_.contacts) loop.contacts_mm.push_back(ContactAt(c, z_mm));
      }
      loop.outer = TurnOf(loop.points_mm) > 0;
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  Eigen::Vector3d ContactAt(const Crossing& c, double z_mm) const {
    if (c.axis == FiberAxis::kX) return x_.ContactOf(cutter_, c.source, {c.y, z_mm}, c.high);
    return y_.ContactOf(cutter_, c.source, {c.x, z_mm}, c.high);
  }

  const Cutter& cutter_;
  const WaterlineOptions& options_;
  MeshEdges edges_;
  FiberFrame x_;
  FiberFrame y_;
  TriangleGrid triangles_;
};

}  // namespace

absl::StatusOr<std::vector<std::vector<WaterlineLoop>>> Waterlines(
    const TriangleMesh& mesh, const Cutter& cutter, std::span<const double> levels_mm,
    const WaterlineOptions& options, const CancelToken& cancel) {
  if (absl::Status status = CheckWaterline(mesh, levels_mm, options); !status.ok()) return status;
  const auto grids = GridsOver(mesh, cutter, options.sampling_mm, levels_mm.size());
  if (!grids.ok()) return grids.status();
  std::vector<size_t> order(levels_mm.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return levels_mm[a] > levels_mm[b]; });
  std::vector<double> descending;
  for (const size_t i : order) descending.push_back(levels_mm[i]);
  auto made = WaterlineMaker(mesh, cutter, options).Run(*grids, descending, cancel);
  if (!made.ok()) return made.status();
  std::vector<std::vector<WaterlineLoop>> result(levels_mm.size());
  for (size_t i = 0; i < order.size(); ++i) result[order[i]] = std::move((*made)[i]);
  return result;
}

}  // namespace slicefarm::milling
