#include "services/milling/algo/motion/rest_cutter.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "services/milling/algo/strategy/surface_pass.h"

namespace slicefarm::milling {
namespace {

/// Distance between the positions at which a run is tested for stock, as a fraction of the radius.
/// A contact of less than kRunTouchMm does not count: it results from single precision and chords.
constexpr double kRunAskShare = 0.25;
constexpr double kRunTouchMm = 2e-3;
/// Largest distance between ends of runs, in row distances, that are connected along the surface.
constexpr double kMostLinkRows = 2.5;
constexpr double kLinkStepShare = 0.2;

/// Position on a run: one of its points, or a point between two of them.
struct RunPosition {
  Eigen::Vector3d tip{0, 0, 0};
  bool corner = false;
  bool in_stock = false;
};

std::vector<RunPosition> PositionsOfRun(const RestRun& run, const MillingJob& job,
                                        const StockMap& stock) {
  const double step = kRunAskShare * job.options.cutter.radius_mm();
  std::vector<RunPosition> positions = {{.tip = run[0], .corner = true}};
  for (size_t i = 0; i + 1 < run.size(); ++i) {
    const double steps = std::max(1.0, std::ceil((run[i + 1] - run[i]).norm() / step));
    for (double k = 1; k <= steps; ++k)
      positions.push_back(
          {.tip = run[i] + (run[i + 1] - run[i]) * (k / steps), .corner = k == steps});
  }
  // The cutter is not widened here as in other tests: along a finished wall, every run would then
  // meet the wall.
  const Eigen::Vector3d touch(0, 0, kRunTouchMm);
  for (RunPosition& position : positions) position.in_stock = stock.Meets(position.tip + touch, 0);
  return positions;
}

/// Returns the parts of a run that meet stock, each extended by one test position at both ends.
/// Parts closer to each other than the cutter's diameter are merged.
std::vector<RestRun> PartsInStock(const RestRun& run, const MillingJob& job,
                                  const StockMap& stock) {
  const std::vector<RunPosition> positions = PositionsOfRun(run, job, stock);
  const auto gap = static_cast<size_t>(2 / kRunAskShare);
  std::vector<RestRun> parts;
  for (size_t i = 0; i < positions.size(); ++i) {
    if (!positions[i].in_stock) continue;
    size_t last = i;
    for (size_t k = i + 1; k < positions.size() && k <= last + gap; ++k)
      if (positions[k].in_stock) last = k;
    const size_t from = i > 0 ? i - 1 : 0, to = std::min(positions.size() - 1, last + 1);
    RestRun& part = parts.emplace_back();
    for (size_t k = from; k <= to; ++k)
      if (positions[k].corner || k == from || k == to) part.push_back(positions[k].tip);
    i = to;
  }
  return parts;
}

/// Runs that are not cut yet, with a search for the nearest end of a run.
class OpenRuns {
 public:
  OpenRuns(std::span<const MilledStep> rows, const MillingJob& job, const StockMap& stock,
           const CancelToken& cancel) {
    for (const MilledStep& row : rows) {
      if (cancel.Cancelled()) return;
      for (const RestRun& run : row.runs) {
        std::vector<RestRun> parts = PartsInStock(run, job, stock);
        std::move(parts.begin(), parts.end(), std::back_inserter(runs_));
      }
    }
  }

  bool empty() const { return runs_.empty(); }

  RestRun TakeFirst() { return Take(0, false); }

  RestRun TakeNearest(const Eigen::Vector2d& at) {
    size_t nearest = 0;
    bool turned = false;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < runs_.size(); ++i) {
      for (const bool back : {false, true}) {
        const Eigen::Vector3d& end = back ? runs_[i].back() : runs_[i].front();
        const double distance = (end.head<2>() - at).squaredNorm();
        if (distance < least) least = distance, nearest = i, turned = back;
      }
    }
    return Take(nearest, turned);
  }

 private:
  RestRun Take(size_t index, bool turned) {
    RestRun run = std::move(runs_[index]);
    runs_.erase(runs_.begin() + static_cast<ptrdiff_t>(index));
    if (turned) std::reverse(run.begin(), run.end());
    return run;
  }

  std::vector<RestRun> runs_;
};

/// Returns a path along the surface from the tip to a position. Returns nothing if the position is
/// too far or a wall is between them.
std::optional<RestRun> SurfaceLink(const MillingJob& job, const DropCutter& dropper,
                                   const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double row = job.options.finish_stepover_mm;
  const double length = (to - from).head<2>().norm();
  if (length > kMostLinkRows * row || std::abs(to.z() - from.z()) > kMostLinkRows * row)
    return std::nullopt;
  const auto height = [&](const Eigen::Vector2d& p) {
    const auto drop = dropper.At(p);
    return drop ? std::max(drop->z_mm, job.floor_mm) : job.floor_mm;
  };
  RestRun link;
  const double steps = std::max(1.0, std::ceil(length / (kLinkStepShare * row)));
  Eigen::Vector3d last = from;
  for (double k = 1; k <= steps; ++k) {
    Eigen::Vector3d next = k == steps ? to : from + (to - from) * (k / steps);
    if (k < steps) next.z() = height(next.head<2>());
    if (std::abs(next.z() - last.z()) > row) return std::nullopt;
    for (const Eigen::Vector3d& p : SurfacePass(last, next, job.options.tolerance_mm, height))
      link.push_back(p);
    last = next;
  }
  return link;
}

}  // namespace

absl::StatusOr<int> CutRest(const MillingJob& job, std::span<const MilledStep> rows,
                            MoveBuilder& moves, const CancelToken& cancel) {
  const MachiningOptions& how = job.options.machining;
  const DropCutter dropper(job.part, job.options.cutter);
  OpenRuns open(rows, job, moves.stock(), cancel);
  int cut = 0;
  for (bool first = true; !open.empty(); first = false) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const RestRun run = first ? open.TakeFirst() : open.TakeNearest(moves.at().head<2>());
    const auto link = first ? std::nullopt : SurfaceLink(job, dropper, moves.at(), run.front());
    if (link) {
      for (const Eigen::Vector3d& p : *link) moves.LineTo(p, how.feed_mm_min);
    } else {
      moves.RapidTo(run.front().head<2>(), run.front().z());
      moves.LineTo(run.front(), how.plunge_feed_mm_min);
    }
    for (const Eigen::Vector3d& p : run) moves.LineTo(p, how.feed_mm_min);
    ++cut;
  }
  if (absl::Status status = cancel.Check(); !status.ok()) return status;
  return cut;
}

}  // namespace slicefarm::milling
