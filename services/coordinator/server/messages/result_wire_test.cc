#include "services/coordinator/server/messages/result_wire.h"

#include <gtest/gtest.h>

#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator::result_wire_test {
namespace {

/// Returns a result of two objects with three copies.
JobResult ResultWithShares() {
  JobResult result;
  result.print_time_s = 4000.1;
  result.filament_mm = 3000.2;
  result.filament_mm3 = 7000.3;
  result.filament_g = 8.7;
  result.cost = {"EUR", 1.5, 2.222, 0.1, 0.2175};
  const PrintShare total = {4000.1, {3000.2, 7000.3, 8.7, 0}};
  result.shares = DividePrint(
      {{{"a", 0, 0, 2}, {"a", 0, 1, 2}, {"b", 1, 0, 1}}},
      {{1000, {800, 1900, 2.3, 0}}, {1001, {800, 1900, 2.3, 0}}, {1500, {1200, 2800, 3.5, 0}}},
      total);
  return result;
}

TEST(ResultWire, SharesAddUpToTheJob) {
  const JobResult result = ResultWithShares();
  v1::JobResult proto = ToProto(result);
  AddShares(result, proto);
  ASSERT_EQ(proto.objects_size(), 2);
  ASSERT_EQ(proto.objects(0).copies_size(), 2);
  EXPECT_EQ(proto.objects(1).name(), "b");
  double time = proto.shared().time_s(), mm = proto.shared().filament_mm();
  double mm3 = proto.shared().filament_mm3(), g = proto.shared().filament_g();
  double cost = proto.shared().cost().total();
  for (const v1::ObjectShare& object : proto.objects()) {
    double of_copies = 0;
    for (const v1::PrintShare& copy : object.copies()) of_copies += copy.cost().total();
    EXPECT_EQ(of_copies, object.total().cost().total());
    time += object.total().time_s();
    mm += object.total().filament_mm();
    mm3 += object.total().filament_mm3();
    g += object.total().filament_g();
    cost += object.total().cost().total();
    EXPECT_EQ(object.total().cost().currency(), "EUR");
  }
  EXPECT_EQ(time, proto.print_time_s());
  EXPECT_EQ(mm, proto.filament_mm());
  EXPECT_EQ(mm3, proto.filament_mm3());
  EXPECT_EQ(g, proto.filament_g());
  EXPECT_EQ(cost, proto.cost().total());
  EXPECT_EQ(proto.shared().cost().setup(), 1.5);
}

TEST(ResultWire, OnlyTheWholeJobHasShares) {
  JobRecord job;
  job.state = JobState::kSucceeded;
  job.result = ResultWithShares();
  EXPECT_EQ(ToProto(job).result().objects_size(), 2);
  EXPECT_EQ(
      ToProto(JobEventRecord{1, 1, JobState::kSucceeded, 1, 1}, job).job().result().objects_size(),
      0);
  const v1::ListJobsResponse list = ToProto({job}, ListQuery{});
  ASSERT_EQ(list.jobs_size(), 1);
  EXPECT_EQ(list.jobs(0).result().objects_size(), 0);
  EXPECT_FALSE(list.jobs(0).result().has_shared());
  EXPECT_GT(list.jobs(0).result().print_time_s(), 0);
}

TEST(ResultWire, OldResultsHaveNoShares) {
  v1::JobResult proto;
  AddShares({}, proto);
  EXPECT_FALSE(proto.has_shared());
}

}  // namespace
}  // namespace slicefarm::coordinator::result_wire_test
