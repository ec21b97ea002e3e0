// Tenants of one coordinator, over a real server and real stores, with fake stages: what each may
// do, and that none learns anything of another.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/model/error.h"
#include "common/model/temp_directory_test.h"
#include "common/rpc/server.h"
#include "services/coordinator/algo/dispatcher.h"
#include "services/coordinator/server/coordinator.h"
#include "services/coordinator/server/coordinator_client_test.h"
#include "services/coordinator/server/fake_stages_test.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// All that a client can see of a call's end.
struct Seen {
  int code = 0;
  std::string message;
  std::string details;
  std::multimap<std::string, std::string> metadata;
  std::string body;

  Seen(const grpc::ClientContext& context, const grpc::Status& status, std::string answer = "")
      : code(status.error_code()),
        message(status.error_message()),
        details(status.error_details()),
        body(std::move(answer)) {
    for (const auto& [key, value] : context.GetServerInitialMetadata())
      Note("initial ", key, value);
    for (const auto& [key, value] : context.GetServerTrailingMetadata()) {
      Note("trailing ", key, value);
    }
  }
  void Note(const char* where, grpc::string_ref key, grpc::string_ref value) {
    metadata.emplace(where + std::string(key.data(), key.size()),
                     std::string(value.data(), value.size()));
  }

  absl::Status status() const {
    return rpc::FromGrpc(grpc::Status(static_cast<grpc::StatusCode>(code), message, details));
  }
  Reason reason() const { return DetailOf(status()).reason; }

  friend bool operator==(const Seen&, const Seen&) = default;
};

void PrintTo(const Seen& seen, std::ostream* out) {
  *out << seen.status() << " body " << testing::PrintToString(seen.body) << " metadata "
       << testing::PrintToString(seen.metadata);
}

/// What a tenant may try with a job that he knows the id of.
class TenantClient : public CoordinatorClient {
 public:
  TenantClient(const std::string& address, const std::string& token) {
    rpc::ChannelOptions options;
    options.token = token;
    Connect(address, options);
    profiles_ = v1::Profiles::NewStub(rpc::MakeChannel(address, options));
  }

  Seen SeePutProfile(const std::string& name) {
    v1::PutProfileRequest request;
    request.set_name(name);
    v1::Profile profile;
    grpc::ClientContext context;
    const grpc::Status status = profiles_->PutProfile(&context, request, &profile);
    return {context, status};
  }
  Seen SeeProfile(const std::string& name) {
    v1::GetProfileRequest request;
    request.set_name(name);
    v1::Profile profile;
    grpc::ClientContext context;
    const grpc::Status status = profiles_->GetProfile(&context, request, &profile);
    return {context, status};
  }
  Seen SeeProfiles() {
    v1::ListProfilesResponse response;
    grpc::ClientContext context;
    const grpc::Status status = profiles_->ListProfiles(&context, {}, &response);
    return {context, status, response.SerializeAsString()};
  }
  Seen SeeWebhook(const std::string& id) {
    v1::GetWebhookRequest request;
    request.set_job_id(id);
    v1::Webhook webhook;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->GetWebhook(&context, request, &webhook);
    return {context, status};
  }
  Seen SeeBatch(const v1::CreateJobRequest& each) {
    v1::BatchCreateJobsRequest request;
    *request.add_requests() = each;
    v1::BatchCreateJobsResponse response;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->BatchCreateJobs(&context, request, &response);
    return {context, status, response.SerializeAsString()};
  }
  Seen SeeGet(const std::string& id) {
    v1::GetJobRequest request;
    request.set_id(id);
    v1::Job job;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->GetJob(&context, request, &job);
    return {context, status};
  }
  Seen SeeCancel(const std::string& id) {
    v1::CancelJobRequest request;
    request.set_id(id);
    v1::Job job;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->CancelJob(&context, request, &job);
    return {context, status};
  }
  Seen SeeDelete(const std::string& id) {
    v1::DeleteJobRequest request;
    request.set_id(id);
    google::protobuf::Empty empty;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->DeleteJob(&context, request, &empty);
    return {context, status};
  }
  Seen SeeWatch(const std::string& id) {
    v1::WatchJobRequest request;
    request.set_id(id);
    grpc::ClientContext context;
    const auto stream = jobs_->WatchJob(&context, request);
    v1::JobEvent event;
    while (stream->Read(&event)) {
    }
    const grpc::Status status = stream->Finish();
    return {context, status};
  }
  Seen SeeDownload(const std::string& id, v1::Artifact artifact = v1::ARTIFACT_GCODE) {
    v1::DownloadRequest request;
    request.set_id(id);
    request.set_artifact(artifact);
    grpc::ClientContext context;
    const auto stream = jobs_->Download(&context, request);
    v1::DownloadResponse response;
    while (stream->Read(&response)) {
    }
    const grpc::Status status = stream->Finish();
    return {context, status};
  }
  Seen SeeUploadStatus(const std::string& digest) {
    v1::GetUploadRequest request;
    request.set_sha256(digest);
    v1::Upload upload;
    grpc::ClientContext context;
    const grpc::Status status = meshes_->GetUpload(&context, request, &upload);
    return {context, status, upload.SerializeAsString()};
  }
  /// Sends the bytes of [from, to) of a mesh in one message.
  Seen SeeUpload(const std::string& bytes, int64_t from, int64_t to) {
    grpc::ClientContext context;
    v1::Upload upload;
    const auto stream = meshes_->UploadMesh(&context, &upload);
    v1::UploadMeshRequest request;
    request.set_sha256(Sha256Hex(bytes));
    request.set_size(std::ssize(bytes));
    request.set_write_offset(from);
    request.set_data(bytes.substr(from, to - from));
    stream->Write(request);
    stream->WritesDone();
    const grpc::Status status = stream->Finish();
    return {context, status, upload.SerializeAsString()};
  }
  Seen SeeList() {
    v1::ListJobsResponse response;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->ListJobs(&context, {}, &response);
    return {context, status};
  }
  Seen SeeCreate(const v1::CreateJobRequest& request) {
    v1::Job job;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->CreateJob(&context, request, &job);
    return {context, status};
  }

  std::vector<Seen> SeeAllOf(const std::string& id) {
    return {SeeGet(id),
            SeeWatch(id),
            SeeWebhook(id),
            SeeCancel(id),
            SeeDownload(id),
            SeeDownload(id, v1::ARTIFACT_REPORT),
            SeeDownload(id, v1::ARTIFACT_UNSPECIFIED),
            SeeDelete(id)};
  }

  std::vector<std::string> List() {
    v1::ListJobsResponse response;
    grpc::ClientContext context;
    EXPECT_TRUE(jobs_->ListJobs(&context, {}, &response).ok());
    std::vector<std::string> ids;
    for (const v1::Job& job : response.jobs()) ids.push_back(job.id());
    return ids;
  }

 private:
  std::unique_ptr<v1::Profiles::Stub> profiles_;
};

class IsolationTest : public testing::Test {
 protected:
  IsolationTest() {
    dispatcher_.Join({.name = "fake", .ranges = ranges_, .slots = 2});
    for (const char* name : {"a", "b"}) {
      Tenant& tenant = tenants_[name];
      tenant.tokens = {TokenFor(absl::StrCat(name, "-1"), {Scope::kSubmit, Scope::kRead}),
                       TokenFor(absl::StrCat(name, "-2"), {Scope::kRead})};
    }
    tenants_["ops"].tokens = {TokenFor("ops-1", {Scope::kAdmin})};
    Open();
    a_ = As("a-1");
    b_ = As("b-1");
  }

  ~IsolationTest() override {
    ranges_->LetGo();
    Close();
  }

  static Token TokenFor(const std::string& token, const Scopes& scopes) {
    return {Sha256Hex(token), scopes};
  }

  void Open(ResultSharing sharing = ResultSharing::kOff) {
    CoordinatorOptions options;
    options.sharing = sharing;
    options.stores.state_dir = directory_.path();
    options.build_id = "test-build";
    options.runner.owner = "coordinator";
    options.runner.jobs = 2;
    options.runner.poll = std::chrono::milliseconds(20);
    options.tenants = [this] {
      const std::lock_guard lock(mutex_);
      return std::make_shared<const Tenants>(tenants_);
    };
    auto coordinator =
        Coordinator::Open(options, slicing_, motion_, dispatcher_, rpc::JsonLog("test"));
    ASSERT_TRUE(coordinator.ok()) << coordinator.status();
    coordinator_ = *std::move(coordinator);
    auto server =
        rpc::Server::Start({}, coordinator_->services(), metrics_, &coordinator_->queued_methods());
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    ASSERT_TRUE(coordinator_->Start().ok());
  }

  void Close() {
    coordinator_->Stop();
    server_->Drain(std::chrono::seconds(10));
    server_.reset();
    coordinator_.reset();
  }

  /// A client with this token; empty: without.
  std::unique_ptr<TenantClient> As(const std::string& token) {
    return std::make_unique<TenantClient>(absl::StrCat("127.0.0.1:", server_->port()), token);
  }

  void Change(const std::function<void(Tenants&)>& change) {
    const std::lock_guard lock(mutex_);
    change(tenants_);
  }

  static std::string Submit(TenantClient& client, const std::string& mesh) {
    EXPECT_TRUE(client.Upload(mesh).ok());
    const auto job = client.Create(TenantClient::RequestFor(mesh));
    EXPECT_TRUE(job.ok()) << job.status();
    return job.ok() ? job->id() : "";
  }

  static v1::Job AwaitEnd(TenantClient& client, const std::string& id) {
    EXPECT_TRUE(client.SeeWatch(id).status().ok());
    return client.Get(id).value_or(v1::Job());
  }

  TempDirectory directory_;
  FakeSlicing slicing_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  prometheus::Registry registry_;
  rpc::CallMetrics metrics_{registry_};
  std::mutex mutex_;
  Tenants tenants_;
  std::unique_ptr<Coordinator> coordinator_;
  std::unique_ptr<rpc::Server> server_;
  std::unique_ptr<TenantClient> a_;
  std::unique_ptr<TenantClient> b_;
};

TEST_F(IsolationTest, EachTenantHasItsJobsToItself) {
  const std::string of_a = Submit(*a_, "xa");
  const std::string of_b = Submit(*b_, "xb");
  EXPECT_EQ(AwaitEnd(*a_, of_a).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(AwaitEnd(*b_, of_b).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(a_->List(), testing::ElementsAre(of_a));
  EXPECT_THAT(b_->List(), testing::ElementsAre(of_b));
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
}

TEST_F(IsolationTest, AnothersJobLooksLikeNoneAtAll) {
  const std::string of_b = Submit(*b_, "xb");
  AwaitEnd(*b_, of_b);
  const std::vector<Seen> while_there = a_->SeeAllOf(of_b);
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_EQ(while_there, a_->SeeAllOf(of_b));
  for (const Seen& seen : while_there) EXPECT_EQ(seen.reason(), Reason::kJobNotFound);
}

TEST_F(IsolationTest, AnothersRunningJobLooksLikeNoneAtAll) {
  ranges_->Hold();
  const std::string of_b = Submit(*b_, "xb");
  const std::vector<Seen> while_there = a_->SeeAllOf(of_b);
  EXPECT_NE(b_->Get(of_b)->state(), v1::JOB_STATE_CANCELLED);
  ranges_->LetGo();
  AwaitEnd(*b_, of_b);
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_EQ(while_there, a_->SeeAllOf(of_b));
}

TEST_F(IsolationTest, AnothersMeshLooksLikeNoneAtAll) {
  const std::string mesh = std::string(1000, 'x') + "secret";
  v1::CreateJobRequest look = TenantClient::RequestFor(mesh);
  look.set_validate_only(true);
  const auto see = [&] {
    return std::vector<Seen>{a_->SeeUploadStatus(Sha256Hex(mesh)),
                             a_->SeeCreate(TenantClient::RequestFor(mesh)),
                             a_->SeeBatch(TenantClient::RequestFor(mesh)), a_->SeeCreate(look),
                             a_->SeeUpload(mesh, 500, 1006)};  // as if the first half were there
  };
  const std::vector<Seen> before = see();
  ASSERT_TRUE(b_->Upload(mesh, 0, 500).ok());
  EXPECT_EQ(before, see()) << "half of it is there";
  AwaitEnd(*b_, Submit(*b_, mesh));
  EXPECT_EQ(before, see());
  EXPECT_EQ(before[1].reason(), Reason::kBlobNotFound);
  EXPECT_EQ(before[3].reason(), Reason::kBlobNotFound);
  EXPECT_EQ(before[4].reason(), Reason::kUploadOffset);

  // All of it has to be sent: what another has sent counts for nothing.
  v1::Upload upload;
  ASSERT_TRUE(upload.ParseFromString(a_->SeeUpload(mesh, 0, 500).body));
  EXPECT_EQ(upload.committed_size(), 500);
  EXPECT_FALSE(upload.complete());
  ASSERT_TRUE(upload.ParseFromString(a_->SeeUpload(mesh, 500, 1006).body));
  EXPECT_TRUE(upload.complete());
}

TEST_F(IsolationTest, EachTenantHasItsProfilesToItself) {
  const auto see = [&] { return std::vector<Seen>{a_->SeeProfile("pla"), a_->SeeProfiles()}; };
  const std::vector<Seen> before = see();
  EXPECT_TRUE(b_->SeePutProfile("pla").status().ok());
  EXPECT_EQ(before, see());
  EXPECT_EQ(before[0].reason(), Reason::kProfileNotFound);
  EXPECT_TRUE(b_->SeeProfile("pla").status().ok());
}

TEST_F(IsolationTest, NobodySpoilsAnothersUpload) {
  const std::string mesh(1000, 'x');
  ASSERT_TRUE(a_->Upload(mesh, 0, 500).ok());
  EXPECT_EQ(DetailOf(b_->Upload(std::string(1000, '!'), 0, -1, Sha256Hex(mesh)).status()).reason,
            Reason::kBlobDigestMismatch);
  EXPECT_TRUE(a_->Upload(mesh, 500)->complete());
}

TEST_F(IsolationTest, AnothersResultIsNotTaken) {
  const std::string of_b = Submit(*b_, "xx");
  EXPECT_EQ(AwaitEnd(*b_, of_b).state(), v1::JOB_STATE_SUCCEEDED);
  const v1::Job of_a = AwaitEnd(*a_, Submit(*a_, "xx"));
  EXPECT_EQ(of_a.state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_FALSE(of_a.result().cached());
  EXPECT_EQ(slicing_.runs(), 2);
  EXPECT_TRUE(AwaitEnd(*a_, Submit(*a_, "xx")).result().cached());
  EXPECT_EQ(slicing_.runs(), 2);
  // Nor does it come back after one's own is gone: the index knows whose it is.
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_FALSE(AwaitEnd(*b_, Submit(*b_, "xx")).result().cached());
}

TEST_F(IsolationTest, AnothersRunningWorkIsNotWaitedFor) {
  ranges_->Hold();
  const std::string of_b = Submit(*b_, "xx");
  ranges_->AwaitCall();
  const std::string of_a = Submit(*a_, "xx");
  while (slicing_.runs() < 2) std::this_thread::yield();
  ranges_->LetGo();
  EXPECT_FALSE(AwaitEnd(*a_, of_a).result().cached());
  EXPECT_FALSE(AwaitEnd(*b_, of_b).result().cached());
}

TEST_F(IsolationTest, TenantsMayShareTheirResults) {
  Close();
  Open(ResultSharing::kOn);
  a_ = As("a-1");
  b_ = As("b-1");
  const std::string of_b = Submit(*b_, "xx");
  EXPECT_EQ(AwaitEnd(*b_, of_b).state(), v1::JOB_STATE_SUCCEEDED);
  const std::string of_a = Submit(*a_, "xx");
  EXPECT_TRUE(AwaitEnd(*a_, of_a).result().cached());
  EXPECT_EQ(slicing_.runs(), 1);
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
  EXPECT_EQ(a_->SeeUploadStatus(Sha256Hex("xy")).body, b_->SeeUploadStatus(Sha256Hex("xy")).body);

  // What was shared stays with the jobs that have it, and is not found any more.
  Close();
  Open(ResultSharing::kOff);
  a_ = As("a-1");
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
  EXPECT_FALSE(AwaitEnd(*a_, Submit(*a_, "xx")).result().cached());
}

TEST_F(IsolationTest, RequestIdsAreEachTenantsOwn) {
  v1::CreateJobRequest request = TenantClient::RequestFor("xa");
  request.set_request_id("once");
  ASSERT_TRUE(a_->Upload("xa").ok());
  ASSERT_TRUE(b_->Upload("xa").ok());
  ASSERT_TRUE(b_->Upload("xb").ok());
  const auto of_a = a_->Create(request);
  const auto of_b = b_->Create(request);
  ASSERT_TRUE(of_a.ok() && of_b.ok());
  EXPECT_NE(of_a->id(), of_b->id());
  EXPECT_EQ(a_->Create(request)->id(), of_a->id());
}

TEST_F(IsolationTest, OpenJobsAreCountedByTenant) {
  Change([](Tenants& tenants) { tenants["a"].max_open_jobs = 1; });
  ranges_->Hold();
  Submit(*a_, "xa");
  const Seen second = a_->SeeCreate(TenantClient::RequestFor("xa"));
  EXPECT_EQ(second.reason(), Reason::kQueueFull);
  EXPECT_EQ(DetailOf(second.status()).metadata.at("limit"), "1");
  Submit(*b_, "xb");
  Submit(*b_, "xbb");
}

TEST_F(IsolationTest, WhoHasNoTokenIsNobody) {
  const std::string of_a = Submit(*a_, "xa");
  for (const char* token : {"", "a-3", "a-1 ", "A-1"}) {
    const auto nobody = As(token);
    std::vector<Seen> all = nobody->SeeAllOf(of_a);
    all.push_back(nobody->SeeList());
    all.push_back(nobody->SeeBatch(TenantClient::RequestFor("xa")));
    all.push_back(nobody->SeePutProfile("pla"));
    all.push_back(nobody->SeeProfile("pla"));
    all.push_back(nobody->SeeProfiles());
    all.push_back(nobody->SeeUploadStatus(Sha256Hex("xa")));
    all.push_back(nobody->SeeCreate(TenantClient::RequestFor("xa")));
    for (const Seen& seen : all) {
      EXPECT_EQ(seen.code, grpc::StatusCode::UNAUTHENTICATED) << token;
      EXPECT_EQ(seen.reason(), Reason::kUnauthenticated);
      EXPECT_EQ(seen.message, all.front().message);
    }
    EXPECT_EQ(DetailOf(nobody->Upload("xa").status()).reason, Reason::kUnauthenticated);
  }
}

TEST_F(IsolationTest, ATokenMayDoWhatItsScopesSay) {
  const std::string of_a = Submit(*a_, "xa");
  AwaitEnd(*a_, of_a);
  const auto denied = [](const Seen& seen, const std::string& scope) {
    EXPECT_EQ(seen.code, grpc::StatusCode::PERMISSION_DENIED);
    EXPECT_EQ(seen.reason(), Reason::kPermissionDenied);
    EXPECT_EQ(DetailOf(seen.status()).metadata["scope"], scope);
  };
  const auto reader = As("a-2");
  EXPECT_TRUE(reader->SeeGet(of_a).status().ok());
  EXPECT_TRUE(reader->SeeWatch(of_a).status().ok());
  EXPECT_TRUE(reader->SeeDownload(of_a).status().ok());
  EXPECT_THAT(reader->List(), testing::ElementsAre(of_a));
  denied(reader->SeeCreate(TenantClient::RequestFor("xa")), "submit");
  denied(reader->SeeUploadStatus(Sha256Hex("xa")), "submit");
  denied(reader->SeeCancel(of_a), "submit");
  denied(reader->SeeBatch(TenantClient::RequestFor("xa")), "submit");
  denied(reader->SeePutProfile("pla"), "submit");
  EXPECT_TRUE(reader->SeeProfiles().status().ok());
  denied(reader->SeeDelete(of_a), "submit");
  EXPECT_EQ(DetailOf(reader->Upload("xa").status()).reason, Reason::kPermissionDenied);
  // Whether the job is there makes no difference to what is said.
  EXPECT_EQ(reader->SeeDelete("0123456789abcdef0123456789abcdef"), reader->SeeDelete(of_a));

  Change([](Tenants& tenants) { tenants["a"].tokens[1].scopes = {Scope::kSubmit}; });
  denied(reader->SeeGet(of_a), "read");
  denied(reader->SeeWatch(of_a), "read");
  denied(reader->SeeDownload(of_a), "read");
  denied(reader->SeeList(), "read");
  denied(reader->SeeWebhook(of_a), "read");
  denied(reader->SeeProfiles(), "read");
  EXPECT_TRUE(reader->SeeDelete(of_a).status().ok());
}

TEST_F(IsolationTest, AdminsSeeAndCancelTheJobsOfAll) {
  const auto ops = As("ops-1");
  ranges_->Hold();
  const std::string of_a = Submit(*a_, "xa");
  const std::string of_b = Submit(*b_, "xb");
  EXPECT_THAT(ops->List(), testing::UnorderedElementsAre(of_a, of_b));
  EXPECT_EQ(ops->Get(of_a)->tenant(), "a");
  EXPECT_EQ(ops->Get(of_b)->tenant(), "b");
  EXPECT_TRUE(ops->SeeCancel(of_a).status().ok());
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(*a_, of_a).state(), v1::JOB_STATE_CANCELLED);
  EXPECT_TRUE(ops->SeeWatch(of_b).status().ok());
  EXPECT_EQ(ops->SeeDownload(of_b).reason(), Reason::kPermissionDenied);
  EXPECT_EQ(ops->SeeDelete(of_b).reason(), Reason::kPermissionDenied);
  Change([](Tenants& tenants) {
    tenants["ops"].tokens[0].scopes = {Scope::kAdmin, Scope::kRead, Scope::kSubmit};
  });
  EXPECT_EQ(ops->SeeDownload(of_b).reason(), Reason::kJobNotFound);
  EXPECT_EQ(ops->SeeDelete(of_b).reason(), Reason::kJobNotFound);
}

TEST_F(IsolationTest, TokensAreRotatedWhileCallsGoOn) {
  const std::string of_a = Submit(*a_, "xa");
  const auto next = As("a-3");
  EXPECT_EQ(next->SeeGet(of_a).reason(), Reason::kUnauthenticated);
  Change([](Tenants& tenants) {
    tenants["a"].tokens[1] = TokenFor("a-3", {Scope::kSubmit, Scope::kRead});
  });
  EXPECT_TRUE(next->SeeGet(of_a).status().ok());
  EXPECT_TRUE(a_->SeeGet(of_a).status().ok());
  Change([](Tenants& tenants) { tenants["a"].tokens.erase(tenants["a"].tokens.begin()); });
  EXPECT_TRUE(next->SeeGet(of_a).status().ok());
  EXPECT_EQ(a_->SeeGet(of_a).reason(), Reason::kUnauthenticated);
  Change([](Tenants& tenants) { tenants["a"].tokens[0].expires_us = 1; });
  EXPECT_EQ(next->SeeGet(of_a).reason(), Reason::kUnauthenticated);
}

}  // namespace
}  // namespace slicefarm::coordinator
