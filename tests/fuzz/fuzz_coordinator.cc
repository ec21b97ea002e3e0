#include <grpcpp/grpcpp.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "common/rpc/server/call_queue.h"
#include "common/wire/support/mesh_wire.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/dispatch/fleet.h"
#include "services/coordinator/server/execution/fake_stages_test.h"
#include "services/coordinator/server/main/coordinator.h"
#include "services/coordinator/store/sql/sqlite_connection.h"
#include "slicefarm/v1/jobs.grpc.pb.h"
#include "slicefarm/v1/presets.grpc.pb.h"
#include "slicefarm/v1/profiles.grpc.pb.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

// Fuzzes calls to the coordinator's public services, as they arrive over a wire, with real stores
// and stages that take no time. Each accepted job runs to its end: its tasks are made, its program
// is assembled with templates and substitutions, and its result is read.

namespace slicefarm::fuzz {
namespace {

namespace fs = std::filesystem;

/// Aborts unless the condition holds. `line`: line of the caller.
void Expect(bool holds, int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "fuzz_coordinator.cc:%d does not hold\n", line);
  std::abort();
}

std::string NewDirectory() {
  std::string path = fs::is_directory("/dev/shm") ? "/dev/shm/" : "/tmp/";
  path += "fuzz_coordinator-XXXXXX";
  Expect(mkdtemp(path.data()) != nullptr);
  return path;
}

class Farm {
 public:
  Farm() {
    coordinator::CoordinatorOptions options;
    options.stores.state_dir = directory_;
    options.build_id = "fuzz";
    options.runner.owner = "fuzz";
    options.runner.jobs = 2;
    options.runner.poll = std::chrono::milliseconds(20);
    fleet_.Join({.name = "fuzz", .tasks = ranges_, .slots = 2});
    auto opened = coordinator::Coordinator::Open(
        options,
        {{.slicing = &slicing_, .planning = &planning_, .motion = &motion_}, arranging_, projects_},
        dispatcher_, rpc::JsonLog("fuzz"));
    Expect(opened.ok());
    coordinator_ = *std::move(opened);
    // A real socket is needed, because gRPC's in-process transport hangs if a server refuses a
    // message that a client still sends.
    const std::string address = "unix:" + directory_ + "/socket";
    grpc::ServerBuilder builder;
    builder.AddListeningPort(address, grpc::InsecureServerCredentials());
    for (grpc::Service* service : coordinator_->services()) builder.RegisterService(service);
    queue_ = std::make_unique<rpc::CallQueue>(builder);
    server_ = builder.BuildAndStart();
    coordinator_->queued_methods().ServeFrom(queue_->queue());
    Expect(server_ != nullptr);
    const auto channel = grpc::CreateChannel(address, grpc::InsecureChannelCredentials());
    meshes_ = v1::Meshes::NewStub(channel);
    jobs_ = v1::Jobs::NewStub(channel);
    profiles_ = v1::Profiles::NewStub(channel);
    presets_ = v1::Presets::NewStub(channel);
    database_ = *coordinator::SqliteConnection::Open(directory_ + "/jobs.db");
    Expect(coordinator_->Start().ok());
  }
  ~Farm() {
    coordinator_->Stop();
    server_->Shutdown();
    queue_.reset();
    fs::remove_all(directory_);
  }

  void Call(const CoordinatorCall& call);

  /// Waits for the ends of all jobs, from single calls and from batches.
  void AwaitEnds();

  /// Restores the state before the first call. REQUIRES: AwaitEnds.
  void Clear() {
    Expect(database_
               ->Execute("DELETE FROM jobs; DELETE FROM requests; DELETE FROM results;"
                         "DELETE FROM profiles; DELETE FROM presets; DELETE FROM tenants; DELETE "
                         "FROM sqlite_sequence")
               .ok());
    created_.clear();
    if (!uploaded_) return;
    uploaded_ = false;
    for (const char* part : {"/blobs", "/uploads", "/corrupt"}) {
      for (const auto& entry : fs::recursive_directory_iterator(directory_ + part))
        if (entry.is_regular_file()) fs::remove(entry.path());
    }
  }

 private:
  /// Checks that a refused call has a reason: no call ends as UNKNOWN or with an internal error.
  static bool Ends(const grpc::Status& status, int line = __builtin_LINE()) {
    Expect(status.error_code() != grpc::StatusCode::UNKNOWN, line);
    Expect(status.error_code() != grpc::StatusCode::INTERNAL, line);
    return status.ok();
  }

  /// Makes a call. Returns true if it succeeded.
  template <typename Stub, typename Request, typename Response>
  static bool Make(Stub& stub,
                   grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                   const Request& request, Response* response, int line = __builtin_LINE()) {
    grpc::ClientContext context;
    return Ends((stub.*method)(&context, request, response), line);
  }
  template <typename Stub, typename Request, typename Response>
  static bool Make(Stub& stub,
                   grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                   const Request& request, int line = __builtin_LINE()) {
    Response response;
    return Make(stub, method, request, &response, line);
  }

  void Upload(const fuzz::Upload& upload);
  void Create(const v1::CreateJobRequest& request);
  void BatchCreate(const v1::BatchCreateJobsRequest& request);
  void CreatePlates(const v1::CreatePlatesRequest& request);
  void Watch(const v1::WatchJobRequest& request);
  void Download(const v1::DownloadRequest& request);
  void PutProfile(const v1::PutProfileRequest& request);
  void ImportPresets(const v1::ImportPresetsRequest& request);
  void AwaitEnd(const std::string& id);

  const std::string directory_ = NewDirectory();
  coordinator::FakeSlicing slicing_;
  coordinator::FakeArranging arranging_;
  coordinator::FakeProjects projects_;
  coordinator::FakePlanning planning_;
  coordinator::FakeMotion motion_;
  std::shared_ptr<coordinator::FakeRanges> ranges_ = std::make_shared<coordinator::FakeRanges>();
  coordinator::Dispatcher dispatcher_;
  coordinator::Fleet fleet_{dispatcher_};
  std::unique_ptr<coordinator::Coordinator> coordinator_;
  std::unique_ptr<rpc::CallQueue> queue_;
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<v1::Meshes::Stub> meshes_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Profiles::Stub> profiles_;
  std::unique_ptr<v1::Presets::Stub> presets_;
  std::unique_ptr<coordinator::SqliteConnection> database_;
  std::set<std::string> created_;  // ids of jobs
  bool uploaded_ = false;
};

void Farm::Upload(const fuzz::Upload& upload) {
  grpc::ClientContext context;
  v1::Upload response;
  const auto stream = meshes_->UploadMesh(&context, &response);
  for (const v1::UploadMeshRequest& request : upload.requests())
    if (!stream->Write(request)) break;
  stream->WritesDone();
  uploaded_ = true;
  Ends(stream->Finish());
}

/// Creates a job. An accepted job must be stored as it was first sent.
void Farm::Create(const v1::CreateJobRequest& request) {
  for (const v1::Object& object : request.spec().objects()) CheckRoundTrip(object.placement());
  v1::Job job;
  if (!Make(*jobs_, &v1::Jobs::Stub::CreateJob, request, &job) || request.validate_only()) return;
  if (!created_.insert(job.id()).second) return;
  v1::GetJobRequest get;
  get.set_id(job.id());
  v1::Job kept;
  Expect(Make(*jobs_, &v1::Jobs::Stub::GetJob, get, &kept));
  Expect(kept.labels_size() == request.labels_size());
  for (const auto& [key, value] : request.labels()) {
    const auto found = kept.labels().find(key);
    Expect(found != kept.labels().end() && found->second == value);
  }
  // The settings of profiles and presets are added to the job.
  if (request.spec().profiles_size() == 0 && !request.spec().has_presets()) {
    Expect(kept.spec().SerializeAsString() == request.spec().SerializeAsString());
  }
  v1::ListJobsRequest list;
  list.mutable_labels()->insert(request.labels().begin(), request.labels().end());
  v1::ListJobsResponse listed;
  Expect(Make(*jobs_, &v1::Jobs::Stub::ListJobs, list, &listed) && listed.jobs_size() > 0);
}

void Farm::Watch(const v1::WatchJobRequest& request) {
  grpc::ClientContext context;
  const auto stream = jobs_->WatchJob(&context, request);
  v1::JobEvent event;
  stream->Read(&event);  // one event only: a running job may send events forever
  context.TryCancel();
  Ends(stream->Finish());
}

void Farm::Download(const v1::DownloadRequest& request) {
  grpc::ClientContext context;
  const auto stream = jobs_->Download(&context, request);
  v1::DownloadResponse response;
  while (stream->Read(&response)) {
  }
  Ends(stream->Finish());
}

void Farm::PutProfile(const v1::PutProfileRequest& request) {
  if (!Make(*profiles_, &v1::Profiles::Stub::PutProfile, request)) return;
  v1::GetProfileRequest get;
  get.set_name(request.name());
  v1::Profile kept;
  Expect(Make(*profiles_, &v1::Profiles::Stub::GetProfile, get, &kept));
  Expect(kept.settings_size() == request.settings_size());
  for (int i = 0; i < request.settings_size(); ++i)
    Expect(kept.settings(i).SerializeAsString() == request.settings(i).SerializeAsString());
}

void Farm::ImportPresets(const v1::ImportPresetsRequest& request) {
  v1::PresetBundle made;
  if (!Make(*presets_, &v1::Presets::Stub::ImportPresets, request, &made)) return;
  v1::GetPresetBundleRequest get;
  get.set_name(request.name());
  v1::PresetBundle kept;
  Expect(Make(*presets_, &v1::Presets::Stub::GetPresetBundle, get, &kept));
  Expect(kept.revision() == made.revision() && kept.files_size() == request.files_size());
  for (int i = 0; i < request.files_size(); ++i)
    Expect(kept.files(i).content() == request.files(i).content());
}

void Farm::BatchCreate(const v1::BatchCreateJobsRequest& request) {
  v1::BatchCreateJobsResponse response;
  if (!Make(*jobs_, &v1::Jobs::Stub::BatchCreateJobs, request, &response)) return;
  Expect(response.outcomes_size() == request.requests_size());
  for (const auto& outcome : response.outcomes())
    if (outcome.has_job()) created_.insert(outcome.job().id());
}

/// Waits for the end of a job. A job that returns to the queue because its stages fail is cancelled
/// after some time, because it would wait longer each time.
void Farm::AwaitEnd(const std::string& id) {
  for (const bool cancelled : {false, true}) {
    if (cancelled) {
      v1::CancelJobRequest cancel;
      cancel.set_id(id);
      if (!Make(*jobs_, &v1::Jobs::Stub::CancelJob, cancel)) return;  // the job was deleted
    }
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() +
                         std::chrono::seconds(cancelled ? 60 : 2));
    v1::WatchJobRequest watch;
    watch.set_id(id);
    const auto stream = jobs_->WatchJob(&context, watch);
    v1::JobEvent event;
    while (stream->Read(&event)) {
    }
    const grpc::Status ended = stream->Finish();
    if (ended.error_code() != grpc::StatusCode::DEADLINE_EXCEEDED) {
      Ends(ended);
      if (event.job().state() != v1::JOB_STATE_SUCCEEDED) return;
      v1::DownloadRequest download;
      download.set_id(id);
      download.set_artifact(v1::ARTIFACT_REPORT);
      return Download(download);
    }
    Expect(!cancelled);
  }
}

void Farm::AwaitEnds() {
  for (const std::string& id : created_) AwaitEnd(id);
}

/// Creates jobs of several plates. The server must store all of them, or none.
void Farm::CreatePlates(const v1::CreatePlatesRequest& request) {
  v1::CreatePlatesResponse response;
  if (!Make(*jobs_, &v1::Jobs::Stub::CreatePlates, request, &response)) return;
  Expect(response.jobs_size() >= request.requests_size());
  for (const v1::Job& job : response.jobs()) {
    Expect(job.id().empty() == request.validate_only());
    if (request.validate_only()) continue;
    created_.insert(job.id());
    v1::GetJobRequest get;
    get.set_id(job.id());
    Expect(Make(*jobs_, &v1::Jobs::Stub::GetJob, get));
  }
}

void Farm::Call(const CoordinatorCall& call) {
  using Meshes = v1::Meshes::Stub;
  using Jobs = v1::Jobs::Stub;
  using Profiles = v1::Profiles::Stub;
  using Presets = v1::Presets::Stub;
  switch (call.call_case()) {
    case CoordinatorCall::kGetUpload:
      return (void)Make(*meshes_, &Meshes::GetUpload, call.get_upload());
    case CoordinatorCall::kUpload:
      return Upload(call.upload());
    case CoordinatorCall::kCreateJob:
      return Create(call.create_job());
    case CoordinatorCall::kBatchCreateJobs:
      return BatchCreate(call.batch_create_jobs());
    case CoordinatorCall::kCreatePlates:
      return CreatePlates(call.create_plates());
    case CoordinatorCall::kGetJob:
      return (void)Make(*jobs_, &Jobs::GetJob, call.get_job());
    case CoordinatorCall::kListJobs:
      return (void)Make(*jobs_, &Jobs::ListJobs, call.list_jobs());
    case CoordinatorCall::kWatchJob:
      return Watch(call.watch_job());
    case CoordinatorCall::kCancelJob:
      return (void)Make(*jobs_, &Jobs::CancelJob, call.cancel_job());
    case CoordinatorCall::kDeleteJob:
      return (void)Make(*jobs_, &Jobs::DeleteJob, call.delete_job());
    case CoordinatorCall::kGetWebhook:
      return (void)Make(*jobs_, &Jobs::GetWebhook, call.get_webhook());
    case CoordinatorCall::kDownload:
      return Download(call.download());
    case CoordinatorCall::kPutProfile:
      return PutProfile(call.put_profile());
    case CoordinatorCall::kGetProfile:
      return (void)Make(*profiles_, &Profiles::GetProfile, call.get_profile());
    case CoordinatorCall::kListProfiles:
      return (void)Make(*profiles_, &Profiles::ListProfiles, call.list_profiles());
    case CoordinatorCall::kDeleteProfile:
      return (void)Make(*profiles_, &Profiles::DeleteProfile, call.delete_profile());
    case CoordinatorCall::kImportPresets:
      return ImportPresets(call.import_presets());
    case CoordinatorCall::kListPresets:
      return (void)Make(*presets_, &Presets::ListPresets, call.list_presets());
    case CoordinatorCall::kResolvePresets:
      return (void)Make(*presets_, &Presets::ResolvePresets, call.resolve_presets());
    case CoordinatorCall::kDeletePresetBundle:
      return (void)Make(*presets_, &Presets::DeletePresetBundle, call.delete_preset_bundle());
    case CoordinatorCall::CALL_NOT_SET:
      return;
  }
}

void Run(const CoordinatorCalls& calls) {
  static Farm farm;
  for (const CoordinatorCall& call : calls.calls()) farm.Call(call);
  farm.AwaitEnds();
  farm.Clear();
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::CoordinatorCalls, slicefarm::fuzz::Run)
