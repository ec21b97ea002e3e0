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

/// Number of server threads. Each call occupies one thread, uploads and downloads for a long time.
/// TransferOptions limits uploads and downloads and leaves enough threads for other calls.
/// CallLimits leaves some threads for other tenants.
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
        "--client-certs optional accepts tokens instead of certificates: add --tenants and "
        "--tls-cert");
  }
  const std::string& listen = flags.serve.server.listen;
  if (!flags.tenants_file.empty() && !tls && !rpc::IsLoopback(listen)) {
    throw CLI::ValidationError("--tenants needs --tls-cert: without it, tokens would be sent to " +
                               listen +
                               " in plain text, which is allowed on loopback addresses only");
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
    throw CLI::ValidationError("--beading, --infill and --ordering must be given together");
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
  options.sweep.min_use_s = sweep_after_hours * 3600;
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
    {Stage::kPlanning, "Addresses of planning services, host:port,...", true},
    {Stage::kMotion, "Addresses of motion services, host:port,...", true},
    {Stage::kBeading,
     "Addresses of beading services, host:port,...; with --infill and --ordering instead of "
     "--workers"},
    {Stage::kInfill, "Addresses of infill services, host:port,...; see --beading"},
    {Stage::kOrdering, "Addresses of ordering services, host:port,...; see --beading"},
    {Stage::kExposure,
     "Addresses of exposure services; without them, jobs that need exposure are refused"},
    {Stage::kMilling,
     "Addresses of milling services; without them, jobs that need milling are refused"},
    {Stage::kTexture,
     "Addresses of texture services; without them, jobs that need textures are refused"},
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
                 "Directory for the jobs and blobs of this coordinator; created if needed");
  auto* postgres = app.add_option("--postgres", flags->stores.postgres,
                                  "Connection string of a PostgreSQL database that several "
                                  "coordinators may share (instead of --state-dir)")
                       ->envname("SLICEFARM_POSTGRES");
  AddS3Flags(app, &flags->s3);
  app.add_option("--name", flags->runner.owner,
                 "Name of this coordinator: unique among the coordinators that share a database, "
                 "and the same after a restart")
      ->capture_default_str();
  app.add_option("--lease", flags->lease_s,
                 "Seconds after which other coordinators take over the jobs of a coordinator that "
                 "has stopped")
      ->check(CLI::Range(1.0, 600.0))
      ->capture_default_str();
  app.add_option("--spool", flags->spool_dir,
                 "Directory for the unfinished G-code of running jobs; default: in --state-dir, or "
                 "the system's directory for temporary files")
      ->check(CLI::ExistingDirectory);
  app.add_option("--keep-jobs", flags->keep_jobs_days,
                 "Days after which ended jobs are removed; 0: never")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--keep-blobs", flags->keep_blobs_hours,
                 "Hours after which meshes and results without a job are removed")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  app.add_option("--sweep-after", flags->sweep_after_hours,
                 "Hours after the start with a new or restored database in which no meshes and "
                 "results are removed")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  AddStageFlags(app, flags);
  app.add_option("--workers", flags->workers,
                 "Addresses of workers that run all stages of layers, host:port,...");
  app.add_option("--split-slots", flags->split_slots,
                 "Number of layer ranges that are computed at the same time, with --beading, "
                 "--infill and --ordering")
      ->check(CLI::Range(1, 1024))
      ->needs("--beading")
      ->capture_default_str();
  app.add_option("--jobs", flags->runner.jobs,
                 "Number of jobs that run at the same time; one more job may run if its priority "
                 "is INTERACTIVE")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option(
         "--guests", flags->runner.guests,
         "Number of jobs that may run in addition to --jobs, if their tenants have no running job")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--tenants", flags->tenants_file,
                 "JSON file of tenants, their tokens and permissions; without it, all clients are "
                 "one tenant")
      ->check(CLI::ExistingFile);
  app.add_flag("--share-cache", flags->share_cache,
               "Let tenants share cached results of the same work; a tenant can then find out that "
               "another tenant has sliced the same model");
  app.add_option("--client-certs", flags->serve.client_certs,
                 "Client certificates with TLS. required: each client needs one. optional: clients "
                 "may send a token instead")
      ->transform(CLI::CheckedTransformer(std::map<std::string, rpc::ClientCerts>{
          {"required", rpc::ClientCerts::kRequired}, {"optional", rpc::ClientCerts::kOptional}}))
      ->type_name("HOW");
  app.add_option("--min-free", flags->min_free_mib,
                 "Free MiB on the disk of --state-dir below which new data is refused")
      ->check(CLI::NonNegativeNumber)
      ->excludes(postgres)
      ->capture_default_str();
  app.add_option(
         "--max-database", flags->max_database_gib,
         "Size of the --postgres database in GiB above which new data is refused; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->needs(postgres)
      ->capture_default_str();
  app.add_option("--memory", flags->memory_mib,
                 "MiB of memory for the meshes, outlines and plans of all running jobs; default: "
                 "half the memory of the container or machine")
      ->check(CLI::Range(int64_t{64}, int64_t{1} << 30))
      ->type_name("MIB");
  app.add_option("--rates", flags->rates_file,
                 "JSON file of the farm's prices for machine time and material; with it, jobs "
                 "report their cost")
      ->check(CLI::ExistingFile);
  app.add_option("--default-profile", flags->default_profile,
                 "Profile for jobs that name no printer; without it, such jobs are refused. A "
                 "tenant's default_profile overrides it")
      ->type_name("NAME");
  app.add_option(
         "--webhooks", flags->webhooks_file,
         "JSON file of the URLs to which webhooks may be sent; without it, no webhooks are sent")
      ->check(CLI::ExistingFile);
  app.callback([flags] { Check(*flags); });
}

}  // namespace slicefarm::coordinator
