#include "processes/mill/wire/mill_work.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mill_work_test {
namespace {

const MillInput& Input() {
  static const MillInput input = {
      {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}}, {}, {.stock = "blank"}, ""};
  return input;
}

v1::MillWork Work() {
  return ProtoOf<v1::MillWork>(MillTask{{110, 141}, MillPhase::kRest, 10, 7, &Input()});
}

TEST(MillWork, Returns) {
  absl::StatusOr<MillWork> back = FromProto(Work());
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->task.Label().text, "rest rows 10 to 40");
  EXPECT_EQ(back->task.weight, 7);
  EXPECT_EQ(back->task.steps, (StepRange{110, 141}));
  ASSERT_TRUE(ForEachPiece(Input().part, [&](const v1::MeshPiece& piece) {
                return back->input.Add(piece).ok();
              }).ok());
  const auto input = back->input.Finish();
  ASSERT_TRUE(input.ok()) << input.status();
  EXPECT_EQ(input->part, Input().part);
  EXPECT_EQ(input->settings, Input().settings);
  EXPECT_EQ(input->digest, DigestOf(Input().part, {}));
}

TEST(MillWork, RefusesWhatNoJobHas) {
  auto work = Work();
  work.clear_range();
  ExpectMalformed(FromProto(work).status(), "range");
  work = Work();
  work.clear_phase();
  ExpectMalformed(FromProto(work).status(), "phase");
  work = Work();
  work.set_phase_first(111);
  ExpectMalformed(FromProto(work).status(), "phase_first");
  work = Work();
  work.set_weight(-1);
  ExpectMalformed(FromProto(work).status(), "weight");
  work = Work();
  work.mutable_head()->mutable_settings()->clear_how();
  EXPECT_EQ(DetailOf(FromProto(work).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::mill_work_test
