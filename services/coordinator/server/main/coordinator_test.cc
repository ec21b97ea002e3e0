// Tests of the coordinator with a real server, real stores and fake stages.
#include "services/coordinator/server/main/coordinator.h"

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/rpc/client/client_call.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/main/coordinator_fixture_test.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator::coordinator_test {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::SizeIs;

TEST_F(CoordinatorTest, AMeshGoesInAndGcodeComesOut) {
  const std::string id = Submit("xxx");
  const v1::Job job = AwaitEnd(id);
  ASSERT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error().message();
  EXPECT_EQ(job.result().layers(), 3);
  EXPECT_EQ(job.spec().objects(0).name(), "part.stl");
  EXPECT_EQ(job.build_id(), "test-build");
  EXPECT_GT(job.end_time().seconds(), 0);
  const auto gcode = Download(id, v1::ARTIFACT_GCODE);
  ASSERT_TRUE(gcode.ok()) << gcode.status();
  EXPECT_EQ(*gcode, "; part.stl\nG1 X0\nG1 X1\nG1 X2\n; end\n");
  EXPECT_EQ(job.result().gcode_sha256(), Sha256Hex(*gcode));
  const auto report = Download(id, v1::ARTIFACT_REPORT);
  EXPECT_EQ(nlohmann::json::parse(*report)["layers"], 3);
}

TEST_F(CoordinatorTest, UploadsGoOnWhereTheyEnded) {
  const std::string mesh(300'000, 'x');
  const std::string digest = Sha256Hex(mesh);
  ASSERT_TRUE(Upload(mesh, 0, 131'072).ok());
  EXPECT_EQ(GetUpload(digest).committed_size(), 131'072);
  EXPECT_FALSE(GetUpload(digest).complete());
  EXPECT_EQ(DetailOf(Create(RequestFor(mesh)).status()).reason, Reason::kBlobNotFound);
  const absl::Status hole = Upload(mesh, 200'000).status();
  EXPECT_EQ(DetailOf(hole).reason, Reason::kUploadOffset);
  EXPECT_EQ(DetailOf(hole).metadata.at("committed_size"), "131072");
  ASSERT_TRUE(Upload(mesh, 131'072).ok());
  EXPECT_TRUE(GetUpload(digest).complete());
  EXPECT_TRUE(Upload(mesh).ok()) << "what is there is not needed again";
}

TEST_F(CoordinatorTest, UploadsAreChecked) {
  EXPECT_EQ(DetailOf(Upload("xxx", 0, -1, Sha256Hex("other")).status()).reason,
            Reason::kBlobDigestMismatch);
  EXPECT_EQ(DetailOf(Upload("xxx", 0, -1, "../../passwd").status()).reason,
            Reason::kRequestMalformed);
}

// A client that learns that a mesh exists may create a job with it. Until then no sweep may remove
// the mesh.
TEST_F(CoordinatorTest, AMeshThatIsAskedForOrSentAgainCountsAsUsed) {
  namespace fs = std::filesystem;
  ASSERT_TRUE(Upload("mesh").ok());
  const std::string path = BlobPath(Sha256Hex("mesh"));
  const auto now = fs::last_write_time(path);
  const auto old = now - std::chrono::hours(30);
  fs::last_write_time(path, old);
  EXPECT_TRUE(GetUpload(Sha256Hex("mesh")).complete());
  EXPECT_GE(fs::last_write_time(path), now);
  fs::last_write_time(path, old);
  ASSERT_TRUE(Upload("mesh").ok());
  EXPECT_GE(fs::last_write_time(path), now);
}

TEST_F(CoordinatorTest, AnUploadOnWhichNothingMovesIsCutOff) {
  Close();
  transfers_.times.idle = std::chrono::milliseconds(20);
  Open();
  grpc::ClientContext context;
  Bound(context);
  v1::Upload upload;
  const auto stream = meshes_->UploadMesh(&context, &upload);
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
}

// An upload of one byte per minute is cut off, so that it occupies no slot.
TEST_F(CoordinatorTest, AnUploadThatBringsNextToNothingIsCutOff) {
  Close();
  transfers_.times.idle = std::chrono::milliseconds(200);
  transfers_.times.min_bytes_per_s = 1 << 30;
  Open();
  grpc::ClientContext context;
  Bound(context);
  v1::Upload upload;
  const auto stream = meshes_->UploadMesh(&context, &upload);
  v1::UploadMeshRequest request;
  request.set_sha256(Sha256Hex("much"));
  request.set_size(1 << 30);
  request.set_data("m");
  while (stream->Write(request)) request.set_sha256("");
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
}

TEST_F(CoordinatorTest, AStreamWithoutADeadlineGetsOne) {
  Close();
  transfers_.times.default_deadline = std::chrono::milliseconds(20);
  Open();
  grpc::ClientContext context;  // without a deadline, unlike the farm's own clients
  v1::Upload upload;
  const auto stream = meshes_->UploadMesh(&context, &upload);
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
  grpc::ClientContext with_deadline;
  Bound(with_deadline);
  const auto other = meshes_->UploadMesh(&with_deadline, &upload);
  other->WritesDone();
  EXPECT_EQ(DetailOf(rpc::FromGrpc(other->Finish())).reason, Reason::kRequestMalformed);
}

TEST_F(CoordinatorTest, ADownloadThatNobodyReadsIsCutOff) {
  const std::string id = Submit(std::string(20'000, 'x'));
  ASSERT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  Close();
  transfers_.times.idle = std::chrono::milliseconds(200);
  Open();
  grpc::ClientContext context;
  Bound(context);
  v1::DownloadRequest request;
  request.set_id(id);
  request.set_artifact(v1::ARTIFACT_GCODE);
  const double before = Handled("Download");
  // Without a small window, all bytes would be in flight before the client reads any.
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 1 << 14);
  arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  const auto jobs = v1::Jobs::NewStub(
      grpc::CreateCustomChannel(address(), grpc::InsecureChannelCredentials(), arguments));
  const auto stream = jobs->Download(&context, request);
  while (Handled("Download") == before) std::this_thread::yield();
  v1::DownloadResponse response;
  while (stream->Read(&response)) {
  }
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
}

TEST_F(CoordinatorTest, UploadsBeyondTheCapAreRefusedAndTheRestGoesOn) {
  const std::string id = Submit("x");
  Close();
  transfers_.slots = 2;
  Open();
  std::vector<std::unique_ptr<OpenUpload>> open;
  for (const char* mesh : {"one", "two"}) open.push_back(BeginUpload(mesh));
  for (int i = 0; i < 80; ++i) {  // more than the server has threads
    grpc::ClientContext context;
    Bound(context);
    v1::Upload upload;
    const auto stream = meshes_->UploadMesh(&context, &upload);
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    ASSERT_EQ(DetailOf(status).reason, Reason::kOverloaded) << status;
    EXPECT_EQ(DetailOf(status).metadata.count(rpc::kRetryAfterMs), 1u);
  }
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(Download(id, v1::ARTIFACT_GCODE).ok()) << "downloads have turns of their own";
  open.front()->context.TryCancel();
  open.front()->stream->Finish();
  while (absl::IsResourceExhausted(Upload("three").status())) std::this_thread::yield();
  EXPECT_TRUE(GetUpload(Sha256Hex("three")).complete());
  open.back()->context.TryCancel();
  open.back()->stream->Finish();
}

// Each call occupies a thread of the server, and some threads must be left for other tenants.
TEST_F(CoordinatorTest, CallsBeyondTheCapAreRefusedWhateverTheyAskFor) {
  Close();
  calls_.calls = 2;
  Open();
  const auto one = BeginUpload("one");
  const auto refusal_of = [this] {
    grpc::ClientContext context;
    v1::Upload upload;
    v1::GetUploadRequest request;
    request.set_sha256(Sha256Hex("one"));
    return DetailOf(rpc::FromGrpc(meshes_->GetUpload(&context, request, &upload)));
  };
  ErrorDetail refusal;
  v1::UploadMeshRequest request;
  request.set_sha256(Sha256Hex("two"));
  request.set_size(1'000'000);
  request.set_data("t");
  while (refusal.reason != Reason::kOverloaded) {  // the second upload may itself have been refused
    grpc::ClientContext context;
    Bound(context);
    v1::Upload upload;
    const auto two = meshes_->UploadMesh(&context, &upload);
    for (bool open = two->Write(request); open && refusal.reason != Reason::kOverloaded;) {
      refusal = refusal_of();
      v1::UploadMeshRequest more;
      more.set_data("t");
      open = two->Write(more);
    }
    context.TryCancel();
    two->Finish();
  }
  EXPECT_EQ(refusal.metadata.count(rpc::kRetryAfterMs), 1u);
  while (refusal_of().reason == Reason::kOverloaded) std::this_thread::yield();
  one->context.TryCancel();
  one->stream->Finish();
}

TEST_F(CoordinatorTest, RequestsAreCheckedBeforeAnythingIsKept) {
  const auto reason = [&](const std::function<void(v1::CreateJobRequest&)>& change) {
    v1::CreateJobRequest request = RequestFor("xxx");
    change(request);
    return DetailOf(Create(request).status()).reason;
  };
  EXPECT_EQ(reason([](auto&) {}), Reason::kBlobNotFound);
  EXPECT_EQ(reason([](auto& r) { r.mutable_spec()->clear_objects(); }), Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) { r.mutable_spec()->mutable_objects(0)->set_name("a\nM104 S300"); }),
            Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) {
              r.mutable_spec()->mutable_objects(0)->set_name(std::string(300, 'n'));
            }),
            Reason::kRequestTooLarge);
  EXPECT_EQ(reason([](auto& r) {
              r.mutable_spec()->mutable_objects(0)->mutable_placement()->set_unit_mm(-1);
            }),
            Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) {
              v1::Setting* setting = r.mutable_spec()->add_settings();
              setting->set_key("layer_height");
              setting->set_value("-1");
            }),
            Reason::kSettingOutOfRange);
  EXPECT_EQ(reason([](auto& r) {
              for (int i = 0; i < 100; ++i) (*r.mutable_labels())[absl::StrCat(i)] = "x";
            }),
            Reason::kRequestTooLarge);
  EXPECT_EQ(reason([](auto& r) {
              for (int i = 0; i < 20; ++i) {
                v1::Setting* setting = r.mutable_spec()->add_settings();
                setting->set_key("start_gcode");
                setting->set_value(std::string(60'000, 'G'));
              }
            }),
            Reason::kRequestTooLarge);
  EXPECT_EQ(reason([](auto& r) { r.set_request_id(std::string(300, 'r')); }),
            Reason::kRequestTooLarge);
  grpc::ClientContext context;
  v1::ListJobsResponse list;
  ASSERT_TRUE(jobs_->ListJobs(&context, {}, &list).ok());
  EXPECT_EQ(list.jobs_size(), 0);
}

TEST_F(CoordinatorTest, AnUnknownKeyIsRefusedInARequestAndReportedInAProfile) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  v1::Setting* setting = request.mutable_spec()->add_settings();
  setting->set_key("flux_capacitor");
  setting->set_value("1.21");
  EXPECT_EQ(DetailOf(Create(request).status()).reason, Reason::kSettingUnknown);
  setting->set_from_profile(true);
  const auto job = Create(request);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(AwaitEnd(job->id()).state(), v1::JOB_STATE_SUCCEEDED);
  const auto report = nlohmann::json::parse(*Download(job->id(), v1::ARTIFACT_REPORT));
  EXPECT_EQ(report["settings_without_effect"].size(), 1u);
}

TEST_F(CoordinatorTest, ABadMeshFailsTheJobWithTheStagesOwnError) {
  const v1::Job job = AwaitEnd(Submit("x!"));
  EXPECT_EQ(job.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job.error().reason(), "MESH_MALFORMED");
  EXPECT_EQ(job.error().code(), 3);
  EXPECT_EQ(job.error().metadata().at("line"), "7");
  EXPECT_EQ(DetailOf(Download(job.id(), v1::ARTIFACT_GCODE).status()).reason,
            Reason::kMeshMalformed)
      << "who waits for it to finish would wait for ever";
}

TEST_F(CoordinatorTest, AJobOutlivesAStageThatIsNotThere) {
  slicing_.unavailable_ = 1;
  EXPECT_EQ(AwaitEnd(Submit("x~")).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(slicing_.runs(), 2);
}

TEST_F(CoordinatorTest, AJobOutlivesAStageOfAnotherBuild) {
  slicing_.mismatches_ = 1;
  EXPECT_EQ(AwaitEnd(Submit("x?")).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(slicing_.runs(), 2);
}

TEST_F(CoordinatorTest, TheSameWorkIsDoneOnce) {
  const v1::Job first = AwaitEnd(Submit("xx"));
  const v1::Job second = AwaitEnd(Submit("xx"));
  EXPECT_FALSE(first.result().cached());
  EXPECT_TRUE(second.result().cached());
  EXPECT_EQ(second.result().gcode_sha256(), first.result().gcode_sha256());
  EXPECT_EQ(slicing_.runs(), 1);

  v1::CreateJobRequest other = RequestFor("xx");
  v1::Setting* setting = other.mutable_spec()->add_settings();
  setting->set_key("layer_height");
  setting->set_value("0.15");
  const auto third = Create(other);
  ASSERT_TRUE(third.ok()) << third.status();
  EXPECT_FALSE(AwaitEnd(third->id()).result().cached());
}

TEST_F(CoordinatorTest, TheSameWorkAtTheSameTimeIsDoneOnce) {
  ranges_->Hold();
  const std::string first = Submit("xxxx");
  ranges_->AwaitCall();
  const std::string second = Submit("xxxx");
  ranges_->LetGo();
  EXPECT_FALSE(AwaitEnd(first).result().cached());
  EXPECT_TRUE(AwaitEnd(second).result().cached());
  EXPECT_EQ(slicing_.runs(), 1);
}

TEST_F(CoordinatorTest, DeletedResultsAreComputedAgain) {
  const std::string first = Submit("xx");
  AwaitEnd(first);
  ASSERT_TRUE(Delete(first).ok());
  EXPECT_EQ(DetailOf(Download(first, v1::ARTIFACT_GCODE).status()).reason, Reason::kJobNotFound);
  const std::string second = Submit("xx");
  EXPECT_FALSE(AwaitEnd(second).result().cached());
  EXPECT_TRUE(Download(second, v1::ARTIFACT_GCODE).ok());
}

TEST_F(CoordinatorTest, ADamagedResultIsComputedAgain) {
  const v1::Job first = AwaitEnd(Submit("xx"));
  const std::string digest = first.result().gcode_sha256();
  std::filesystem::resize_file(BlobPath(digest), 3);
  EXPECT_TRUE(absl::IsDataLoss(Download(first.id(), v1::ARTIFACT_GCODE).status()));
  const v1::Job second = AwaitEnd(Submit("xx"));
  EXPECT_FALSE(second.result().cached());
  EXPECT_TRUE(Download(first.id(), v1::ARTIFACT_GCODE).ok()) << "which mends the first one's too";
}

TEST_F(CoordinatorTest, ADamagedRecordOfAResultIsMadeAnew) {
  AwaitEnd(Submit("xx"));
  const auto db = *SqliteConnection::Open(directory_.path() + "/jobs.db");
  ASSERT_TRUE(db->Execute("UPDATE results SET result = '{'").ok());
  const v1::Job second = AwaitEnd(Submit("xx"));
  EXPECT_EQ(second.state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_FALSE(second.result().cached());
  EXPECT_TRUE(AwaitEnd(Submit("xx")).result().cached());
}

TEST_F(CoordinatorTest, ADamagedMeshFailsTheJob) {
  ranges_->Hold();
  const std::string holds = Submit("x"), holds_too = Submit("xx");  // both threads are busy
  const std::string id = Submit("xxx");
  const std::string digest = Sha256Hex("xxx");
  std::filesystem::resize_file(BlobPath(digest), 1);
  ranges_->LetGo();
  const v1::Job job = AwaitEnd(id);
  EXPECT_EQ(job.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job.error().reason(), "BLOB_DIGEST_MISMATCH");
  AwaitEnd(holds);
  AwaitEnd(holds_too);
}

TEST_F(CoordinatorTest, RequestIdsMakeCreateIdempotent) {
  ASSERT_TRUE(Upload("xxx").ok());
  v1::CreateJobRequest request = RequestFor("xxx");
  request.set_request_id("11111111-2222-3333-4444-555555555555");
  std::vector<std::string> ids(16);
  std::vector<std::thread> threads;
  for (std::string& id : ids) {
    threads.emplace_back([&] {
      const auto job = Create(request);
      EXPECT_TRUE(job.ok()) << job.status();
      if (job.ok()) id = job->id();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(std::set<std::string>(ids.begin(), ids.end()), SizeIs(1));

  request.mutable_spec()->mutable_objects(0)->set_name("other.stl");
  EXPECT_EQ(DetailOf(Create(request).status()).reason, Reason::kRequestIdReused);
}

TEST_F(CoordinatorTest, CancelReachesTheWorkers) {
  ranges_->Hold();
  const std::string id = Submit("xxxx");
  ranges_->AwaitCall();
  ASSERT_TRUE(Cancel(id).ok());
  const v1::Job job = AwaitEnd(id);
  EXPECT_EQ(job.state(), v1::JOB_STATE_CANCELLED);
  EXPECT_GT(ranges_->cancelled(), 0);
  EXPECT_TRUE(Cancel(id).ok()) << "once more changes nothing";
  EXPECT_TRUE(Delete(id).ok());
}

TEST_F(CoordinatorTest, CancelOfAWaitingJobEndsItAtOnce) {
  ranges_->Hold();
  const std::string a = Submit("x"), b = Submit("xx");
  ranges_->AwaitCall();
  const std::string waits = Submit("xxx");
  ASSERT_TRUE(Cancel(waits).ok());
  EXPECT_EQ(AwaitEnd(waits).state(), v1::JOB_STATE_CANCELLED);
  EXPECT_EQ(DetailOf(Delete(a)).reason, Reason::kJobNotFinished);
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(a).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(AwaitEnd(b).state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(CoordinatorTest, AnUploadGoesOnWithinItsMesh) {
  for (const int64_t offset : {int64_t{-1}, int64_t{4}, std::numeric_limits<int64_t>::max()}) {
    grpc::ClientContext context;
    v1::Upload upload;
    const auto stream = meshes_->UploadMesh(&context, &upload);
    v1::UploadMeshRequest request;
    request.set_sha256(Sha256Hex("xxx"));
    request.set_size(3);
    request.set_write_offset(offset);
    request.set_data("xxx");
    stream->Write(request);
    stream->WritesDone();
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  }
}

TEST_F(CoordinatorTest, WatchTellsTheWholeStoryFromAnyPoint) {
  ranges_->Hold();
  const std::string id = Submit("xxxx");
  std::vector<v1::JobEvent> live;
  std::thread watcher([&] { live = Watch(id); });
  ranges_->AwaitCall();
  ranges_->LetGo();
  watcher.join();
  // Progress is sent under the number of the last event, and is not stored. The test removes it.
  std::erase_if(live, [last = int64_t{0}](const v1::JobEvent& event) mutable {
    return std::exchange(last, event.sequence()) == event.sequence();
  });
  ASSERT_GE(live.size(), 3u);
  EXPECT_EQ(live.front().job().state(), v1::JOB_STATE_QUEUED);
  EXPECT_FALSE(live.front().job().has_result());
  EXPECT_EQ(live.back().job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(live.back().job().has_result());
  for (const v1::JobEvent& event : live) EXPECT_FALSE(event.job().has_spec());

  // The progress of the run is sent under the number of the step before it, and only once.
  // Clang 14 cannot use the range that std::ranges::unique returns.
  const auto repeated = std::unique(
      live.begin(), live.end(),
      [](const v1::JobEvent& a, const v1::JobEvent& b) { return a.sequence() == b.sequence(); });
  live.erase(repeated, live.end());
  for (size_t after = 0; after <= live.size(); ++after) {
    const auto rest = Watch(id, after);
    ASSERT_EQ(rest.size(), live.size() - after);
    for (size_t i = 0; i < rest.size(); ++i) {
      EXPECT_EQ(live[after + i].sequence(), static_cast<int64_t>(after + i) + 1);
      EXPECT_EQ(rest[i].sequence(), live[after + i].sequence());
    }
  }
}

TEST_F(CoordinatorTest, WatchOfNoJobIsAnError) {
  absl::Status end;
  EXPECT_THAT(Watch("nonsense", 0, &end), SizeIs(0));
  EXPECT_EQ(DetailOf(end).reason, Reason::kJobNotFound);
}

// gRPC serves this method from a completion queue, which does not report an unreadable request by
// itself.
TEST_F(CoordinatorTest, AWatchThatCannotBeReadHasAReason) {
  rpc::StreamCall<grpc::ByteBuffer, grpc::ByteBuffer> call({}, [&](auto* context, auto* queue) {
    return grpc::GenericStub(channel_).PrepareCall(context, "/slicefarm.v1.Jobs/WatchJob", queue);
  });
  const grpc::Slice slice(std::string(10, '\xff'));
  grpc::ByteBuffer response;
  EXPECT_TRUE(call.Write(grpc::ByteBuffer(&slice, 1)) && call.WritesDone());
  EXPECT_FALSE(call.Read(&response));
  const absl::Status status = call.Finish();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
}

TEST_F(CoordinatorTest, AWatcherMayLeave) {
  ranges_->Hold();
  const std::string id = Submit("xxxx");
  {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_id(id);
    const auto stream = jobs_->WatchJob(&context, request);
    v1::JobEvent event;
    ASSERT_TRUE(stream->Read(&event));
    context.TryCancel();
    while (stream->Read(&event)) {
    }
    EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(CoordinatorTest, ListsByPages) {
  std::vector<std::string> ids;
  for (int i = 1; i <= 5; ++i) ids.push_back(Submit(std::string(i, 'x')));
  std::vector<std::string> listed;
  v1::ListJobsRequest request;
  request.set_page_size(2);
  do {
    grpc::ClientContext context;
    v1::ListJobsResponse page;
    ASSERT_TRUE(jobs_->ListJobs(&context, request, &page).ok());
    for (const v1::Job& job : page.jobs()) listed.push_back(job.id());
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  std::reverse(ids.begin(), ids.end());
  EXPECT_EQ(listed, ids);

  for (const std::string& id : ids) AwaitEnd(id);
  grpc::ClientContext context;
  v1::ListJobsRequest failed;
  failed.add_states(v1::JOB_STATE_FAILED);
  v1::ListJobsResponse none;
  ASSERT_TRUE(jobs_->ListJobs(&context, failed, &none).ok());
  EXPECT_EQ(none.jobs_size(), 0);
}

TEST_F(CoordinatorTest, ListRequestsAreChecked) {
  const auto reason = [&](const std::function<void(v1::ListJobsRequest&)>& change) {
    v1::ListJobsRequest request;
    change(request);
    grpc::ClientContext context;
    v1::ListJobsResponse page;
    return DetailOf(rpc::FromGrpc(jobs_->ListJobs(&context, request, &page))).reason;
  };
  EXPECT_EQ(reason([](auto& r) { r.set_page_size(-1); }), Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) { r.set_page_token("x"); }), Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) { r.set_page_token("-3"); }), Reason::kRequestMalformed);
  EXPECT_EQ(reason([](auto& r) { r.add_states(v1::JOB_STATE_UNSPECIFIED); }),
            Reason::kRequestMalformed);
}

TEST_F(CoordinatorTest, DownloadsStartAnywhere) {
  const std::string id = Submit(std::string(20'000, 'x'));
  ASSERT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  const auto whole = Download(id, v1::ARTIFACT_GCODE);
  ASSERT_TRUE(whole.ok()) << whole.status();
  ASSERT_GT(whole->size(), 150'000u);
  for (const int64_t offset :
       {int64_t{1}, int64_t{65'536}, int64_t{100'000}, static_cast<int64_t>(whole->size())}) {
    EXPECT_EQ(*Download(id, v1::ARTIFACT_GCODE, offset), whole->substr(offset)) << offset;
  }
  EXPECT_FALSE(Download(id, v1::ARTIFACT_GCODE, whole->size() + 1).ok());
  EXPECT_FALSE(Download(id, v1::ARTIFACT_GCODE, -1).ok());
  EXPECT_EQ(DetailOf(Download(id, v1::ARTIFACT_UNSPECIFIED).status()).reason,
            Reason::kRequestMalformed);
}

TEST_F(CoordinatorTest, ADrainLetsRunningJobsEndAndTakesUpNoOther) {
  ranges_->Hold();
  const std::string running = Submit("xxxx");
  ranges_->AwaitCall();
  coordinator_->Drain(std::chrono::milliseconds(0));
  const std::string waiting = Submit("yyyy");
  std::thread drain([this] { coordinator_->Drain(std::chrono::minutes(10)); });
  ranges_->LetGo();
  drain.join();
  EXPECT_EQ(Get(running)->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(Get(waiting)->state(), v1::JOB_STATE_QUEUED);
}

TEST_F(CoordinatorTest, AStopHandsJobsBackAndTheNextLifeGoesOn) {
  ranges_->Hold();
  const std::string id = Submit("xxxx");
  ranges_->AwaitCall();
  absl::Status end;
  std::vector<v1::JobEvent> before;
  std::thread watcher([&] { before = Watch(id, 0, &end); });
  Close();
  watcher.join();
  EXPECT_TRUE(absl::IsUnavailable(end)) << end;
  ranges_->LetGo();
  Open();
  const auto after = Watch(id, before.empty() ? 0 : before.back().sequence());
  ASSERT_FALSE(after.empty());
  EXPECT_EQ(after.back().job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(*Download(id, v1::ARTIFACT_GCODE), "; part.stl\nG1 X0\nG1 X1\nG1 X2\nG1 X3\n; end\n");
}

TEST_F(CoordinatorTest, TheStateBelongsToOneCoordinator) {
  CoordinatorOptions options;
  options.stores.state_dir = directory_.path();
  const auto second = Coordinator::Open(
      options,
      {{.slicing = &slicing_, .planning = &planning_, .motion = &motion_}, arranging_, projects_},
      dispatcher_, rpc::JsonLog("test"));
  EXPECT_TRUE(absl::IsUnavailable(second.status())) << second.status();
}

}  // namespace
}  // namespace slicefarm::coordinator::coordinator_test
