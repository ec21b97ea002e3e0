#include "common/wire/milling/milling_options_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::milling_options_wire_test {
namespace {

TEST(MillingOptionsWire, Return) {
  MillSettings settings;
  settings.how.cutter = *Cutter::BullCone(2, 0.5, 30, 4);
  settings.how.machining.entry = EntryKind::kRamp;
  settings.stock = "blank";
  settings.output_step = 3;
  ExpectReturns<v1::MillSettings>(settings);
  ExpectReturns<v1::MillSettings>(MillSettings());
  // "bullcone:2:0.5:30:4x" is no cutter.
  ExpectEveryChangeReturns<v1::MillSettings, MillSettings>(ProtoOf<v1::MillSettings>(settings),
                                                           {"how.cutter"});
}

TEST(MillingOptionsWire, RefuseWhatIsIncomplete) {
  auto proto = ProtoOf<v1::MillSettings>(MillSettings());
  proto.mutable_how()->clear_machining();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kRequestMalformed);
  proto = ProtoOf<v1::MillSettings>(MillSettings());
  proto.mutable_how()->set_cutter("drill:6");
  EXPECT_EQ(DetailOf(FromProto(proto).status()).metadata.at("setting"), "cutter");
  proto = ProtoOf<v1::MillSettings>(MillSettings());
  proto.set_output_step(-1);
  ExpectMalformed(FromProto(proto).status(), "output_step");
}

}  // namespace
}  // namespace slicefarm::milling_options_wire_test
