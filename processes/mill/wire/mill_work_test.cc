#include "processes/mill/wire/mill_work.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mill_work_test {
namespace {

// Sets every member. A new member does not compile until it is set here, and thus tested on the
// wire.
MillTask Work() {
  MillTask task;
  auto& [steps, phase, phase_first, weight, input] = task;
  steps = {110, 141};
  phase = MillPhase::kRest;
  phase_first = 10;
  weight = 7;
  return task;
}

TEST(MillWork, Returns) {
  const absl::StatusOr<MillTask> back = FromProto(ProtoOf<v1::MillWork>(Work()));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->steps, Work().steps);
  EXPECT_EQ(back->phase, MillPhase::kRest);
  EXPECT_EQ(back->phase_first, 10);
  EXPECT_EQ(back->weight, 7);
  ExpectEveryChangeReturns<v1::MillWork, MillTask>(ProtoOf<v1::MillWork>(Work()));
}

TEST(MillWork, RefusesWhatNoJobHas) {
  auto work = ProtoOf<v1::MillWork>(Work());
  work.clear_range();
  ExpectMalformed(FromProto(work).status(), "range");
  work = ProtoOf<v1::MillWork>(Work());
  work.clear_phase();
  ExpectMalformed(FromProto(work).status(), "phase");
  work = ProtoOf<v1::MillWork>(Work());
  work.set_phase_first(111);
  ExpectMalformed(FromProto(work).status(), "phase_first");
  work = ProtoOf<v1::MillWork>(Work());
  work.set_weight(-1);
  ExpectMalformed(FromProto(work).status(), "weight");
}

}  // namespace
}  // namespace slicefarm::mill_work_test
