#include "common/wire/milling/milled_wire.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::milled_wire_test {
namespace {

MilledStep Level() {
  MilledStep level{{MillPhase::kFinishing, 2.25}, {}, {}};
  const MultiPolygon area = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9)(3 3, 3 6, 6 6)");
  level.areas.push_back({area[0], {area[0].outer, area[0].holes[0]}});
  level.areas.push_back({{area[0].outer, {}}, {}});
  return level;
}

MillReport Report() {
  MillReport report;
  report.phases[1] = {1.5, 2.5, 3.5, 4, 5};
  report.passes = 6;
  report.removed_mm3 = 7.5;
  report.checked = 8;
  report.gouges = 1;
  report.first_gouge_mm = {1, -2, 3};
  return report;
}

MillLayout Layout() {
  MillLayout layout;
  layout.steps = {{MillPhase::kRoughing, 3}, {MillPhase::kRest, -1.5}};
  layout.weights = {5, 1};
  layout.part_mm = {Eigen::Vector3d(0, 1, 2), Eigen::Vector3d(3, 4, 5)};
  layout.stock_mm = {Eigen::Vector3d(-1, 0, 2), Eigen::Vector3d(4, 5, 6)};
  return layout;
}

TEST(MilledWire, StepsReturn) {
  ExpectReturns<v1::MilledStep>(Level());
  ExpectReturns<v1::MilledStep>(
      MilledStep{{MillPhase::kRest, -7}, {}, {{{0, 1, 0.1}, {2, 1, 3}}, {{0, 2, 1}, {1, 2, 1}}}});
  ExpectReturns<v1::MillReport>(Report());
  ExpectReturns<v1::MillReport>(MillReport());
  ExpectEveryChangeReturns<v1::MillReport, MillReport>(ProtoOf<v1::MillReport>(Report()));
}

TEST(MilledWire, LayoutsReturn) {
  const auto back = FromProto(ProtoOf<v1::MillLayout>(Layout()));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->steps, Layout().steps);
  EXPECT_EQ(back->weights, Layout().weights);
  EXPECT_TRUE(back->part_mm.isApprox(Layout().part_mm, 0));
  EXPECT_TRUE(back->stock_mm.isApprox(Layout().stock_mm, 0));
  ExpectEveryChangeReturns<v1::MillLayout, MillLayout>(ProtoOf<v1::MillLayout>(Layout()));
}

TEST(MilledWire, RefusesWhatIsNoStep) {
  auto step = ProtoOf<v1::MilledStep>(Level());
  step.clear_phase();
  ExpectMalformed(FromProto(step).status(), "phase");
  step = ProtoOf<v1::MilledStep>(Level());
  *step.mutable_areas(0)->mutable_passes() = step.areas(0).area();
  ExpectMalformed(FromProto(step).status(), "areas[0].passes");
  step = ProtoOf<v1::MilledStep>(Level());
  step.mutable_areas(1)->clear_area();
  ExpectMalformed(FromProto(step).status(), "areas[1].area");
  step.clear_areas();
  step.add_runs()->add_xyz_mm(1);
  ExpectMalformed(FromProto(step).status(), "runs[0].xyz_mm");
  step.mutable_runs(0)->add_xyz_mm(1);
  step.mutable_runs(0)->add_xyz_mm(std::numeric_limits<double>::quiet_NaN());
  ExpectMalformed(FromProto(step).status(), "runs[0].xyz_mm");
  for (const std::vector<double>& run : std::vector<std::vector<double>>{
           {}, {1, 1, 1}, {1, 1, 1, 1e9, 1, 1}}) {  // no point, one, one that is far away
    step.mutable_runs(0)->mutable_xyz_mm()->Assign(run.begin(), run.end());
    ExpectMalformed(FromProto(step).status(), "runs[0].xyz_mm");
  }
}

TEST(MilledWire, RefusesWhatIsNoLayout) {
  auto layout = ProtoOf<v1::MillLayout>(Layout());
  layout.set_weights(0, 0);
  ExpectMalformed(FromProto(layout).status(), "weights");
  layout = ProtoOf<v1::MillLayout>(Layout());
  layout.add_at_mm(1);
  ExpectMalformed(FromProto(layout).status(), "at_mm, weights");
  layout = ProtoOf<v1::MillLayout>(Layout());
  layout.clear_stock_mm();
  ExpectMalformed(FromProto(layout).status(), "stock_mm");
}

TEST(MilledWire, RefusesRangesThatNoJobHas) {
  EXPECT_EQ(*FromProto(ToProto(StepRange{2, 5})), (StepRange{2, 5}));
  for (const StepRange range : {StepRange{0, 0}, StepRange{3, 2}, StepRange{-1, 2},
                                StepRange{0, std::numeric_limits<int32_t>::max()}})
    ExpectMalformed(FromProto(ToProto(range)).status(), "range");
}

}  // namespace
}  // namespace slicefarm::milled_wire_test
