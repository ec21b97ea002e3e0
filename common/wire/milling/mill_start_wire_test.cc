#include "common/wire/milling/mill_start_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mill_start_wire_test {
namespace {

TEST(MillStartWire, Returns) {
  MillStart start;
  start.call.job_id = "j";
  start.shared = "digest";
  start.range = {3, 9};
  start.step_count = 4;
  start.settings_text = "stepdown = 1\n";
  const auto proto = ProtoOf<v1::MillStart>(start);
  const absl::StatusOr<MillStart> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->range, start.range);
  EXPECT_EQ(back->settings_text, start.settings_text);
  ExpectEveryChangeReturns<v1::MillStart, MillStart>(proto, {"build_id"});
  auto wrong = proto;
  wrong.set_step_count(-1);
  ExpectMalformed(FromProto(wrong).status(), "step_count");
}

}  // namespace
}  // namespace slicefarm::mill_start_wire_test
