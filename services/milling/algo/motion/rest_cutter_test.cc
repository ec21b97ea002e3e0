#include "services/milling/algo/motion/rest_cutter.h"

#include <gtest/gtest.h>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::rest_cutter_test {
namespace {

std::vector<MilledStep> RestSteps(const MillingJob& job) {
  std::vector<MilledStep> steps = AllSteps(job);
  std::erase_if(steps, [](const MilledStep& s) { return s.step.phase != MillPhase::kRest; });
  return steps;
}

/// On the top of a plate, the rows are connected along the surface and each one is cut once. A
/// second call cuts nothing.
TEST(CutRest, JoinsRowsAndLeavesOutWhatIsCut) {
  const MillingJob job = JobOf(Pillars{.heights = {{3}}, .side = 8}.Mesh(), OptionsFor("cyl:2"));
  const std::vector<MilledStep> rows = RestSteps(job);
  size_t runs = 0;
  for (const MilledStep& row : rows) runs += row.runs.size();
  MoveBuilder moves(job);
  const auto cut = CutRest(job, rows, moves, {});
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(static_cast<size_t>(*cut), runs);
  size_t rapids = 0;
  for (const MillMove& move : moves.TakeMoves()) rapids += move.kind == MoveKind::kRapid ? 1 : 0;
  EXPECT_LE(rapids, 2u);
  EXPECT_EQ(*CutRest(job, rows, moves, {}), 0);
}

TEST(CutRest, StopsWhenCancelled) {
  const MillingJob job = JobOf(Pillars{.heights = {{3}}, .side = 8}.Mesh(), OptionsFor("cyl:2"));
  MoveBuilder moves(job);
  const auto cut = CutRest(job, RestSteps(job), moves, CancelToken([] { return true; }));
  EXPECT_EQ(cut.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::milling::rest_cutter_test
