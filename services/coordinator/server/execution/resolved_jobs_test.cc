#include "services/coordinator/server/execution/resolved_jobs.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator::resolved_jobs_test {
namespace {

std::string SpecOf(int perimeters, int ranges = 0) {
  v1::JobSpec spec;
  v1::Object* object = spec.add_objects();
  object->set_mesh_sha256(std::string(64, 'a'));
  object->set_name("part");
  v1::Setting* setting = spec.add_settings();
  setting->set_key("perimeters");
  setting->set_value(std::to_string(perimeters));
  for (int i = 0; i < ranges; ++i) {
    v1::HeightRange* range = object->add_height_ranges();
    range->set_from_mm(i);
    range->set_to_mm(i + 1);
    v1::Setting* own = range->add_settings();
    own->set_key("fill_angle");
    own->set_value(std::to_string(i));
  }
  return SpecBytes(spec);
}

TEST(ResolvedJobs, TheSameWorkIsResolvedOnce) {
  ResolvedJobs jobs("build");
  const auto first = jobs.Of(SpecOf(2), "");
  ASSERT_TRUE(first.ok()) << first.status();
  for (int i = 0; i < 1'000; ++i) ASSERT_EQ(jobs.Of(SpecOf(2), "")->get(), first->get());
  EXPECT_EQ(jobs.resolved(), 1);
  EXPECT_NE((*jobs.Of(SpecOf(3), ""))->action_digest, (*first)->action_digest);
  EXPECT_NE((*jobs.Of(SpecOf(2), "acme"))->action_digest, (*first)->action_digest)
      << "another tenant's work is another";
  EXPECT_EQ(jobs.resolved(), 3);
}

TEST(ResolvedJobs, AreBounded) {
  ResolvedJobs jobs("build");
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(jobs.Of(SpecOf(i), "").ok());
  ASSERT_TRUE(jobs.Of(SpecOf(99), "").ok());
  EXPECT_EQ(jobs.resolved(), 100);
  ASSERT_TRUE(jobs.Of(SpecOf(0), "").ok()) << "forgotten";
  EXPECT_EQ(jobs.resolved(), 101);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(jobs.Of(SpecOf(1, /*ranges=*/90), "").ok());
  EXPECT_EQ(jobs.resolved(), 103) << "a large table is not kept";
}

TEST(ResolvedJobs, ErrorsAreTold) {
  ResolvedJobs jobs("build");
  EXPECT_FALSE(jobs.Of("no spec", "").ok());
  EXPECT_TRUE(absl::IsCancelled(
      jobs.Of(SpecOf(1, /*ranges=*/9), "", CancelToken([] { return true; })).status()));
  EXPECT_EQ(jobs.resolved(), 0);
}

}  // namespace
}  // namespace slicefarm::coordinator::resolved_jobs_test
