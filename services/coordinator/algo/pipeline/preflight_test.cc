#include "services/coordinator/algo/pipeline/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format.h"
#include "common/base/error.h"

namespace slicefarm::coordinator::preflight_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Copies of an object: `layers` squares of 10 mm, and above them layers without outlines.
class FakeSlicing : public SlicingStage {
 public:
  explicit FakeSlicing(int layers, int copies = 1) : layers_(layers), copies_(copies) {}

  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override {
    EXPECT_EQ(options.first_layer_height_nm, 123);
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    SlicedJob job;
    for (int i = 0; i < 10; ++i) {
      SlicedLayer layer{{i, FromMm(0.2 * (i + 1)), FromMm(0.2)}, {}};
      ObjectSection section;
      section.layer = i;
      section.layer_count = 10;
      section.height_nm = layer.frame.height_nm;
      if (i < layers_)
        section.regions = {{.outlines = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")}};
      layer.sections = {section};
      job.layers.push_back(layer);
    }
    job.copies.resize(copies_);
    job.meshes.resize(1);
    job.meshes[0].open_edges = 4;
    if (input.advise_orientations) job.orientations.resize(1);
    return job;
  }

 private:
  const int layers_;
  const int copies_;
};

/// Each copy in a pass of its own, or a refusal.
class FakePlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall&, const SlicedOutlines& job,
                               const PlanningOptions&) const override {
    if (refuses) return absl::InvalidArgumentError("no order");
    JobPlan plan;
    for (const PlacedCopy& copy : job.copies)
      plan.copies.push_back(
          {copy.object, copy.shift, static_cast<int32_t>(plan.copies.size())});
    return plan;
  }

  bool refuses = false;
};

JobInput Input() {
  JobInput input;
  input.settings.slicing.first_layer_height_nm = 123;
  input.warnings = {"of a setting"};
  return input;
}

TEST(LookAt, TellsWhatThePlateIsLike) {
  const auto found = LookAt({}, Input(), FakeSlicing(10), FakePlanning());
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->layers, 10);
  EXPECT_DOUBLE_EQ(found->first_layer_area_mm2, 100);
  EXPECT_EQ(found->meshes.size(), 1);
  EXPECT_THAT(found->warnings,
              ElementsAre("of a setting", HasSubstr("4 edges with one face only")));
  EXPECT_GT(found->estimate.print_time_s, 0);
  EXPECT_NEAR(found->estimate.filament.volume_mm3, 200, 1e-6) << "all of it is skin";
}

TEST(LookAt, AdvisesOrientationsOnRequest) {
  JobInput input = Input();
  EXPECT_TRUE(LookAt({}, input, FakeSlicing(10), FakePlanning())->orientations.empty());
  input.meshes.advise_orientations = true;
  EXPECT_EQ(LookAt({}, input, FakeSlicing(10), FakePlanning())->orientations.size(), 1);
}

TEST(LookAt, CountsCopies) {
  const auto found = LookAt({}, Input(), FakeSlicing(10, 3), FakePlanning());
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->layers, 10);
  EXPECT_DOUBLE_EQ(found->first_layer_area_mm2, 300);
  EXPECT_NEAR(found->estimate.filament.volume_mm3, 600, 1e-6);
}

TEST(LookAt, CompleteObjectsNeedAnOrderAndCoolEachByItself) {
  JobInput input = Input();
  input.settings.motion.cooling.slowdown_below_layer_time_s = 1'000;
  const auto together = LookAt({}, input, FakeSlicing(10, 3), FakePlanning());
  input.settings.planning.sequence.complete_objects = true;
  const auto apart = LookAt({}, input, FakeSlicing(10, 3), FakePlanning());
  ASSERT_TRUE(apart.ok()) << apart.status();
  EXPECT_EQ(apart->layers, 30);
  EXPECT_DOUBLE_EQ(together->estimate.print_time_s, 10'000);
  EXPECT_DOUBLE_EQ(apart->estimate.print_time_s, 30'000);
  EXPECT_DOUBLE_EQ(apart->estimate.filament.volume_mm3, together->estimate.filament.volume_mm3);
  FakePlanning planning;
  planning.refuses = true;
  EXPECT_TRUE(LookAt({}, Input(), FakeSlicing(10), planning).ok());
  EXPECT_EQ(LookAt({}, input, FakeSlicing(10), planning).status().message(), "no order");
}

TEST(LookAt, NothingToPrintIsAnError) {
  EXPECT_EQ(DetailOf(LookAt({}, Input(), FakeSlicing(0), FakePlanning()).status()).reason,
            Reason::kNothingToPrint);
}

TEST(LookAt, CanBeCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(LookAt(call, Input(), FakeSlicing(1), FakePlanning()).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator::preflight_test
