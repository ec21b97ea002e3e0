// Tests of the number of statements that a job, and a sweep, send to a shared PostgreSQL database.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <set>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/base/from_environment_test.h"
#include "common/base/sha256.h"
#include "processes/list/jobs.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/run/blob_sweep.h"
#include "services/coordinator/server/api/job_intake.h"
#include "services/coordinator/server/execution/fake_stages_test.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/counting_database_test.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::job_statements_test {
namespace {

class JobStatementsTest : public testing::Test {
 protected:
  JobStatementsTest() { dispatcher_.Join({.name = "fake", .tasks = ranges_, .slots = 2}); }

  std::string Submit(const std::string& mesh) {
    v1::JobSpec spec;
    spec.set_generic(true);
    v1::Object* object = spec.add_objects();
    object->set_mesh_sha256(Sha256Hex(mesh));
    object->set_name("part");
    JobIntake intake(jobs_, *blobs_, DiskGuard(nullptr, 0), budgets_, full_queues_, resolved_,
                     "build", ResultSharing::kOff, clock_);
    Submission submission;
    submission.max_open_jobs = 10'000;
    submission.request_id = "request of " + mesh;
    submission.spec_digest = Sha256Hex(SpecBytes(spec));
    submission.spec = SpecBytes(spec);
    submission.request = *FromProto(spec);
    const auto created = intake.Create(std::move(submission));
    EXPECT_TRUE(created.ok()) << created.status();
    return created->job.id;
  }

  std::shared_ptr<PostgresDatabase> database_ =
      *PostgresDatabase::Open(SharedPostgres().NewDatabase());
  std::shared_ptr<CountingDatabase> counting_ = std::make_shared<CountingDatabase>(database_);
  SqlJobStore jobs_{counting_};
  std::unique_ptr<BlobStores> blobs_ = MakePostgresBlobs(counting_);
  FakeSlicing slicing_;
  FakePlanning planning_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  JobPipeline pipeline_{
      JobsOver({.slicing = &slicing_, .planning = &planning_, .motion = &motion_}, ""),
      dispatcher_};
  MemoryBudget memory_{1 << 30};
  ResolvedJobs resolved_{"build"};
  JobResults results_{jobs_, *blobs_, {}};
  JobFeed feed_;
  std::function<int64_t()> clock_ = [] { return int64_t{1'000'000'000}; };
  TenantBudgets budgets_{jobs_, *blobs_, clock_};
  FullQueues full_queues_{clock_};
};

TEST_F(JobStatementsTest, ASmallJobIsAtMostThirty) {
  ASSERT_TRUE((*blobs_->Of(""))->Put("xxx").ok());
  counting_->Statements();
  const std::string id = Submit("xxx");
  std::vector<std::string> statements = counting_->Statements();
  std::promise<void> ended;
  const int64_t ticket = feed_.Listen(id, [&, times = 0](JobFeed::News news) mutable {
    if (news == JobFeed::News::kEvents && ++times == 2) ended.set_value();  // after RUNNING
  });
  JobRunnerOptions options;
  options.owner = "me";
  options.jobs = 1;
  options.guests = 0;
  options.poll = options.renew = std::chrono::hours(1);
  {
    JobRunner runner(RunEnvironment{jobs_, *blobs_, resolved_, results_, pipeline_, memory_, feed_,
                                    clock_, "build", ResultSharing::kOff, rpc::JsonLog("test")},
                     options);
    // The statements of the start, and searches for work without a result, do not belong to the
    // job.
    ASSERT_TRUE(runner.Start().ok());
    ended.get_future().wait();
    runner.Drain(std::chrono::minutes(1));
  }
  feed_.Forget(ticket);
  const auto job = SqlJobStore(database_).Get(id);
  ASSERT_EQ(job->state, JobState::kSucceeded) << (job->error ? job->error->message : "");
  const std::vector<std::string> of_run = counting_->Statements();
  // The job's statements begin with the search that found it. Only one search for work succeeded;
  // the repeated search statements of other threads found nothing.
  std::set<std::string> looks;
  int renewals = 0;
  for (const std::string& statement : of_run) {
    if (statement.starts_with("UPDATE jobs SET owner_until_us = CASE")) {
      ++renewals;
      continue;
    }
    const bool looks_for_work = statement.starts_with("WITH RECURSIVE open_tenants") ||
                                statement.starts_with("SELECT number, action_digest FROM jobs");
    const bool in_vain = looks_for_work && !looks.insert(statement).second;
    const bool of_life = statement.find("SET owner = ''") != std::string::npos ||
                         statement.starts_with("SELECT id FROM jobs");
    if (!of_life && !in_vain) statements.push_back(statement);
  }
  // A renewal of the lease is a transaction of its own. The end of the runner may cause one, and
  // statements of other threads may be between its BEGIN and its COMMIT.
  for (const std::string_view bound : {"BEGIN", "COMMIT"})
    for (int i = 0; i < renewals; ++i)
      if (const auto found = std::ranges::find(statements, bound); found != statements.end())
        statements.erase(found);
  RecordProperty("statements", static_cast<int>(statements.size()));
  EXPECT_LE(statements.size(), 30u) << absl::StrJoin(statements, "\n");
}

TEST_F(JobStatementsTest, ASweepOfManyBlobsWithNothingToDoIsFew) {
  // Rows per statement, because the time of a statement is limited.
  constexpr int64_t kAtOnce = 50'000;
  const int64_t blobs = FromEnvironment("SLICEFARM_SWEEP_BLOBS", 100'000);
  for (int64_t first = 0; first < blobs; first += kAtOnce) {
    const std::string names = absl::StrCat(
        " FROM (SELECT encode(sha256(i::TEXT::BYTEA), 'hex') AS name FROM generate_series(", first,
        ", ", std::min(blobs, first + kAtOnce) - 1, ") AS i) AS names");
    const auto session = *database_->Write();
    ASSERT_TRUE(session
                    ->Execute("INSERT INTO blobs (tenant, digest, size, complete, touched)"
                              " SELECT '', name, 5, 1, now() - interval '2 days'" +
                              names)
                    .ok());
    ASSERT_TRUE(session
                    ->Execute("INSERT INTO jobs (id, tenant, state, priority, deadline_us, spec,"
                              " labels, settings_digest, action_digest, build_id, traceparent,"
                              " create_us, end_us, gcode_sha256) SELECT 'j' || name, '',"
                              " 'SUCCEEDED', 1, 1, '', '{}', '', name, '', '', 1, 1, name" +
                              names)
                    .ok());
  }
  ASSERT_TRUE((*database_->Write())->Execute("ANALYZE").ok());
  counting_->Statements();
  const auto swept = Sweep(jobs_, *blobs_, {}, clock_());
  ASSERT_TRUE(swept.ok()) << swept.status();
  EXPECT_EQ(swept->blobs, 0);
  const std::vector<std::string> statements = counting_->Statements();
  RecordProperty("statements", static_cast<int>(statements.size()));
  // A million blobs may take a hundred statements.
  EXPECT_LE(std::ssize(statements), 4 + blobs * 96 / 1'000'000) << absl::StrJoin(statements, "\n");
}

}  // namespace
}  // namespace slicefarm::coordinator::job_statements_test
