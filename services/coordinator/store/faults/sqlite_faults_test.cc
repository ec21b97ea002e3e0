// Tests of jobs in SQLite and blobs in a directory. Each of the disk calls fails, including
// SQLite's, and the power fails after each. Environment variables:
//
//   SLICEFARM_FAULT_ERRORS   number of errors that are tried at each call site (8);
//   SLICEFARM_FAULT_SEEDS    number of random choices of the state after a power cut (1);
//   SLICEFARM_FAULT_EVERY    interval of the power cuts, in changes (5).

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <map>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/from_environment_test.h"
#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/directory_blob_store.h"
#include "services/coordinator/store/faults/database_invariants_test.h"
#include "services/coordinator/store/faults/fault_trials_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/jobs/sql_profile_store.h"
#include "services/coordinator/store/sql/sqlite_database.h"
#include "services/coordinator/store/sql/sqlite_schema.h"

namespace slicefarm::coordinator::sqlite_faults_test {
namespace {

using enum JobState;

constexpr int64_t kLeaseUs = 100;

/// Makes SQLite copy its log into the database often. So a life of a few kilobytes includes
/// checkpoints and restarts of the log.
int CheckpointOften(sqlite3* db, const char**, const void*) {
  return sqlite3_wal_autocheckpoint(db, 20);
}

class FrequentCheckpoints : public testing::Environment {
 public:
  void SetUp() override { sqlite3_auto_extension(reinterpret_cast<void (*)()>(CheckpointOften)); }
};
[[maybe_unused]] const auto* const kFrequentCheckpoints =
    testing::AddGlobalTestEnvironment(new FrequentCheckpoints);

/// Stores of a coordinator in one directory.
struct State {
  std::unique_ptr<JobStore> jobs;
  std::unique_ptr<ProfileStore> profiles;
  std::unique_ptr<ProfileStore> bundles;
  std::unique_ptr<BlobStore> blobs;

  static absl::StatusOr<State> Open(const std::string& directory) {
    auto opened = SqliteDatabase::Open(directory + "/jobs.db");
    if (!opened.ok()) return opened.status();
    const std::shared_ptr<SqlDatabase> database = *std::move(opened);
    auto blobs = DirectoryBlobStore::OpenAt(directory);
    if (!blobs.ok()) return blobs.status();
    return State{std::make_unique<SqlJobStore>(database),
                 std::make_unique<SqlProfileStore>(database),
                 std::make_unique<SqlProfileStore>(database, kPresetTable), *std::move(blobs)};
  }
};

NewJob JobOf(const std::string& id, const std::string& mesh) {
  NewJob job;
  job.id = id;
  job.tenant = "tenant";
  job.request_id = "request " + id;
  job.spec = "spec of " + id;
  job.spec_digest = "spec " + id;
  job.labels = {{"order", "17"}, {"printer", id}};
  job.inputs = {mesh};
  job.settings_digest = "settings";
  job.action_digest = "action " + id;
  job.build_id = "build";
  return job;
}

/// State of a job at one time, for the check after a fault.
struct Version {
  size_t from = 0;                     ///< number of disk changes when the call began
  std::optional<size_t> acknowledged;  ///< empty: the call failed, and the change may exist or not
  std::optional<JobRecord> job;        ///< empty: the job was removed, or the call failed
  bool removes = false;
};

class StateLife : public StoreLife {
 public:
  StateLife(DiskCalls& disk, std::string directory)
      : disk_(disk), directory_(std::move(directory)) {}

  absl::Status Open() override {
    auto state = State::Open(directory_);
    if (!state.ok()) return state.status();
    state_ = *std::move(state);
    return absl::OkStatus();
  }
  void Close() override { state_ = {}; }

  std::vector<LifeStep> Steps() override {
    return {
        {"put a mesh", [&] { return PutBlob(mesh_); }},
        {"create a", [&] { return Create("a"); }},
        {"create b", [&] { return Create("b"); }},
        {"create a again", [&] { return Create("a"); }},
        {"claim a", [&] { return Claim("a"); }},
        {"run a", [&] { return Update("a", {.state = kRunning}); }},
        {"progress", [&] { return Update("a", {.layers_total = 9, .layers_done = 4}); }},
        {"renew", [&] { return Renew("a"); }},
        {"adopt", [&] { return Adopt("a"); }},
        {"end a", [&] { return Succeed("a"); }},
        {"cancel b", [&] { return Cancel("b"); }},
        {"put a profile", [&] { return PutProfile("settings 1"); }},
        {"import presets", [&] { return ImportPresets(std::string(30'000, 'p')); }},
        {"create c", [&] { return Create("c"); }},
        {"claim c", [&] { return Claim("c"); }},
        {"release", [&] { return Release("c"); }},
        {"open again", [&] { return Close(), Open(); }},
        {"put a revision", [&] { return PutProfile("settings 2"); }},
        {"import a revision", [&] { return ImportPresets(std::string(25'000, 'q')); }},
        {"claim c again", [&] { return Claim("c"); }},
        {"fail c", [&] { return Fail("c"); }},
        {"delete b", [&] { return Delete("b"); }},
        {"create d", [&] { return Create("d", std::string(20'000, 'x')); }},
        {"delete a", [&] { return Delete("a"); }},
        {"sweep", [&] { return Sweep(); }},
        {"claim d", [&] { return Claim("d"); }},
        {"end d", [&] { return Succeed("d"); }},
    };
  }

  std::vector<std::string> Check(const std::string& directory, size_t changes) const override {
    std::vector<std::string> wrong;
    auto state = State::Open(directory);
    if (!state.ok()) return {state.status().ToString()};
    for (const auto& [id, versions] : jobs_) {
      const std::string what = CheckJob(*state->jobs, id, versions, changes);
      if (!what.empty()) wrong.push_back(absl::StrCat("job ", id, " ", what));
    }
    CheckRevisions(*state->profiles, "pla", profiles_, changes, wrong);
    CheckRevisions(*state->bundles, "vendor", imported_, changes, wrong);
    CheckBlobs(*state, wrong);
    if (const absl::Status works = Work(*state); !works.ok()) wrong.push_back(works.ToString());
    *state = {};
    for (std::string& what : DatabaseContradictions(directory + "/jobs.db"))
      wrong.push_back(std::move(what));
    return wrong;
  }

 private:
  size_t now() const { return disk_.changes().size(); }

  // ---- Steps. The effect of a failed step may exist. A repeated step succeeds.

  absl::Status PutBlob(const std::string& bytes) { return state_.blobs->Put(bytes).status(); }

  /// Records the outcome of a call for job `id` that began at `from`.
  absl::Status Note(const std::string& id, size_t from, const absl::Status& status) {
    Version version;
    version.from = from;
    absl::Status noted = status;
    if (status.ok()) {
      version.acknowledged = now();
      const auto job = state_.jobs->Get(id);
      if (job.ok()) version.job = *job;
      if (!job.ok() && !absl::IsNotFound(job.status())) noted = job.status();
      if (!noted.ok()) version.acknowledged.reset();
    }
    jobs_[id].push_back(version);
    return noted;
  }

  absl::Status Create(const std::string& id, const std::string& spec = "") {
    const size_t from = now();
    NewJob job = JobOf(id, Sha256Hex(mesh_));
    job.spec += spec;
    return Note(id, from, state_.jobs->Create(job, 1000).status());
  }

  absl::Status Claim(const std::string& id) {
    const size_t from = now();
    now_us_ += 2 * kLeaseUs;  // lets a claim without an answer expire
    const auto job = state_.jobs->Claim("me", now_us_, now_us_ + kLeaseUs);
    if (job.ok() && (!*job || (*job)->id != id)) return absl::NotFoundError("no job");
    if (job.ok()) lease_ = {id, (*job)->owner_epoch};
    return Note(id, from, job.status());
  }

  absl::Status Update(const std::string& id, const JobUpdate& update) {
    const size_t from = now();
    absl::Status status = state_.jobs->Update(lease_, update, ++now_us_).status();
    if (absl::IsAborted(status)) {  // a call that reported an error has ended the job
      const auto job = state_.jobs->Get(id);
      if (job.ok() && IsTerminal(job->state) && job->state == update.state)
        status = absl::OkStatus();
      if (!job.ok()) status = job.status();
    }
    return Note(id, from, status);
  }

  absl::Status Renew(const std::string& id) {
    const size_t from = now();
    return Note(id, from, state_.jobs->Renew({lease_}, now_us_ + 2 * kLeaseUs).status());
  }
  absl::Status Adopt(const std::string& id) {
    const size_t from = now();
    return Note(id, from,
                state_.jobs->Adopt(lease_, {"settings", "action x", "build 2"}, now_us_).status());
  }
  absl::Status Release(const std::string& id) {
    const size_t from = now();
    return Note(id, from, state_.jobs->Release("me"));
  }
  absl::Status Cancel(const std::string& id) {
    const size_t from = now();
    return Note(id, from, state_.jobs->RequestCancel(id, ++now_us_).status());
  }
  absl::Status Delete(const std::string& id) {
    const size_t from = now();
    const absl::Status deleted = state_.jobs->Delete(id);
    const absl::Status noted =
        Note(id, from, absl::IsNotFound(deleted) ? absl::OkStatus() : deleted);
    jobs_[id].back().removes = true;
    return noted;
  }

  absl::Status Succeed(const std::string& id) {
    JobResult result;
    result.tenant = "tenant";
    for (std::string* digest : {&result.gcode_sha256, &result.report_sha256}) {
      const auto put = state_.blobs->Put(absl::StrCat("result of ", id, result.gcode_sha256));
      if (!put.ok()) return put.status();
      *digest = *put;
    }
    return Update(id, {.state = kSucceeded, .result = result});
  }
  absl::Status Fail(const std::string& id) {
    return Update(id, {.state = kFailed, .error = JobErrorOf(absl::InternalError("out of luck"))});
  }

  /// Removes blobs to which no job refers.
  absl::Status Sweep() {
    std::set<std::string> digests;
    absl::Status listed =
        state_.blobs->ForEach([&](const BlobEntry& blob) { digests.insert(blob.digest); });
    if (!listed.ok()) return listed;
    const auto referenced = state_.jobs->Referenced("tenant", digests);
    if (!referenced.ok()) return referenced.status();
    for (const std::string& digest : digests) {
      if (referenced->contains(digest)) continue;
      if (const auto done = state_.blobs->Delete(digest, 0); !done.ok()) return done.status();
    }
    if (absl::Status done = state_.jobs->ForgetResult("action none"); !done.ok()) return done;
    return state_.jobs->ExpireRequestIds(kRequestIdKeptUs);
  }

  absl::Status PutProfile(const std::string& settings) {
    const auto put = state_.profiles->Put({"tenant", "pla", settings, Sha256Hex(settings)}, 1);
    if (put.ok()) profiles_[settings] = {now(), put->revision};
    return put.status();
  }

  absl::Status ImportPresets(const std::string& files) {
    const auto put = state_.bundles->Put({"tenant", "vendor", files, Sha256Hex(files)}, 1);
    if (put.ok()) imported_[files] = {now(), put->revision};
    return put.status();
  }

  // ---- Checks of the promises.

  /// Returns an empty text if nothing is wrong with the job.
  static std::string CheckJob(JobStore& jobs, const std::string& id,
                              const std::vector<Version>& versions, size_t changes) {
    const auto job = jobs.Get(id);
    if (!job.ok() && !absl::IsNotFound(job.status())) return job.status().ToString();
    std::optional<JobRecord> here;
    if (job.ok()) here = *job;
    std::optional<JobRecord> promised;
    const Version* in_flight = nullptr;  // version of a call without an answer
    for (const Version& version : versions) {
      if (version.from > changes) break;
      const bool answered = version.acknowledged && *version.acknowledged <= changes;
      in_flight = answered ? nullptr : &version;
      if (answered) promised = version.job;
    }
    if (here == promised) return "";
    if (!here) return in_flight != nullptr && in_flight->removes ? "" : "is gone";
    if (in_flight != nullptr && (!promised || here->last_sequence >= promised->last_sequence)) {
      return "";
    }
    if (!promised) return "is there again";
    return absl::StrCat("is as it was after event ", here->last_sequence, ", promised was ",
                        promised->last_sequence);
  }

  /// Revisions by content: the number of disk changes at the acknowledgement, and the number of the
  /// revision.
  using Promised = std::map<std::string, std::pair<size_t, int64_t>>;

  static void CheckRevisions(ProfileStore& profiles, const std::string& name,
                             const Promised& promised, size_t changes,
                             std::vector<std::string>& wrong) {
    for (const auto& [settings, promise] : promised) {
      const auto& [acknowledged, revision] = promise;
      if (acknowledged > changes) continue;
      const auto profile = profiles.Get("tenant", name, revision);
      if (!profile.ok() || profile->settings != settings) {
        wrong.push_back(
            absl::StrCat(name, " revision ", revision, ": ", profile.status().ToString()));
      }
    }
  }

  /// Checks that all blobs exist to which a job refers, acknowledged or not.
  static void CheckBlobs(State& state, std::vector<std::string>& wrong) {
    const auto jobs = state.jobs->List({.tenant = "tenant"});
    if (!jobs.ok()) return wrong.push_back(jobs.status().ToString());
    for (const JobRecord& job : *jobs) {
      std::vector<std::string> digests = {Sha256Hex(mesh_)};
      if (job.result) digests.push_back(job.result->gcode_sha256);
      if (job.result) digests.push_back(job.result->report_sha256);
      for (const std::string& digest : digests) {
        const auto got = state.blobs->Get(digest);
        if (!got.ok())
          wrong.push_back(absl::StrCat("of job ", job.id, " ", got.status().ToString()));
      }
    }
  }

  /// Creates a job and runs it to its end.
  static absl::Status Work(State& state) {
    const auto mesh = state.blobs->Put(mesh_);
    if (!mesh.ok()) return mesh.status();
    NewJob job = JobOf("new", *mesh);
    job.priority = Priority::kInteractive;
    const auto created = state.jobs->Create(job, 1000);
    if (!created.ok()) return created.status();
    constexpr int64_t kLater = 1'000'000'000;
    const auto claimed = state.jobs->Claim("you", kLater, kLater + kLeaseUs);
    if (!claimed.ok()) return claimed.status();
    // After the second of two power cuts, an earlier check may have ended the job.
    if (!*claimed || (*claimed)->id != "new") return absl::OkStatus();
    return state.jobs->Update({"new", (*claimed)->owner_epoch}, {.state = kCancelled}, kLater)
        .status();
  }

  static inline const std::string mesh_ = std::string(3000, 'm');
  DiskCalls& disk_;
  const std::string directory_;
  State state_;
  int64_t now_us_ = 10'000;
  Lease lease_;
  std::map<std::string, std::vector<Version>> jobs_;
  Promised profiles_;
  Promised imported_;
};

TrialOptions Options() {
  return {.life =
              [](DiskCalls& disk, const std::string& directory) {
                return std::make_unique<StateLife>(disk, directory);
              },
          .prepare =
              [](const std::string& directory) {
                DiskCalls quiet(directory);
                ASSERT_TRUE(State::Open(directory).ok());
              }};
}

TEST(SqliteFaults, ErrorsAreToldAndSeenTo) {
  TrialOptions options = Options();
  options.errors_a_site = FromEnvironment("SLICEFARM_FAULT_ERRORS", 8);
  ExpectErrorsAreSeenTo(options);
}

TEST(SqliteFaults, APowerCutLosesNothingThatWasPromised) {
  TrialOptions options = Options();
  options.cut_every = FromEnvironment("SLICEFARM_FAULT_EVERY", 5);
  ExpectPowerCutsAreSurvived(options, FromEnvironment("SLICEFARM_FAULT_SEEDS", 1));
}

TEST(SqliteFaults, AnUnsyncedFileIsNoticed) {
  TrialOptions options = Options();
  options.cut_every = 5;
  ExpectNoticed(Lie::kFiles, options);
}

TEST(SqliteFaults, AnUnsyncedDirectoryIsNoticed) {
  TrialOptions options = Options();
  options.cut_every = 5;
  ExpectNoticed(Lie::kDirectories, options);
}

}  // namespace
}  // namespace slicefarm::coordinator::sqlite_faults_test
