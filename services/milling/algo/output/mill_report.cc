#include "services/milling/algo/output/mill_report.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

#include "common/base/parallel.h"
#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/motion/mill_clock.h"

namespace slicefarm::milling {
namespace {

constexpr size_t kPlacesATask = 4096;

void Count(const MillMove& move, const Eigen::Vector3d& from, double seconds, PhaseReport& phase) {
  const bool rapid = move.kind == MoveKind::kRapid;
  (rapid ? phase.rapid_mm : phase.cut_mm) += LengthOf(move, from);
  phase.seconds += seconds;
  ++phase.moves;
  if (move.kind == MoveKind::kClockwise || move.kind == MoveKind::kCounterClockwise) ++phase.arcs;
}

/// Returns all tip positions to check.
std::vector<Eigen::Vector3d> PlacesOfTip(const MillProgram& program, double tolerance_mm) {
  std::vector<Eigen::Vector3d> places;
  for (size_t i = 1; i < program.moves.size(); ++i) {
    Eigen::Vector3d from = program.moves[i - 1].to_mm;
    for (const Eigen::Vector3d& to : PointsOf(program.moves[i], from, tolerance_mm / 4)) {
      places.push_back((from + to) / 2);
      places.push_back(to);
      from = to;
    }
  }
  return places;
}

/// Checks if a program's tip gouges at a position.
class GougeCheck {
 public:
  explicit GougeCheck(const MillingJob& job)
      : less_(job.options.cutter.Grown(-job.options.tolerance_mm)),
        dropper_(job.part, less_.cutter) {}

  bool At(const Eigen::Vector3d& tip) const {
    const auto drop = dropper_.At(tip.head<2>());
    return drop && drop->z_mm > tip.z() + less_.tip_mm;
  }

 private:
  GrownCutter less_;
  DropCutter dropper_;
};

}  // namespace

absl::StatusOr<MillReport> ReportOf(const MillingJob& job, const MillProgram& program,
                                    const CancelToken& cancel, int threads) {
  MillReport report;
  report.passes = program.passes;
  report.removed_mm3 = program.removed_mm3;
  const std::vector<MoveTime> times = TimesOf(program.moves, job.options, cancel);
  for (size_t i = 1; i < program.moves.size(); ++i) {
    const MillMove& move = program.moves[i];
    Count(move, program.moves[i - 1].to_mm, times[i].seconds,
          report.phases[static_cast<size_t>(move.phase)]);
  }
  const std::vector<Eigen::Vector3d> places = PlacesOfTip(program, job.options.tolerance_mm);
  const GougeCheck check(job);
  const size_t tasks = (places.size() + kPlacesATask - 1) / kPlacesATask;
  std::vector<std::vector<size_t>> gouges(tasks);
  std::atomic<bool> cancelled = false;
  ForEachIndex(threads, tasks, [&](size_t task, int) {
    if (cancelled || cancel.Cancelled()) {
      cancelled = true;
      return;
    }
    const size_t last = std::min(places.size(), (task + 1) * kPlacesATask);
    for (size_t i = task * kPlacesATask; i < last; ++i)
      if (check.At(places[i])) gouges[task].push_back(i);
  });
  if (cancelled) return cancel.Check();
  report.checked = std::ssize(places);
  for (const std::vector<size_t>& of_task : gouges) {
    if (report.gouges == 0 && !of_task.empty()) report.first_gouge_mm = places[of_task.front()];
    report.gouges += std::ssize(of_task);
  }
  return report;
}

}  // namespace slicefarm::milling
