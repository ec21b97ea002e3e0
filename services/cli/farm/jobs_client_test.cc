#include "services/cli/farm/jobs_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "services/cli/farm/fake_coordinator_test.h"
#include "services/cli/farm/job_outcome.h"

namespace slicefarm::cli::jobs_client_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class JobsClientTest : public testing::Test {
 protected:
  static void Ignore(int64_t) {}

  FakeCoordinator server_;
  JobsClient client_{{.server = server_.address()}};
};

TEST_F(JobsClientTest, UploadsAMesh) {
  const std::string mesh(200'000, 'm');
  int64_t last = 0;
  const auto sha256 = client_.UploadMesh(mesh, [&](int64_t sent) {
    EXPECT_GE(sent, last);
    last = sent;
  });
  ASSERT_TRUE(sha256.ok()) << sha256.status();
  EXPECT_EQ(*sha256, Sha256Hex(mesh));
  EXPECT_EQ(server_.mesh, mesh);
  EXPECT_EQ(last, 200'000);
}

TEST_F(JobsClientTest, SendsNothingThatIsThereAlready) {
  server_.mesh = "the mesh";
  ASSERT_TRUE(client_.UploadMesh("the mesh", Ignore).ok());
  EXPECT_TRUE(server_.upload_offsets.empty());
}

TEST_F(JobsClientTest, GoesOnWhereAnUploadBrokeOff) {
  server_.break_upload_after = 2;
  const std::string mesh(300'000, 'm');
  const auto sha256 = client_.UploadMesh(mesh, Ignore);
  ASSERT_TRUE(sha256.ok()) << sha256.status();
  EXPECT_EQ(server_.mesh, mesh);
  EXPECT_THAT(server_.upload_offsets, ElementsAre(0, 2 * (64 << 10)));
}

TEST_F(JobsClientTest, ResumesAnUploadThatOnlyLacksItsEnd) {
  const std::string mesh(100, 'm');
  server_.mesh = mesh;
  server_.forget_completion = true;
  ASSERT_TRUE(client_.UploadMesh(mesh, Ignore).ok());
  EXPECT_THAT(server_.upload_offsets, ElementsAre(100));
}

TEST_F(JobsClientTest, RefusesAServerThatHasMoreThanTheMesh) {
  server_.mesh = "something else";
  const auto sha256 = client_.UploadMesh("a mesh", Ignore);
  EXPECT_EQ(DetailOf(sha256.status()).reason, Reason::kBlobDigestMismatch);
}

TEST_F(JobsClientTest, GivesEachJobARequestIdOfItsOwn) {
  v1::CreateJobRequest request;
  (*request.mutable_labels())["queue"] = "night";
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(client_.CreateJob(request).ok());
  EXPECT_EQ(server_.request_ids.size(), 20);
  for (const std::string& id : server_.request_ids) {
    EXPECT_THAT(id,
                testing::MatchesRegex("[0-9a-f]+-[0-9a-f]+-4[0-9a-f]+-[89ab][0-9a-f]+-[0-9a-f]+"));
    EXPECT_EQ(id.size(), 36);
  }
}

TEST_F(JobsClientTest, PassesTheServersErrorsOn) {
  const auto job = client_.GetJob("job-2");
  ASSERT_FALSE(job.ok());
  EXPECT_EQ(DetailOf(job.status()).reason, Reason::kJobNotFound);
  EXPECT_THAT(std::string(job.status().message()), HasSubstr("there is no job job-2"));
}

TEST_F(JobsClientTest, TriesAgainWhenTheServerHasNoThreadLeft) {
  const grpc::Status refused(grpc::StatusCode::RESOURCE_EXHAUSTED, "Server Threadpool Exhausted");
  server_.refused_gets = {refused, refused};
  const auto job = client_.GetJob("job-1");
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->id(), "job-1");
}

TEST_F(JobsClientTest, TriesAgainWhenTheServersStoreIsAwayOrAsksForIt) {
  const auto refused = [](absl::StatusCode code, Reason reason, const char* after_ms) {
    return rpc::ToGrpc(MakeError(code, reason, "", {{rpc::kRetryAfterMs, after_ms}}));
  };
  server_.refused_gets = {
      refused(absl::StatusCode::kUnavailable, Reason::kStoreFailed, "1"),
      refused(absl::StatusCode::kResourceExhausted, Reason::kQueueFull, "1"),
      refused(absl::StatusCode::kResourceExhausted, Reason::kDiskLow, "1"),
      rpc::ToGrpc(MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed, ""))};
  EXPECT_TRUE(client_.GetJob("job-1").ok());
}

TEST_F(JobsClientTest, AFullDiskIsNotWaitedFor) {
  server_.refused_gets = {rpc::ToGrpc(
      MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, "no space left"))};
  EXPECT_EQ(DetailOf(client_.GetJob("job-1").status()).reason, Reason::kDiskFull);
}

TEST_F(JobsClientTest, AnUploadForWhichThereIsNoRoomIsNotWaitedForForEver) {
  JobsClient client({.server = server_.address(), .patience = std::chrono::milliseconds(50)});
  server_.upload_refused =
      rpc::ToGrpc(MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskLow, "no room",
                            {{rpc::kRetryAfterMs, "1"}}));
  const auto sha256 = client.UploadMesh(std::string(300'000, 'm'), Ignore);
  EXPECT_EQ(DetailOf(sha256.status()).reason, Reason::kDiskLow) << sha256.status();
}

TEST_F(JobsClientTest, TellsEachEventOnceThoughTheStreamBreaks) {
  server_.break_watch_after = 2;
  std::vector<int> seen;
  const auto job = client_.WatchJob(
      "job-1", [&](const v1::Job& event) { seen.push_back(event.progress().layers_done()); });
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(seen, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(server_.watch_sequences, ElementsAre(0, 2));
}

TEST_F(JobsClientTest, AQuietWatchThatBreaksWasAnAnswer) {
  server_.quiet_watch_ends = {grpc::StatusCode::UNAVAILABLE, grpc::StatusCode::UNAVAILABLE};
  JobsClient client({.server = server_.address(), .patience = std::chrono::milliseconds(0)});
  const auto job = client.WatchJob("job-1", [](const v1::Job&) {});
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(server_.watches, 3);
}

TEST_F(JobsClientTest, AQuietWatchThatReachesItsDeadlineIsTakenUpAgain) {
  server_.quiet_watch_ends = {grpc::StatusCode::DEADLINE_EXCEEDED,
                              grpc::StatusCode::DEADLINE_EXCEEDED};
  JobsClient client({.server = server_.address(), .patience = std::chrono::milliseconds(0)});
  const auto job = client.WatchJob("job-1", [](const v1::Job&) {});
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(server_.watches, 3);
}

TEST_F(JobsClientTest, GoesOnWhereADownloadBrokeOff) {
  server_.break_download_after = 3;
  const std::string path = testing::TempDir() + "/jobs_client_download";
  auto file = OutputFile::Create(path);
  ASSERT_TRUE(file.ok());
  v1::Job job;
  job.set_id("job-1");
  job.mutable_result()->set_gcode_sha256(Sha256Hex(server_.result));
  const absl::Status downloaded = client_.Download(job, v1::ARTIFACT_GCODE, *file);
  ASSERT_TRUE(downloaded.ok()) << downloaded;
  ASSERT_TRUE(file->Commit().ok());
  EXPECT_EQ(*ReadFile(path, 1 << 20), server_.result);
  EXPECT_THAT(server_.download_offsets, ElementsAre(0, 3 * (64 << 10)));
}

TEST_F(JobsClientTest, ADownloadThatIsNotWhatTheResultSaysIsAnError) {
  v1::Job job;
  job.set_id("job-1");
  job.mutable_result()->set_report_sha256(Sha256Hex(server_.result));
  server_.result.pop_back();
  const std::string path = testing::TempDir() + "/jobs_client_cut_download";
  auto file = OutputFile::Create(path);
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(DetailOf(client_.Download(job, v1::ARTIFACT_REPORT, *file)).reason,
            Reason::kBlobDigestMismatch);
}

TEST_F(JobsClientTest, EndsWhenNobodyWantsTheAnswerAnyMore) {
  server_.hold_watches = true;
  std::atomic<bool> cancelled = false;
  JobsClient client(
      {.server = server_.address(), .cancel = CancelToken([&] { return cancelled.load(); })});
  std::thread later([&] { cancelled = true; });
  const auto job = client.WatchJob("job-1", [](const v1::Job&) {});
  later.join();
  EXPECT_EQ(DetailOf(job.status()).reason, Reason::kCancelled);
}

TEST(JobsClient, NamesTheServerThatIsOutOfReach) {
  std::string address;
  {
    const FakeCoordinator gone;
    address = gone.address();
  }
  JobsClient client({.server = address, .patience = std::chrono::milliseconds(50)});
  const auto job = client.GetJob("job-1");
  ASSERT_FALSE(job.ok());
  EXPECT_EQ(DetailOf(job.status()).reason, Reason::kUnavailable);
  EXPECT_THAT(std::string(job.status().message()), HasSubstr(address));
}

TEST(OutcomeOf, TellsHowAJobEnded) {
  v1::Job job;
  job.set_id("j");
  job.set_state(v1::JOB_STATE_RUNNING);
  EXPECT_FALSE(HasEnded(job));
  EXPECT_EQ(DetailOf(OutcomeOf(job)).reason, Reason::kJobNotFinished);
  job.set_state(v1::JOB_STATE_CANCELLED);
  EXPECT_TRUE(HasEnded(job));
  EXPECT_EQ(DetailOf(OutcomeOf(job)).reason, Reason::kCancelled);
  job.set_state(v1::JOB_STATE_FAILED);
  job.mutable_error()->set_code(3);
  job.mutable_error()->set_reason("MESH_TRUNCATED");
  job.mutable_error()->set_message("cut off");
  (*job.mutable_error()->mutable_metadata())["got"] = "84";
  EXPECT_EQ(DetailOf(OutcomeOf(job)).reason, Reason::kMeshTruncated);
  EXPECT_EQ(DetailOf(OutcomeOf(job)).metadata.at("got"), "84");
  EXPECT_EQ(OutcomeOf(job).message(), "cut off");
  job.mutable_error()->set_code(0);
  job.mutable_error()->set_reason("OF_A_LATER_VERSION");
  EXPECT_FALSE(OutcomeOf(job).ok());
  job.set_state(v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(OutcomeOf(job).ok());
}

}  // namespace
}  // namespace slicefarm::cli::jobs_client_test
