#include "common/wire/engraving/texture_start_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::texture_start_wire_test {
namespace {

TEST(TextureStartWire, Returns) {
  TextureStart start;
  start.call.job_id = "j";
  start.shared = "digest";
  start.range = {3, 9};
  const auto proto = ProtoOf<v1::TextureStart>(start);
  const absl::StatusOr<TextureStart> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->range, start.range);
  EXPECT_EQ(back->shared, start.shared);
  auto wrong = proto;
  wrong.mutable_range()->set_first(-1);
  EXPECT_EQ(DetailOf(FromProto(wrong).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::texture_start_wire_test
