#include "services/milling/algo/motion/rest_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace slicefarm::milling {
namespace {

/// A run is asked at places as far apart as this share of the radius whether it meets stock; so
/// much is no stock but what single precision and chords leave.
constexpr double kRunAskShare = 0.25;
constexpr double kRunTouchMm = 2e-3;
/// Ends nearer than so many rows are joined along the surface.
constexpr double kMostLinkRows = 2.5;
constexpr double kLinkStepShare = 0.2;

bool RunMeetsStock(const RestRun& run, const MillingJob& job, const StockMap& stock) {
  const double step = kRunAskShare * job.options.cutter.radius_mm();
  for (size_t i = 0; i + 1 < run.size(); ++i) {
    const double steps = std::max(1.0, std::ceil((run[i + 1] - run[i]).norm() / step));
    for (double k = 0; k <= steps; ++k) {
      Eigen::Vector3d tip = run[i] + (run[i + 1] - run[i]) * (k / steps);
      tip.z() += kRunTouchMm;
      if (stock.Meets(tip, stock.pixel_mm())) return true;
    }
  }
  return false;
}

/// Runs not cut yet, and which of their ends is nearest.
class OpenRuns {
 public:
  OpenRuns(std::span<const MilledStep> rows, const MillingJob& job, const StockMap& stock) {
    for (const MilledStep& row : rows)
      for (const RestRun& run : row.runs)
        if (RunMeetsStock(run, job, stock)) runs_.push_back(&run);
  }

  bool empty() const { return runs_.empty(); }

  RestRun TakeFirst() { return Take(0, false); }

  RestRun TakeNearest(const Eigen::Vector2d& at) {
    size_t nearest = 0;
    bool turned = false;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < runs_.size(); ++i) {
      for (const bool back : {false, true}) {
        const Eigen::Vector3d& end = back ? runs_[i]->back() : runs_[i]->front();
        const double distance = (end.head<2>() - at).squaredNorm();
        if (distance < least) least = distance, nearest = i, turned = back;
      }
    }
    return Take(nearest, turned);
  }

 private:
  RestRun Take(size_t index, bool turned) {
    RestRun run = *runs_[index];
    runs_.erase(runs_.begin() + static_cast<ptrdiff_t>(index));
    if (turned) std::reverse(run.begin(), run.end());
    return run;
  }

  std::vector<const RestRun*> runs_;
};

/// From the tip along the surface to a place, or empty where that is too far or a wall stands
/// there.
std::optional<RestRun> SurfaceLink(const MillingJob& job, const DropCutter& dropper,
                                   const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double row = job.options.finish_stepover_mm;
  const double length = (to - from).head<2>().norm();
  if (length > kMostLinkRows * row || std::abs(to.z() - from.z()) > kMostLinkRows * row)
    return std::nullopt;
  RestRun link;
  const double steps = std::max(1.0, std::ceil(length / (kLinkStepShare * row)));
  double last = from.z();
  for (double k = 1; k < steps; ++k) {
    const Eigen::Vector3d p = from + (to - from) * (k / steps);
    const auto drop = dropper.At(p.head<2>());
    const double z = drop ? std::max(drop->z_mm, job.floor_mm) : job.floor_mm;
    if (std::abs(z - last) > row) return std::nullopt;
    last = z;
    link.push_back({p.x(), p.y(), z});
  }
  if (std::abs(to.z() - last) > row) return std::nullopt;
  link.push_back(to);
  return link;
}

}  // namespace

absl::StatusOr<int> CutRest(const MillingJob& job, std::span<const MilledStep> rows,
                            MoveBuilder& moves, const CancelToken& cancel) {
  const MachiningOptions& how = job.options.machining;
  const DropCutter dropper(job.part, job.options.cutter);
  OpenRuns open(rows, job, moves.stock());
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
  return cut;
}

}  // namespace slicefarm::milling
