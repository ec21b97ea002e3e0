#include "services/milling/algo/motion/stock_cutter.h"

#include <gtest/gtest.h>

#include "services/milling/algo/sample_jobs_test.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling::stock_cutter_test {
namespace {

Polygon SquareRing(double low, double high) {
  return {PointOf({low, low}), PointOf({high, low}), PointOf({high, high}), PointOf({low, high})};
}

const CancelToken kNever;

/// Returns a job with stock from -1 to 19 mm, 10 mm high, around a low plate.
MillingJob PlateJob() {
  return JobOf(Pillars{.heights = {{9}}, .side = 18}.Mesh(), OptionsFor("cyl:4"));
}

size_t CountOf(const std::vector<MillMove>& moves, MoveKind kind) {
  return static_cast<size_t>(
      std::count_if(moves.begin(), moves.end(), [&](const MillMove& m) { return m.kind == kind; }));
}

TEST(StockCutter, EntersFromOutsideAndStaysDown) {
  const MillingJob job = PlateJob();
  MoveBuilder moves(job);
  StockCutter cutter(job.options, moves, kNever);
  const CutArea area{.area = {SquareRing(-3.5, 21.5), {}},
                     .passes = {SquareRing(-3.5, 21.5), SquareRing(-1.9, 19.9), SquareRing(0, 18)}};
  EXPECT_EQ(cutter.Cut(area, 9.5, MillPhase::kRoughing), 2);  // the first pass is in air
  const std::vector<MillMove> made = moves.TakeMoves();
  EXPECT_EQ(CountOf(made, MoveKind::kRapid), 2u);  // horizontally, and down beside the stock
  EXPECT_EQ(CountOf(made, MoveKind::kCounterClockwise), 0u);
}

TEST(StockCutter, GoesDownIntoAPocketByAHelixOrAlongItsPass) {
  for (const EntryKind entry : {EntryKind::kHelix, EntryKind::kRamp, EntryKind::kPlunge}) {
    MillingJob job = PlateJob();
    job.options.machining.entry = entry;
    MoveBuilder moves(job);
    StockCutter cutter(job.options, moves, kNever);
    const CutArea area{.area = {SquareRing(4, 14), {}}, .passes = {SquareRing(7, 11)}};
    EXPECT_EQ(cutter.Cut(area, 9.2, MillPhase::kRoughing), 1);
    const std::vector<MillMove> made = moves.TakeMoves();
    EXPECT_EQ(CountOf(made, MoveKind::kCounterClockwise) > 0, entry == EntryKind::kHelix);
    double straight_down = 0;
    for (size_t i = 1; i < made.size(); ++i)
      if (made[i].kind == MoveKind::kLine && made[i].to_mm.z() < 10 - 1e-9 &&
          made[i].to_mm.head<2>() == made[i - 1].to_mm.head<2>())
        straight_down += std::min(10.0, made[i - 1].to_mm.z()) - made[i].to_mm.z();
    EXPECT_NEAR(straight_down, entry == EntryKind::kPlunge ? 0.8 : 0, 1e-6);
  }
}

TEST(StockCutter, LeavesOutWhatIsCutAlready) {
  const MillingJob job = PlateJob();
  MoveBuilder moves(job);
  StockCutter cutter(job.options, moves, kNever);
  const CutArea wide{.area = {SquareRing(4, 14), {}},
                     .passes = {SquareRing(8, 10), SquareRing(6, 12), SquareRing(4, 14)}};
  const CutArea again{.area = {SquareRing(5, 13), {}}, .passes = {SquareRing(8, 10)}};
  EXPECT_EQ(cutter.Cut(wide, 9.2, MillPhase::kRoughing), 3);
  EXPECT_EQ(cutter.Cut(again, 9.2, MillPhase::kRoughing), 0);
  EXPECT_EQ(cutter.Cut(again, 9.0, MillPhase::kRoughing), 1);
}

TEST(StockCutter, MeetsFinishingPassesByArcs) {
  MillingJob job = PlateJob();
  job.options.machining.lead_in_radius_mm = 0.5;
  MoveBuilder moves(job);
  StockCutter cutter(job.options, moves, kNever);
  const CutArea rough{.area = {SquareRing(4, 14), {}},
                      .passes = {SquareRing(8, 10), SquareRing(6, 12), SquareRing(4.2, 13.8)}};
  cutter.Cut(rough, 9.2, MillPhase::kRoughing);
  moves.Retract();
  moves.TakeMoves();
  Polygon ring = SquareRing(4, 14);
  ring.insert(ring.begin() + 1, PointOf({9, 4}));
  moves.RapidTo({9, 6}, 9.2);
  const CutArea fine{.area = {SquareRing(4, 14), {}}, .passes = {ring}};
  EXPECT_EQ(cutter.Cut(fine, 9.2, MillPhase::kFinishing), 1);
  EXPECT_EQ(CountOf(moves.TakeMoves(), MoveKind::kCounterClockwise), 0u);  // near, so straight
  moves.Retract();
  StockCutter other(job.options, moves, kNever);
  Polygon deeper = ring;
  EXPECT_EQ(other.Cut({.area = fine.area, .passes = {deeper}}, 9.1, MillPhase::kFinishing), 1);
}

}  // namespace
}  // namespace slicefarm::milling::stock_cutter_test
