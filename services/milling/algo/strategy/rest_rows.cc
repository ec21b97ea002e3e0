#include "services/milling/algo/strategy/rest_rows.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/base/parallel.h"
#include "common/base/portable_math.h"
#include "common/geometry/rings/simplify.h"
#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/strategy/plane.h"
#include "services/milling/algo/strategy/surface_pass.h"

namespace slicefarm::milling {
namespace {

/// Share of the tolerance for removing points of a run.
constexpr double kChordShare = 0.1;
constexpr double kNowhere = -std::numeric_limits<double>::infinity();

/// Samples of all rows, evenly spaced along x.
struct RestColumns {
  double first_mm = 0;
  double pitch_mm = 0;
  int count = 0;

  double At(int i) const { return first_mm + i * pitch_mm; }
};

RestColumns ColumnsOf(const MillingJob& job) {
  const double from = RestBox(job).min().x(), to = RestBox(job).max().x();
  const double steps = std::ceil((to - from) / job.options.finish_stepover_mm - 1e-9);
  return {from, (to - from) / steps, static_cast<int>(steps) + 1};
}

/// Makes the runs of one row.
class RestRow {
 public:
  RestRow(const MillingJob& job, const DropCutter& dropper, double y_mm)
      : dropper_(dropper),
        floor_mm_(job.floor_mm),
        beside_mm_(job.options.finish_floor ? job.floor_mm : kNowhere),
        tolerance_mm_(job.options.tolerance_mm),
        columns_(ColumnsOf(job)),
        rise_(Tan(job.options.rest_angle_deg * std::numbers::pi / 180)),
        y_mm_(y_mm),
        z_(Heights(y_mm)),
        below_(Heights(y_mm - columns_.pitch_mm)),
        above_(Heights(y_mm + columns_.pitch_mm)) {}

  std::vector<RestRun> Runs() const {
    std::vector<RestRun> runs;
    for (int i = 0; i < columns_.count; ++i) {
      if (!Flat(i)) continue;
      const int first = i > 0 && Joined(i - 1) ? i - 1 : i;
      while (i + 1 < columns_.count && Flat(i + 1) && Joined(i)) ++i;
      const int last = i + 1 < columns_.count && Joined(i) ? i + 1 : i;
      if (last > first) runs.push_back(RunOver(first, last));
    }
    return runs;
  }

 private:
  double Height(double x, double y) const {
    const auto drop = dropper_.At({x, y});
    return drop ? std::max(drop->z_mm, floor_mm_) : beside_mm_;
  }

  std::vector<double> Heights(double y) const {
    std::vector<double> heights;
    for (int i = 0; i < columns_.count; ++i) heights.push_back(Height(columns_.At(i), y));
    return heights;
  }

  double HeightAt(int i) const { return i < 0 || i >= columns_.count ? kNowhere : z_[i]; }

  /// Returns true if the surface is flat at a sample. Of the two slopes in each direction, the
  /// smaller one counts, because a wall may be on the other side.
  bool Flat(int i) const {
    if (z_[i] == kNowhere) return false;
    const double dx =
        std::min(std::abs(HeightAt(i - 1) - z_[i]), std::abs(HeightAt(i + 1) - z_[i]));
    const double dy = std::min(std::abs(below_[i] - z_[i]), std::abs(above_[i] - z_[i]));
    const double most = rise_ * columns_.pitch_mm;
    return dx * dx + dy * dy <= most * most;
  }

  /// Returns true if there is no wall between a sample and the next one.
  bool Joined(int i) const {
    return std::abs(z_[i + 1] - z_[i]) <= 2 * std::max(rise_, 0.1) * columns_.pitch_mm;
  }

  RestRun RunOver(int first, int last) const {
    const auto height = [this](const Eigen::Vector2d& p) { return Height(p.x(), p.y()); };
    Polyline line = {PointOf({columns_.At(first), z_[first]})};  // a line in the plane of x and z
    for (int i = first; i < last; ++i) {
      const Eigen::Vector3d a(columns_.At(i), y_mm_, z_[i]);
      const Eigen::Vector3d b(columns_.At(i + 1), y_mm_, z_[i + 1]);
      for (const Eigen::Vector3d& p : SurfacePass(a, b, tolerance_mm_, height))
        line.push_back(PointOf({p.x(), p.z()}));
    }
    RestRun run;
    for (const Point p : SimplifyLine(line, FromMm(kChordShare * tolerance_mm_))) {
      const Eigen::Vector2d place = PointMmOf(p);
      run.push_back({place.x(), y_mm_, place.y()});
    }
    return run;
  }

  const DropCutter& dropper_;
  double floor_mm_;
  double beside_mm_;  ///< height where no part is under the cutter
  double tolerance_mm_;
  RestColumns columns_;
  double rise_;
  double y_mm_;
  std::vector<double> z_, below_, above_;
};

}  // namespace

absl::StatusOr<std::vector<std::vector<RestRun>>> RestRows(const MillingJob& job,
                                                           std::span<const double> rows_mm,
                                                           const CancelToken& cancel, int threads) {
  const DropCutter dropper(job.part, job.options.cutter);
  std::vector<std::vector<RestRun>> rows(rows_mm.size());
  std::atomic<bool> cancelled = false;
  ForEachIndex(threads, rows_mm.size(), [&](size_t i, int) {
    if (cancelled || cancel.Cancelled()) {
      cancelled = true;
      return;
    }
    rows[i] = RestRow(job, dropper, rows_mm[i]).Runs();
  });
  if (cancelled) return cancel.Check();
  return rows;
}

}  // namespace slicefarm::milling
