#include "common/wire/milling/mill_input_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mill_input_wire_test {
namespace {

MillInput Input(bool stock) {
  const IndexedMesh mesh = {{{0, 0, 0}, {9, 0, 0}, {0, 9, -7}}, {{0, 1, 2}}};
  MillInput input{mesh, stock ? mesh : IndexedMesh(), {}};
  input.settings.stock = "blank";
  input.settings.how.cutter = *Cutter::Bull(6, 1);
  return input;
}

TEST(MillInputWire, Returns) {
  ExpectReturns<v1::MillInput>(Input(false));
  ExpectReturns<v1::MillInput>(Input(true));
}

TEST(MillInputWire, RefusesWhatIsNoInput) {
  auto proto = ProtoOf<v1::MillInput>(Input(true));
  proto.mutable_part()->set_corners(2, 3);
  ExpectMalformed(FromProto(proto).status(), "part.piece.corners");
  proto = ProtoOf<v1::MillInput>(Input(true));
  proto.mutable_stock()->add_xyz_nm(3);
  ExpectMalformed(FromProto(proto).status(), "stock.piece");
  proto = ProtoOf<v1::MillInput>(Input(true));
  proto.clear_part();
  EXPECT_FALSE(FromProto(proto).ok()) << "a job has a part";
  proto = ProtoOf<v1::MillInput>(Input(true));
  proto.clear_settings();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::mill_input_wire_test
