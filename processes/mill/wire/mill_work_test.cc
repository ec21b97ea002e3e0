#include "processes/mill/wire/mill_work.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mill_work_test {
namespace {

const MillWork kWork = {{110, 141}, MillPhase::kRest, 10, 7, "digest"};

TEST(MillWork, Returns) {
  ExpectReturns<v1::MillWork>(kWork);
  ExpectEveryChangeReturns<v1::MillWork, MillWork>(ProtoOf<v1::MillWork>(kWork));
}

TEST(MillWork, RefusesWhatNoJobHas) {
  auto work = ProtoOf<v1::MillWork>(kWork);
  work.clear_range();
  ExpectMalformed(FromProto(work).status(), "range");
  work = ProtoOf<v1::MillWork>(kWork);
  work.clear_phase();
  ExpectMalformed(FromProto(work).status(), "phase");
  work = ProtoOf<v1::MillWork>(kWork);
  work.set_phase_first(111);
  ExpectMalformed(FromProto(work).status(), "phase_first");
  work = ProtoOf<v1::MillWork>(kWork);
  work.set_weight(-1);
  ExpectMalformed(FromProto(work).status(), "weight");
}

}  // namespace
}  // namespace slicefarm::mill_work_test
