// Tests of calls for integrators: changes of jobs, stored meshes, projects, facts about the farm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/coordinator/server/main/coordinator_fixture_test.h"

namespace slicefarm::coordinator::integrator_calls_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class IntegratorCallsTest : public CoordinatorTest {
 protected:
  template <typename Stub, typename Method, typename Request>
  auto Call(Stub& stub, Method method, const Request& request) {
    return CallOf(stub, method, request);
  }
  template <typename Stub, typename Request, typename Response>
  absl::StatusOr<Response> CallOf(Stub& stub,
                                  grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                               Response*),
                                  const Request& request) {
    grpc::ClientContext context;
    Bound(context);
    Response response;
    const absl::Status status = rpc::FromGrpc((stub.*method)(&context, request, &response));
    if (!status.ok()) return status;
    return response;
  }

  absl::StatusOr<v1::Job> Update(const v1::UpdateJobRequest& request) {
    return Call(*jobs_, &v1::Jobs::Stub::UpdateJob, request);
  }

  /// Downloads `limit` bytes of a mesh from the offset on; 0 means all.
  absl::StatusOr<std::string> DownloadMesh(const std::string& mesh, int64_t offset, int64_t limit) {
    v1::DownloadMeshRequest request;
    request.set_sha256(Sha256Hex(mesh));
    request.set_offset(offset);
    request.set_limit(limit);
    grpc::ClientContext context;
    Bound(context);
    const auto stream = meshes_->DownloadMesh(&context, request);
    std::string bytes;
    for (v1::DownloadResponse part; stream->Read(&part);) bytes += part.data();
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    if (!status.ok()) return status;
    return bytes;
  }

  std::vector<std::string> Meshes(int32_t page_size) {
    std::vector<std::string> digests;
    v1::ListMeshesRequest request;
    request.set_page_size(page_size);
    do {
      const auto page = Call(*meshes_, &v1::Meshes::Stub::ListMeshes, request);
      EXPECT_TRUE(page.ok()) << page.status();
      if (!page.ok()) return digests;
      for (const auto& mesh : page->meshes()) digests.push_back(mesh.sha256());
      request.set_page_token(page->next_page_token());
    } while (!request.page_token().empty());
    return digests;
  }

  absl::StatusOr<bool> DeleteMesh(const std::string& mesh) {
    v1::DeleteMeshRequest request;
    request.set_sha256(Sha256Hex(mesh));
    const auto done = Call(*meshes_, &v1::Meshes::Stub::DeleteMesh, request);
    if (!done.ok()) return done.status();
    return done->deleted();
  }

  absl::StatusOr<v1::ReadProjectResponse> ReadProject(const std::string& file, int32_t plate) {
    EXPECT_TRUE(Upload(file).ok());
    v1::ReadProjectRequest request;
    request.set_sha256(Sha256Hex(file));
    request.set_plate(plate);
    return Call(*meshes_, &v1::Meshes::Stub::ReadProject, request);
  }
};

TEST_F(IntegratorCallsTest, WhatTheMaskNamesIsChanged) {
  ranges_->Hold();
  const std::string runs = Submit("x"), runs_too = Submit("xx");
  ranges_->AwaitCall();
  const std::string waits = Submit("xxx");
  v1::UpdateJobRequest request;
  request.set_id(waits);
  request.set_priority(v1::JOB_PRIORITY_INTERACTIVE);
  (*request.mutable_labels())["order"] = "17";
  request.mutable_update_mask()->add_paths("labels");
  auto job = Update(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->labels().at("order"), "17");
  EXPECT_EQ(job->priority(), v1::JOB_PRIORITY_NORMAL) << "the mask does not name it";
  EXPECT_EQ(job->spec().objects_size(), 1);
  v1::ListJobsRequest of_order;
  (*of_order.mutable_labels())["order"] = "17";
  EXPECT_THAT(List(of_order), ElementsAre(waits));
  request.mutable_update_mask()->add_paths("priority");
  request.mutable_labels()->clear();
  job = Update(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->priority(), v1::JOB_PRIORITY_INTERACTIVE);
  EXPECT_THAT(List(of_order), IsEmpty());
  request.mutable_update_mask()->add_paths("spec");
  EXPECT_EQ(DetailOf(Update(request).status()).reason, Reason::kRequestMalformed);
  request.mutable_update_mask()->clear_paths();
  EXPECT_EQ(DetailOf(Update(request).status()).reason, Reason::kRequestMalformed);
}

TEST_F(IntegratorCallsTest, AllJobsOfATenantAreWatched) {
  v1::WatchJobsRequest request;
  request.mutable_from()->set_seconds(1);
  grpc::ClientContext context;
  Bound(context);
  const auto stream = jobs_->WatchJobs(&context, request);
  stream->WaitForInitialMetadata();
  const std::string first = Submit("x"), second = Submit("xx");
  std::map<std::string, std::vector<int64_t>> reported;
  std::set<std::string> ended;
  std::string cursor;
  v1::WatchJobsResponse response;
  while (ended.size() < 2 && stream->Read(&response)) {
    const v1::JobEvent& event = response.event();
    reported[event.job().id()].push_back(event.sequence());
    if (event.job().state() == v1::JOB_STATE_SUCCEEDED) ended.insert(event.job().id());
    cursor = response.cursor();
  }
  EXPECT_THAT(reported[first], ElementsAre(1, 2, 3));
  EXPECT_THAT(reported[second], ElementsAre(1, 2, 3));
  context.TryCancel();
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);

  request.Clear();
  request.set_cursor(cursor);
  grpc::ClientContext again;
  Bound(again);
  const auto resumed = jobs_->WatchJobs(&again, request);
  ASSERT_TRUE(resumed->Read(&response));
  EXPECT_TRUE(reported.contains(response.event().job().id())) << "what is young comes once more";
  again.TryCancel();
}

TEST_F(IntegratorCallsTest, ACursorIsOneOfAnAnswer) {
  v1::WatchJobsRequest request;
  request.set_cursor("yesterday");
  grpc::ClientContext context;
  Bound(context);
  const auto stream = jobs_->WatchJobs(&context, request);
  v1::WatchJobsResponse response;
  EXPECT_FALSE(stream->Read(&response));
  EXPECT_EQ(DetailOf(rpc::FromGrpc(stream->Finish())).reason, Reason::kRequestMalformed);
}

// The coordinator of the job learns the deadline when it renews the lease.
TEST_F(IntegratorCallsTest, ARunningJobEndsAtADeadlineThatItGetsLater) {
  ranges_->Hold();
  const std::string id = Submit("xx");
  ranges_->AwaitCall();
  v1::UpdateJobRequest request;
  request.set_id(id);
  request.mutable_deadline()->set_seconds(1'000);  // long ago
  request.mutable_update_mask()->add_paths("deadline");
  ASSERT_TRUE(Update(request).ok());
  const v1::Job job = AwaitEnd(id);
  EXPECT_EQ(job.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job.error().reason(), "DEADLINE_EXCEEDED");
}

TEST_F(IntegratorCallsTest, ABatchCancelsEachByItself) {
  ranges_->Hold();
  const std::string a = Submit("x");
  ranges_->AwaitCall();
  const std::string b = Submit("xx");
  v1::BatchCancelJobsRequest request;
  for (const std::string& id : {a, std::string("none"), b}) request.add_ids(id);
  const auto batch = Call(*jobs_, &v1::Jobs::Stub::BatchCancelJobs, request);
  ASSERT_TRUE(batch.ok()) << batch.status();
  ASSERT_EQ(batch->outcomes_size(), 3);
  EXPECT_TRUE(batch->outcomes(0).job().cancel_requested() ||
              batch->outcomes(0).job().state() == v1::JOB_STATE_CANCELLED);
  EXPECT_EQ(batch->outcomes(1).error().reason(), "JOB_NOT_FOUND");
  for (const std::string& id : {a, b}) EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_CANCELLED);
}

TEST_F(IntegratorCallsTest, PartsOfMeshesAndResultsAreSent) {
  const std::string mesh(200'000, 'x');
  ASSERT_TRUE(Upload(mesh).ok());
  EXPECT_EQ(*DownloadMesh(mesh, 0, 0), mesh);
  EXPECT_EQ(*DownloadMesh(mesh, 199'990, 0), mesh.substr(199'990));
  EXPECT_EQ(*DownloadMesh(mesh, 65'530, 70'000), mesh.substr(65'530, 70'000));
  EXPECT_EQ(*DownloadMesh(mesh, 199'990, 70'000), mesh.substr(199'990));
  EXPECT_EQ(*DownloadMesh(mesh, 200'000, 0), "");
  EXPECT_EQ(DetailOf(DownloadMesh(mesh, 200'001, 0).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(DownloadMesh(mesh, 0, -1).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(DownloadMesh("another", 0, 0).status()).reason, Reason::kBlobNotFound);
}

TEST_F(IntegratorCallsTest, MeshesAreListedAndResultsAreNot) {
  EXPECT_EQ(AwaitEnd(Submit("xx")).state(), v1::JOB_STATE_SUCCEEDED);
  ASSERT_TRUE(Upload("another").ok());
  ASSERT_TRUE(Upload("an upload", 0, 3).ok());
  std::vector<std::string> want = {Sha256Hex("xx"), Sha256Hex("another"), Sha256Hex("an upload")};
  std::ranges::sort(want);
  for (const int32_t size : {1, 2, 100}) EXPECT_EQ(Meshes(size), want) << size;
}

TEST_F(IntegratorCallsTest, AMeshOfAJobStays) {
  const std::string id = Submit("xx");
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_FALSE(*DeleteMesh("xx"));
  EXPECT_FALSE(*DeleteMesh("none"));
  EXPECT_THAT(Meshes(100), ElementsAre(Sha256Hex("xx")));
}

TEST_F(IntegratorCallsTest, OfAProjectThePlateThatIsWantedHasItsSpec) {
  const auto second = ReadProject("ppp", 2);
  ASSERT_TRUE(second.ok()) << second.status();
  ASSERT_EQ(second->plates_size(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(second->plates(i).has_spec(), i == 1);
  EXPECT_TRUE(ReadProject("p", 0)->plates(0).has_spec());
  EXPECT_FALSE(ReadProject("pp", 0)->plates(0).has_spec());
  EXPECT_EQ(DetailOf(ReadProject("pp", 3).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(ReadProject("p!", 0).status()).reason, Reason::kMeshMalformed);
}

TEST_F(IntegratorCallsTest, TheFarmSaysWhatItKnows) {
  const auto caller = Call(*jobs_, &v1::Jobs::Stub::GetCaller, v1::GetCallerRequest());
  ASSERT_TRUE(caller.ok()) << caller.status();
  EXPECT_EQ(caller->max_kept_jobs(), 0);
  EXPECT_GT(caller->max_open_jobs(), 0);
  EXPECT_EQ(AwaitEnd(Submit("xx")).state(), v1::JOB_STATE_SUCCEEDED);
  const auto usage = Call(*jobs_, &v1::Jobs::Stub::GetUsage, v1::GetUsageRequest());
  ASSERT_TRUE(usage.ok()) << usage.status();
  EXPECT_EQ(usage->kept_jobs(), 1);
  EXPECT_EQ(usage->queued_jobs() + usage->running_jobs(), 0);
  EXPECT_GT(usage->kept_bytes(), 2);
  const auto settings = Call(*jobs_, &v1::Jobs::Stub::ListSettings, v1::ListSettingsRequest());
  ASSERT_TRUE(settings.ok()) << settings.status();
  const auto info = [&](std::string_view key) {
    for (const auto& each : settings->settings())
      if (each.key() == key) return each;
    return v1::ListSettingsResponse::Info();
  };
  EXPECT_EQ(info("layer_height").kind(), "number");
  EXPECT_EQ(info("layer_height").scope(), "object");
  EXPECT_EQ(info("layer_height").max(), 5);
  EXPECT_EQ(info("fill_density").scope(), "region");
  EXPECT_EQ(info("fill_density").group(), "infill");
  EXPECT_FALSE(info("layer_gcode").has_min());
  EXPECT_EQ(info("seam_position").choices_size(), 5);
}

TEST_F(IntegratorCallsTest, AJobTellsOfItsAttempts) {
  const std::string id = Submit("xx");
  EXPECT_EQ(AwaitEnd(id).attempts(), 1);
  const v1::Job cached = AwaitEnd(Submit("xx"));
  EXPECT_TRUE(cached.result().cached());
  EXPECT_EQ(cached.attempts(), 0) << "no run began";
}

}  // namespace
}  // namespace slicefarm::coordinator::integrator_calls_test
