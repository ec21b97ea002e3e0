#include "services/milling/algo/prepared_jobs.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>
#include <vector>

#include "services/milling/algo/sample_inputs_test.h"

namespace slicefarm::milling::prepared_jobs_test {
namespace {

MillInput Input(double stepdown = 1) {
  MillingOptions how = OptionsFor("cyl:1");
  how.stepdown_mm = stepdown;
  return InputOf(PocketPart().Mesh(), how);
}

TEST(PreparedJobs, PreparesOnce) {
  PreparedJobs jobs(1 << 30);
  const auto first = jobs.Get(Input(), {});
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(*jobs.Get(Input(), {}), *first);
  EXPECT_NE(*jobs.Get(Input(0.5), {}), *first) << "other options";
  MillInput other = Input();
  other.part.vertices[0].z -= 0;
  other.settings.output_step = 3;  // is not of the job
  EXPECT_EQ(*jobs.Get(other, {}), *first);
  EXPECT_EQ((*first)->steps, JobOf(PocketPart().Mesh(), OptionsFor("cyl:1")).steps);
}

TEST(PreparedJobs, KeepsWhatFits) {
  PreparedJobs probe(1 << 30);
  ASSERT_TRUE(probe.Get(Input(), {}).ok());
  PreparedJobs jobs(2 * probe.bytes() + probe.bytes() / 2);
  const auto a = *jobs.Get(Input(), {}), b = *jobs.Get(Input(0.9), {});
  EXPECT_EQ(*jobs.Get(Input(), {}), a);
  ASSERT_TRUE(jobs.Get(Input(0.8), {}).ok());  // b goes
  EXPECT_EQ(*jobs.Get(Input(), {}), a);
  EXPECT_NE(*jobs.Get(Input(0.9), {}), b);
  PreparedJobs none(0);
  ASSERT_TRUE(none.Get(Input(), {}).ok());
  EXPECT_GT(none.bytes(), 0) << "the last one stays";
}

TEST(PreparedJobs, DoesNotKeepErrors) {
  PreparedJobs jobs(1 << 30);
  MillInput wide = InputOf(PocketPart().Mesh(), OptionsFor("cyl:40"));
  EXPECT_EQ(DetailOf(jobs.Get(wide, {}).status()).metadata.at("setting"), "cutter");
  EXPECT_FALSE(jobs.Get(wide, {}).ok());
  const auto cancelled = jobs.Get(Input(), CancelToken([] { return true; }));
  EXPECT_TRUE(absl::IsCancelled(cancelled.status()));
  EXPECT_EQ(jobs.bytes(), 0);
  EXPECT_TRUE(jobs.Get(Input(), {}).ok());
}

TEST(PreparedJobs, GivesAllThreadsTheSame) {
  PreparedJobs jobs(1 << 30);
  std::vector<std::shared_ptr<const MillingJob>> got(8);
  std::vector<std::thread> threads;
  for (auto& job : got) threads.emplace_back([&] { job = *jobs.Get(Input(), {}); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::set(got.begin(), got.end()).size(), 1u);
}

}  // namespace
}  // namespace slicefarm::milling::prepared_jobs_test
