#include "services/coordinator/server/main/coordinator_flags.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>

#include "common/model/limits.h"
#include "common/rpc/address/listen_address.h"
#include "services/coordinator/remote/address_watch.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/transfers.h"

namespace slicefarm::coordinator {
namespace {

/// Number of server threads. Each call occupies one. Uploads and downloads do so for long:
/// TransferOptions limits them and leaves enough threads for other calls. CallLimits leaves some
/// threads for other tenants.
constexpr int kThreads = 512;
constexpr TransferOptions kTransfers;
constexpr CallLimits kCalls;
static_assert(2 * kTransfers.slots <= kCalls.calls / 3);
/// The remaining threads refuse calls, because gRPC's own refusal contains no time for a retry.
static_assert(kCalls.calls + 32 <= kThreads);

/// Limit for one connection, so that a single connection cannot occupy all threads.
constexpr int kStreamsPerConnection = 128;
/// Age after which connections are closed. So clients of a name with several addresses find new
/// coordinators within this time.
constexpr std::chrono::minutes kConnectionAge{10};

/// Returns the host name, which is unique for a container.
std::string DefaultName() {
  std::array<char, 256> host = {};
  gethostname(host.data(), host.size() - 1);
  return host.data();
}

void CheckSecurity(const CoordinatorFlags& flags) {
  const bool tls = flags.serve.tls.enabled();
  const bool optional = flags.serve.client_certs == rpc::ClientCerts::kOptional;
  if (optional && (!tls || flags.tenants_file.empty())) {
    throw CLI::ValidationError(
        "--client-certs optional takes tokens instead: it needs --tenants and --tls-cert");
  }
  const std::string& listen = flags.serve.server.listen;
  if (!flags.tenants_file.empty() && !tls && !rpc::IsLoopback(listen)) {
    throw CLI::ValidationError("--tenants without --tls-cert: tokens would come to " + listen +
                               " in plain text, which is for loopback addresses only");
  }
}

void Check(const CoordinatorFlags& flags) {
  CheckSecurity(flags);
  if (flags.stores.state_dir.empty() == flags.stores.postgres.empty()) {
    throw CLI::ValidationError("one of --state-dir and --postgres is needed");
  }
  constexpr Stage kOfLayers[] = {Stage::kBeading, Stage::kInfill, Stage::kOrdering};
  const auto there = [&](Stage stage) { return flags.Has(stage); };
  const bool all = std::ranges::all_of(kOfLayers, there);
  const bool any = std::ranges::any_of(kOfLayers, there);
  if (any && !all) {
    throw CLI::ValidationError("--beading, --infill and --ordering go together");
  }
  if (!any && flags.workers.empty()) {
    throw CLI::ValidationError("either --workers or --beading, --infill and --ordering is needed");
  }
}

}  // namespace

Maintenance::Options CoordinatorFlags::maintenance() const {
  Maintenance::Options options;
  options.sweep.keep_jobs_s = keep_jobs_days * 24 * 3600;
  options.sweep.keep_blobs_s = keep_blobs_hours * 3600;
  options.sweep.settle_s = sweep_after_hours * 3600;
  return options;
}

std::chrono::milliseconds CoordinatorFlags::drain_of_jobs() const {
  constexpr std::chrono::milliseconds kHandBack{5'000};
  const std::chrono::milliseconds drain = std::chrono::seconds(serve.drain_s);
  return std::max(std::chrono::milliseconds(0), drain - kHandBack);
}

JobRunnerOptions CoordinatorFlags::runner_options() const {
  using std::chrono::milliseconds;
  JobRunnerOptions options = runner;
  options.lease = milliseconds(static_cast<int64_t>(lease_s * 1000));
  options.renew = options.lease * 3 / 10;
  options.poll = options.lease / 10;
  return options;
}

std::map<Stage, std::vector<std::string>> CoordinatorFlags::stage_names() const {
  std::map<Stage, std::vector<std::string>> names;
  for (const auto& [stage, addresses] : stages)
    if (!addresses.empty()) names[stage] = SplitAddresses(addresses);
  return names;
}

namespace {

/// Option with the addresses of a stage's services.
struct StageFlag {
  Stage stage;
  std::string_view doc;
  bool required = false;
};

constexpr StageFlag kStageFlags[] = {
    {Stage::kSlicing, "Addresses of slicing services, host:port,...", true},
    {Stage::kPlanning, "Addresses of planning services", true},
    {Stage::kMotion, "Addresses of motion services", true},
    {Stage::kBeading, "Addresses of beading services, for split stages"},
    {Stage::kInfill, "Addresses of infill services"},
    {Stage::kOrdering, "Addresses of ordering services"},
    {Stage::kExposure, "Addresses of exposure services; without, no jobs that need it are made"},
    {Stage::kMilling, "Addresses of milling services; without, no jobs that need it are made"},
    {Stage::kTexture, "Addresses of texture services; without, no jobs that need it are made"},
};
static_assert(std::size(kStageFlags) == kStageCount - 1, "all but placing, which slicing does");

void AddStageFlags(CLI::App& app, CoordinatorFlags* flags) {
  for (const StageFlag& flag : kStageFlags)
    app.add_option("--" + std::string(StageName(flag.stage)), flags->stages[flag.stage],
                   std::string(flag.doc))
        ->required(flag.required);
}

}  // namespace

void AddCoordinatorFlags(CLI::App& app, CoordinatorFlags* flags) {
  flags->runner.owner = DefaultName();
  flags->serve.policy = rpc::OpenPolicy();  // the services check the permissions of each tenant
  flags->serve.server.max_message_bytes = limits::kMaxPublicMessageBytes;
  flags->serve.server.max_threads = kThreads;
  flags->serve.server.max_streams_per_connection = kStreamsPerConnection;
  flags->serve.server.max_connection_age = kConnectionAge;
  AddServeFlags(app, &flags->serve);
  app.add_option("--state-dir", flags->stores.state_dir,
                 "Directory for jobs and blobs, of this coordinator alone; made if needed");
  auto* postgres =
      app.add_option("--postgres", flags->stores.postgres,
                     "Or a PostgreSQL database, which coordinators share: its connection string")
          ->envname("SLICEFARM_POSTGRES");
  AddS3Flags(app, &flags->s3);
  app.add_option("--name", flags->runner.owner,
                 "Of this coordinator among those that share a database; the same after a restart")
      ->capture_default_str();
  app.add_option("--lease", flags->lease_s,
                 "Seconds after which other coordinators take over from one that is silent")
      ->check(CLI::Range(1.0, 600.0))
      ->capture_default_str();
  app.add_option("--spool", flags->spool_dir,
                 "Directory for the programs of running jobs while they are made; default: in "
                 "--state-dir, or where the system has temporary files")
      ->check(CLI::ExistingDirectory);
  app.add_option("--keep-jobs", flags->keep_jobs_days,
                 "Days after which ended jobs are removed; 0: never")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--keep-blobs", flags->keep_blobs_hours,
                 "Hours for which meshes and results that no job refers to are kept")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  app.add_option(
         "--sweep-after", flags->sweep_after_hours,
         "Hours for which nothing is removed after the start with a new or restored database")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  AddStageFlags(app, flags);
  app.add_option("--workers", flags->workers, "Addresses of fused workers");
  app.add_option("--split-slots", flags->split_slots,
                 "Layer ranges in flight over the split stages")
      ->check(CLI::Range(1, 1024))
      ->needs("--beading")
      ->capture_default_str();
  app.add_option("--jobs", flags->runner.jobs,
                 "Jobs that run at the same time; one more if it is INTERACTIVE")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--guests", flags->runner.guests,
                 "Jobs that run beyond --jobs, each of a tenant none of whose jobs runs")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--tenants", flags->tenants_file,
                 "JSON file of tenants, their tokens and what they may; without, all are one")
      ->check(CLI::ExistingFile);
  app.add_flag("--share-cache", flags->share_cache,
               "Tenants take each other's results for the same work, and may so learn of it");
  app.add_option("--client-certs", flags->serve.client_certs,
                 "With TLS, whether clients must show a certificate: required or optional")
      ->transform(CLI::CheckedTransformer(std::map<std::string, rpc::ClientCerts>{
          {"required", rpc::ClientCerts::kRequired}, {"optional", rpc::ClientCerts::kOptional}}))
      ->type_name("HOW");
  app.add_option("--min-free", flags->min_free_mib,
                 "MiB of --state-dir's disk below which nothing new is taken")
      ->check(CLI::NonNegativeNumber)
      ->excludes(postgres)
      ->capture_default_str();
  app.add_option("--max-database", flags->max_database_gib,
                 "GiB of --postgres's database above which nothing new is taken; 0: any number")
      ->check(CLI::NonNegativeNumber)
      ->needs(postgres)
      ->capture_default_str();
  app.add_option(
         "--memory", flags->memory_mib,
         "MiB that the meshes, outlines and plans of all running jobs may take; default: half "
         "of what the container or the machine has")
      ->check(CLI::Range(int64_t{64}, int64_t{1} << 30))
      ->type_name("MIB");
  app.add_option("--rates", flags->rates_file,
                 "JSON file of what the farm charges: jobs then tell what they cost")
      ->check(CLI::ExistingFile);
  app.add_option("--default-profile", flags->default_profile,
                 "The profile of jobs that name no printer; without, they are refused. A tenant's "
                 "default_profile wins")
      ->type_name("NAME");
  app.add_option("--webhooks", flags->webhooks_file,
                 "JSON file of where webhooks may go; without, none are sent")
      ->check(CLI::ExistingFile);
  app.callback([flags] { Check(*flags); });
}

}  // namespace slicefarm::coordinator
