// Tests of several tenants of one coordinator, with a real server, real stores and fake stages.
// They check the permissions of each tenant, and that no tenant learns anything about another.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "services/coordinator/server/api/served_coordinator_test.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator::isolation_test {
namespace {

/// Everything that a client can see of a call's end.
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

/// Returns a request for an object with this id.
template <typename Request>
Request ById(const std::string& id) {
  Request request;
  request.set_id(id);
  return request;
}

/// Returns a request for an object with this name.
template <typename Request>
Request ByName(const std::string& name) {
  Request request;
  request.set_name(name);
  return request;
}

/// Client that makes all calls that a tenant may try with a job if it has its id.
class TenantClient : public CoordinatorClient {
 public:
  TenantClient(const std::string& address, const std::string& token) {
    rpc::ChannelOptions options;
    options.token = token;
    Connect(address, options);
  }

  Seen SeePutProfile(const std::string& name) {
    return See(*profiles_, &v1::Profiles::Stub::PutProfile, ByName<v1::PutProfileRequest>(name));
  }
  Seen SeeProfile(const std::string& name) {
    return See(*profiles_, &v1::Profiles::Stub::GetProfile, ByName<v1::GetProfileRequest>(name));
  }
  Seen SeeDeleteProfile(const std::string& name) {
    return See(*profiles_, &v1::Profiles::Stub::DeleteProfile,
               ByName<v1::DeleteProfileRequest>(name));
  }
  Seen SeeProfiles() {
    return See(*profiles_, &v1::Profiles::Stub::ListProfiles, v1::ListProfilesRequest());
  }
  Seen SeeImportPresets(const std::string& name) {
    auto request = ByName<v1::ImportPresetsRequest>(name);
    v1::PresetFile* file = request.add_files();
    file->set_path("a.ini");
    file->set_content("[print:P]\nlayer_height = 0.2\n");
    return See(*presets_, &v1::Presets::Stub::ImportPresets, request);
  }
  Seen SeePresetBundle(const std::string& name) {
    return See(*presets_, &v1::Presets::Stub::GetPresetBundle,
               ByName<v1::GetPresetBundleRequest>(name));
  }
  Seen SeeDeletePresets(const std::string& name) {
    return See(*presets_, &v1::Presets::Stub::DeletePresetBundle,
               ByName<v1::DeletePresetBundleRequest>(name));
  }
  Seen SeePresets() {
    return See(*presets_, &v1::Presets::Stub::ListPresets, v1::ListPresetsRequest());
  }
  Seen SeeWebhook(const std::string& id) {
    v1::GetWebhookRequest request;
    request.set_job_id(id);
    return See(*jobs_, &v1::Jobs::Stub::GetWebhook, request);
  }
  Seen SeeBatch(const v1::CreateJobRequest& each) {
    v1::BatchCreateJobsRequest request;
    *request.add_requests() = each;
    return See(*jobs_, &v1::Jobs::Stub::BatchCreateJobs, request);
  }
  Seen SeeGet(const std::string& id) {
    return See(*jobs_, &v1::Jobs::Stub::GetJob, ById<v1::GetJobRequest>(id));
  }
  Seen SeeCancel(const std::string& id) {
    return See(*jobs_, &v1::Jobs::Stub::CancelJob, ById<v1::CancelJobRequest>(id));
  }
  Seen SeeDelete(const std::string& id) {
    return See(*jobs_, &v1::Jobs::Stub::DeleteJob, ById<v1::DeleteJobRequest>(id));
  }
  Seen SeeWatch(const std::string& id) {
    return See(*jobs_, &v1::Jobs::Stub::WatchJob, ById<v1::WatchJobRequest>(id));
  }
  Seen SeeDownload(const std::string& id, v1::Artifact artifact = v1::ARTIFACT_GCODE) {
    v1::DownloadRequest request = ById<v1::DownloadRequest>(id);
    request.set_artifact(artifact);
    return See(*jobs_, &v1::Jobs::Stub::Download, request);
  }
  Seen SeeUploadStatus(const std::string& digest) {
    v1::GetUploadRequest request;
    request.set_sha256(digest);
    return See(*meshes_, &v1::Meshes::Stub::GetUpload, request);
  }
  Seen SeeList() { return See(*jobs_, &v1::Jobs::Stub::ListJobs, v1::ListJobsRequest()); }
  Seen SeeCreate(const v1::CreateJobRequest& request) {
    return See(*jobs_, &v1::Jobs::Stub::CreateJob, request);
  }
  /// Sends the bytes [from, to) of a mesh in one message.
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

  /// Watch that is open until the object is destroyed. `open`: the server accepted the watch.
  struct OpenWatch {
    grpc::ClientContext context;
    std::unique_ptr<grpc::ClientReader<v1::JobEvent>> stream;
    bool open = false;

    ~OpenWatch() {
      context.TryCancel();
      stream->Finish();
    }
  };
  std::unique_ptr<OpenWatch> Watch(const std::string& id) {
    auto watch = std::make_unique<OpenWatch>();
    watch->stream = jobs_->WatchJob(&watch->context, ById<v1::WatchJobRequest>(id));
    watch->stream->WaitForInitialMetadata();
    watch->open = watch->context.GetServerInitialMetadata().contains("slicefarm-watch");
    return watch;
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

 private:
  template <typename Stub, typename Request, typename Response>
  static Seen See(Stub& stub,
                  grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                  const Request& request) {
    grpc::ClientContext context;
    Response response;
    const grpc::Status status = (stub.*method)(&context, request, &response);
    return {context, status, response.SerializeAsString()};
  }

  /// Makes a streaming call and returns only its end.
  template <typename Stub, typename Request, typename Response>
  static Seen See(Stub& stub,
                  std::unique_ptr<grpc::ClientReader<Response>> (Stub::*method)(
                      grpc::ClientContext*, const Request&),
                  const Request& request) {
    grpc::ClientContext context;
    const auto stream = (stub.*method)(&context, request);
    Response response;
    while (stream->Read(&response)) {
    }
    const grpc::Status status = stream->Finish();
    return {context, status};
  }
};

class IsolationTest : public ServedCoordinatorTest {
 protected:
  static constexpr int kWatchesATenant = 3;

  IsolationTest() {
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

  static Token TokenFor(const std::string& token, const Scopes& scopes) {
    return {Sha256Hex(token), scopes};
  }

  void Open(ResultSharing sharing = ResultSharing::kOff) {
    CoordinatorOptions options = Options();
    options.sharing = sharing;
    options.watches.calls = 2 * kWatchesATenant;
    options.tenants = [this] {
      const std::lock_guard lock(mutex_);
      return std::make_shared<const Tenants>(tenants_);
    };
    Serve(options);
  }

  /// Returns a client with this token; without a token if it is empty.
  std::unique_ptr<TenantClient> As(const std::string& token) {
    return std::make_unique<TenantClient>(address(), token);
  }

  void Change(const std::function<void(Tenants&)>& change) {
    const std::lock_guard lock(mutex_);
    change(tenants_);
  }

  std::mutex mutex_;
  Tenants tenants_;
  std::unique_ptr<TenantClient> a_;
  std::unique_ptr<TenantClient> b_;
};

TEST_F(IsolationTest, EachTenantHasItsJobsToItself) {
  const std::string of_a = a_->Submit("xa");
  const std::string of_b = b_->Submit("xb");
  EXPECT_EQ(a_->AwaitEnd(of_a).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(b_->AwaitEnd(of_b).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(a_->List(), testing::ElementsAre(of_a));
  EXPECT_THAT(b_->List(), testing::ElementsAre(of_b));
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
}

TEST_F(IsolationTest, AnothersJobLooksLikeNoneAtAll) {
  const std::string of_b = b_->Submit("xb");
  b_->AwaitEnd(of_b);
  const std::vector<Seen> while_there = a_->SeeAllOf(of_b);
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_EQ(while_there, a_->SeeAllOf(of_b));
  for (const Seen& seen : while_there) EXPECT_EQ(seen.reason(), Reason::kJobNotFound);
}

TEST_F(IsolationTest, AnothersRunningJobLooksLikeNoneAtAll) {
  ranges_->Hold();
  const std::string of_b = b_->Submit("xb");
  const std::vector<Seen> while_there = a_->SeeAllOf(of_b);
  EXPECT_NE(b_->Get(of_b)->state(), v1::JOB_STATE_CANCELLED);
  ranges_->LetGo();
  b_->AwaitEnd(of_b);
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
                             a_->SeeUpload(mesh, 500, 1006)};  // as if the first half were stored
  };
  const std::vector<Seen> before = see();
  ASSERT_TRUE(b_->Upload(mesh, 0, 500).ok());
  EXPECT_EQ(before, see()) << "half of it is there";
  b_->AwaitEnd(b_->Submit(mesh));
  EXPECT_EQ(before, see());
  EXPECT_EQ(before[1].reason(), Reason::kBlobNotFound);
  EXPECT_EQ(before[3].reason(), Reason::kBlobNotFound);
  EXPECT_EQ(before[4].reason(), Reason::kUploadOffset);

  // The tenant must send the whole mesh, because bytes from another tenant do not count.
  v1::Upload upload;
  ASSERT_TRUE(upload.ParseFromString(a_->SeeUpload(mesh, 0, 500).body));
  EXPECT_EQ(upload.committed_size(), 500);
  EXPECT_FALSE(upload.complete());
  ASSERT_TRUE(upload.ParseFromString(a_->SeeUpload(mesh, 500, 1006).body));
  EXPECT_TRUE(upload.complete());
}

TEST_F(IsolationTest, EachTenantHasItsPresetsToItself) {
  const auto see = [&] { return std::vector<Seen>{a_->SeePresetBundle("acme"), a_->SeePresets()}; };
  const std::vector<Seen> before = see();
  EXPECT_TRUE(b_->SeeImportPresets("acme").status().ok());
  EXPECT_EQ(see(), before);
  EXPECT_EQ(before[0].reason(), Reason::kProfileNotFound);
  EXPECT_TRUE(b_->SeePresets().status().ok());
  EXPECT_EQ(a_->SeeDeletePresets("acme").reason(), Reason::kProfileNotFound) << "it is b's";
  EXPECT_TRUE(b_->SeeDeletePresets("acme").status().ok());
  EXPECT_EQ(b_->SeePresets().reason(), Reason::kProfileNotFound);
}

TEST_F(IsolationTest, EachTenantHasItsProfilesToItself) {
  const auto see = [&] { return std::vector<Seen>{a_->SeeProfile("pla"), a_->SeeProfiles()}; };
  const std::vector<Seen> before = see();
  EXPECT_TRUE(b_->SeePutProfile("pla").status().ok());
  EXPECT_EQ(before, see());
  EXPECT_EQ(before[0].reason(), Reason::kProfileNotFound);
  EXPECT_TRUE(b_->SeeProfile("pla").status().ok());
  EXPECT_EQ(a_->SeeDeleteProfile("pla").reason(), Reason::kProfileNotFound) << "it is b's";
  EXPECT_TRUE(b_->SeeDeleteProfile("pla").status().ok());
  EXPECT_EQ(b_->SeeProfile("pla").reason(), Reason::kProfileNotFound);
}

TEST_F(IsolationTest, NobodySpoilsAnothersUpload) {
  const std::string mesh(1000, 'x');
  ASSERT_TRUE(a_->Upload(mesh, 0, 500).ok());
  EXPECT_EQ(DetailOf(b_->Upload(std::string(1000, '!'), 0, -1, Sha256Hex(mesh)).status()).reason,
            Reason::kBlobDigestMismatch);
  EXPECT_TRUE(a_->Upload(mesh, 500)->complete());
}

TEST_F(IsolationTest, AFullQueueTakesNoMeshes) {
  Change([](Tenants& tenants) { tenants["a"].max_open_jobs = 1; });
  ranges_->Hold();
  a_->Submit("xa");
  std::optional<Seen> upload;
  do {  // the refusal is valid only for a short time
    EXPECT_EQ(a_->SeeCreate(TenantClient::RequestFor("xa")).reason(), Reason::kQueueFull);
    upload = a_->SeeUpload("xxa", 0, 3);
  } while (upload->status().ok());
  EXPECT_EQ(upload->reason(), Reason::kQueueFull);
  EXPECT_TRUE(DetailOf(upload->status()).metadata.contains(rpc::kRetryAfterMs));
  EXPECT_TRUE(b_->SeeUpload("xxa", 0, 3).status().ok());
}

TEST_F(IsolationTest, ATenantsWatchesLeaveRoomForOthers) {
  ranges_->Hold();
  const std::string of_a = a_->Submit("xa");
  const std::string of_b = b_->Submit("xb");
  std::vector<std::unique_ptr<TenantClient::OpenWatch>> open;
  for (int i = 0; i < kWatchesATenant; ++i) open.push_back(a_->Watch(of_a));
  const Seen refused = a_->SeeWatch(of_a);
  EXPECT_EQ(refused.reason(), Reason::kOverloaded);
  EXPECT_TRUE(DetailOf(refused.status()).metadata.contains(rpc::kRetryAfterMs));
  EXPECT_TRUE(b_->Watch(of_b)->open);
  open.erase(open.begin());
  while (!a_->Watch(of_a)->open) std::this_thread::yield();
}

TEST_F(IsolationTest, ATenantsBudgetEndsWhatItKeeps) {
  Change([](Tenants& tenants) {
    tenants["a"].max_kept_jobs = 1;
    tenants["b"].max_kept_bytes = 4;
  });
  EXPECT_EQ(a_->AwaitEnd(a_->Submit("xa")).state(), v1::JOB_STATE_SUCCEEDED);
  const auto second = a_->Create(TenantClient::RequestFor("xa"));
  EXPECT_EQ(DetailOf(second.status()).metadata["budget"], "jobs") << second.status();
  const auto upload = b_->Upload("xxxxx");
  EXPECT_EQ(DetailOf(upload.status()).metadata["budget"], "bytes") << upload.status();
  EXPECT_TRUE(b_->Upload("xxxx").ok());
}

// Another tenant must learn neither that the job exists nor that it is damaged.
TEST_F(IsolationTest, AnothersDamagedJobIsAsOneThatNeverWas) {
  ranges_->Hold();
  const std::string of_a = a_->Submit("xa");
  ranges_->AwaitCall();
  Close();
  ASSERT_TRUE((*SqliteConnection::Open(directory_.path() + "/jobs.db"))
                  ->Execute("UPDATE jobs SET labels = '{\"a'")
                  .ok());
  Open();
  a_ = As("a-1");
  b_ = As("b-1");
  EXPECT_EQ(a_->SeeGet(of_a).reason(), Reason::kStoreFailed);
  const std::string never(of_a.size(), '0');
  const auto as_if = [&](Seen seen) {
    for (std::string* text : {&seen.message, &seen.details})
      for (size_t at = 0; (at = text->find(of_a)) != std::string::npos;)
        text->replace(at, of_a.size(), never);
    seen.metadata.clear();  // the metadata repeats the details
    return seen;
  };
  const std::vector<Seen> damaged = b_->SeeAllOf(of_a);
  const std::vector<Seen> none = b_->SeeAllOf(never);
  for (size_t i = 0; i < none.size(); ++i) {
    EXPECT_EQ(as_if(damaged[i]), as_if(none[i])) << i;
    EXPECT_EQ(damaged[i].reason(), Reason::kJobNotFound) << i;
  }
}

TEST_F(IsolationTest, ATenantMayHaveSoManyCallsAndJobsASecond) {
  Change([](Tenants& tenants) {
    tenants["a"].max_calls_per_second = 1;
    tenants["b"].max_jobs_per_second = 1;
  });
  Seen call = a_->SeeList();
  while (call.status().ok()) call = a_->SeeList();
  EXPECT_EQ(call.reason(), Reason::kOverloaded);
  EXPECT_EQ(DetailOf(call.status()).metadata["rate"], "calls");
  EXPECT_TRUE(DetailOf(call.status()).metadata.contains(rpc::kRetryAfterMs));
  ASSERT_TRUE(b_->Upload("xb").ok());
  absl::Status job = b_->Create(TenantClient::RequestFor("xb")).status();
  while (job.ok()) job = b_->Create(TenantClient::RequestFor("xb")).status();
  EXPECT_EQ(DetailOf(job).metadata["rate"], "jobs") << job;
  EXPECT_TRUE(DetailOf(job).metadata.contains(rpc::kRetryAfterMs));
  EXPECT_TRUE(b_->SeeList().status().ok()) << "calls have a rate of their own";
}

TEST_F(IsolationTest, AnothersResultIsNotTaken) {
  const std::string of_b = b_->Submit("xx");
  EXPECT_EQ(b_->AwaitEnd(of_b).state(), v1::JOB_STATE_SUCCEEDED);
  const v1::Job of_a = a_->AwaitEnd(a_->Submit("xx"));
  EXPECT_EQ(of_a.state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_FALSE(of_a.result().cached());
  EXPECT_EQ(slicing_.runs(), 2);
  EXPECT_TRUE(a_->AwaitEnd(a_->Submit("xx")).result().cached());
  EXPECT_EQ(slicing_.runs(), 2);
  // The result stays hidden after the own job is deleted, because the index stores its tenant.
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_FALSE(b_->AwaitEnd(b_->Submit("xx")).result().cached());
}

TEST_F(IsolationTest, AnothersRunningWorkIsNotWaitedFor) {
  ranges_->Hold();
  const std::string of_b = b_->Submit("xx");
  ranges_->AwaitCall();
  const std::string of_a = a_->Submit("xx");
  while (slicing_.runs() < 2) std::this_thread::yield();
  ranges_->LetGo();
  EXPECT_FALSE(a_->AwaitEnd(of_a).result().cached());
  EXPECT_FALSE(b_->AwaitEnd(of_b).result().cached());
}

TEST_F(IsolationTest, TenantsMayShareTheirResults) {
  Close();
  Open(ResultSharing::kOn);
  a_ = As("a-1");
  b_ = As("b-1");
  const std::string of_b = b_->Submit("xx");
  EXPECT_EQ(b_->AwaitEnd(of_b).state(), v1::JOB_STATE_SUCCEEDED);
  const std::string of_a = a_->Submit("xx");
  EXPECT_TRUE(a_->AwaitEnd(of_a).result().cached());
  EXPECT_EQ(slicing_.runs(), 1);
  EXPECT_TRUE(b_->SeeDelete(of_b).status().ok());
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
  EXPECT_EQ(a_->SeeUploadStatus(Sha256Hex("xy")).body, b_->SeeUploadStatus(Sha256Hex("xy")).body);

  // A shared result stays with the jobs that have it, but new jobs do not find it any more.
  Close();
  Open(ResultSharing::kOff);
  a_ = As("a-1");
  EXPECT_TRUE(a_->SeeDownload(of_a).status().ok());
  EXPECT_FALSE(a_->AwaitEnd(a_->Submit("xx")).result().cached());
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
  a_->Submit("xa");
  const Seen second = a_->SeeCreate(TenantClient::RequestFor("xa"));
  EXPECT_EQ(second.reason(), Reason::kQueueFull);
  EXPECT_EQ(DetailOf(second.status()).metadata.at("limit"), "1");
  b_->Submit("xb");
  b_->Submit("xbb");
}

TEST_F(IsolationTest, WhoHasNoTokenIsNobody) {
  const std::string of_a = a_->Submit("xa");
  for (const char* token : {"", "a-3", "a-1 ", "A-1"}) {
    const auto nobody = As(token);
    std::vector<Seen> all = nobody->SeeAllOf(of_a);
    all.push_back(nobody->SeeList());
    all.push_back(nobody->SeeBatch(TenantClient::RequestFor("xa")));
    all.push_back(nobody->SeePutProfile("pla"));
    all.push_back(nobody->SeeProfile("pla"));
    all.push_back(nobody->SeeProfiles());
    all.push_back(nobody->SeeDeleteProfile("pla"));
    all.push_back(nobody->SeeImportPresets("acme"));
    all.push_back(nobody->SeePresetBundle("acme"));
    all.push_back(nobody->SeeDeletePresets("acme"));
    all.push_back(nobody->SeePresets());
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
  const std::string of_a = a_->Submit("xa");
  a_->AwaitEnd(of_a);
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
  denied(reader->SeeDeleteProfile("pla"), "submit");
  denied(reader->SeeImportPresets("acme"), "submit");
  denied(reader->SeeDeletePresets("acme"), "submit");
  EXPECT_TRUE(reader->SeeProfiles().status().ok());
  denied(reader->SeeDelete(of_a), "submit");
  EXPECT_EQ(DetailOf(reader->Upload("xa").status()).reason, Reason::kPermissionDenied);
  // The answer is the same whether or not the job exists.
  EXPECT_EQ(reader->SeeDelete("0123456789abcdef0123456789abcdef"), reader->SeeDelete(of_a));

  Change([](Tenants& tenants) { tenants["a"].tokens[1].scopes = {Scope::kSubmit}; });
  denied(reader->SeeGet(of_a), "read");
  denied(reader->SeeWatch(of_a), "read");
  denied(reader->SeeDownload(of_a), "read");
  denied(reader->SeeList(), "read");
  denied(reader->SeeWebhook(of_a), "read");
  denied(reader->SeeProfiles(), "read");
  denied(reader->SeePresets(), "read");
  EXPECT_TRUE(reader->SeeDelete(of_a).status().ok());
}

TEST_F(IsolationTest, AdminsSeeAndCancelTheJobsOfAll) {
  const auto ops = As("ops-1");
  ranges_->Hold();
  const std::string of_a = a_->Submit("xa");
  const std::string of_b = b_->Submit("xb");
  EXPECT_THAT(ops->List(), testing::UnorderedElementsAre(of_a, of_b));
  EXPECT_EQ(ops->Get(of_a)->tenant(), "a");
  EXPECT_EQ(ops->Get(of_b)->tenant(), "b");
  EXPECT_TRUE(ops->SeeCancel(of_a).status().ok());
  ranges_->LetGo();
  EXPECT_EQ(a_->AwaitEnd(of_a).state(), v1::JOB_STATE_CANCELLED);
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
  const std::string of_a = a_->Submit("xa");
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
}  // namespace slicefarm::coordinator::isolation_test
