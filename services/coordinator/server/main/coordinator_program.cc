#include "services/coordinator/server/main/coordinator_program.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/build_info.h"
#include "common/rpc/security/identity.h"
#include "common/rpc/server/serve.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/remote/remote_slicing.h"
#include "services/coordinator/remote/stage_pool.h"
#include "services/coordinator/remote/worker_pool.h"
#include "services/coordinator/server/api/audit_log.h"
#include "services/coordinator/server/execution/stage_pools.h"
#include "services/coordinator/server/main/coordinator.h"
#include "services/coordinator/server/main/coordinator_flags.h"
#include "services/coordinator/server/main/migrate.h"
#include "services/coordinator/server/main/move_blobs.h"
#include "services/coordinator/server/main/rates_file.h"
#include "services/coordinator/server/main/s3_flags.h"
#include "services/coordinator/server/observe/coordinator_metrics.h"
#include "services/coordinator/server/observe/status_board.h"
#include "services/coordinator/server/reloaded_file.h"

namespace slicefarm::coordinator {
namespace {

/// Opens a file that is read again when it changes. Does nothing without a path. Returns false if
/// the file cannot be used; the log then has the reason.
template <typename Content>
bool OpenReloaded(const std::string& path, const std::string& name,
                  typename ReloadedFile<Content>::Parse parse, rpc::ServerProgram& program,
                  std::unique_ptr<ReloadedFile<Content>>& file) {
  if (path.empty()) return true;
  auto opened = ReloadedFile<Content>::Open(path, name, std::move(parse),
                                            program.metrics().registry(), program.log());
  if (opened.ok()) {
    file = *std::move(opened);
    return true;
  }
  program.log().Error("cannot use the " + name,
                      {{"error", std::string(opened.status().message())}});
  return false;
}

/// Returns a function for the current credentials of the bucket. They come from the file, or else
/// from the environment, and live as long as a caller holds them.
absl::StatusOr<S3CredentialsNow> CredentialsNow(
    const std::unique_ptr<ReloadedFile<S3Credentials>>& file) {
  if (file != nullptr) return [&file = *file] { return file.Get(); };
  const auto credentials = S3CredentialsOfEnvironment();
  if (!credentials.ok()) return credentials.status();
  return [shared = std::make_shared<const S3Credentials>(*credentials)] { return shared; };
}

/// Opens the bucket. Without a bucket, blobs are stored with the other state. Returns false if it
/// cannot be used; the log then has the reason.
bool OpenBucket(const S3Flags& flags, rpc::ServerProgram& program,
                std::unique_ptr<ReloadedFile<S3Credentials>>& file,
                std::shared_ptr<S3Client>& bucket) {
  if (flags.url.empty()) return true;
  if (!OpenReloaded(flags.credentials_file, "s3", ParseS3Credentials, program, file)) return false;
  const auto credentials = CredentialsNow(file);
  auto client = credentials.ok() ? MakeS3Client(flags, *credentials) : credentials.status();
  if (client.ok()) {
    bucket = *std::move(client);
    return true;
  }
  program.log().Error("cannot use the bucket", {{"error", std::string(client.status().message())}});
  return false;
}

std::string StoreName(const CoordinatorFlags& flags) {
  const std::string jobs = flags.stores.postgres.empty() ? "SQLite" : "PostgreSQL";
  return flags.s3.url.empty() ? jobs : jobs + ", blobs in S3";
}

constexpr std::chrono::seconds kAskStoreEvery{1};

/// Opens the coordinator, and waits for a store that is unavailable, because the store may start at
/// the same time or later. Errors: errors of Coordinator::Open except Unavailable; Cancelled if a
/// signal to end came first.
absl::StatusOr<std::unique_ptr<Coordinator>> OpenPatiently(const CoordinatorOptions& options,
                                                           const JobStages& stages,
                                                           TaskExecutor& executor,
                                                           const rpc::ServerProgram& program) {
  while (true) {
    auto coordinator = Coordinator::Open(options, stages, executor, program.log());
    if (!absl::IsUnavailable(coordinator.status()) || options.stores.postgres.empty())
      return coordinator;
    program.log().Warn("the store cannot be reached: waiting for it",
                       {{"error", std::string(coordinator.status().message())}});
    if (program.EndsWithin(kAskStoreEvery)) return absl::CancelledError("ended by a signal");
  }
}

int Run(rpc::ServerProgram& program, const CoordinatorFlags& flags) {
  std::shared_ptr<const rpc::Tls> tls;
  if (flags.serve.tls.enabled()) {
    auto opened = rpc::Tls::Open(flags.serve.tls);
    if (!opened.ok()) {
      program.log().Error("cannot serve", {{"error", std::string(opened.status().message())}});
      return 1;
    }
    tls = *std::move(opened);
  }
  // A server at a stage's address must have the certificate of that stage.
  const auto credentials = [&](const std::string& identity) {
    return tls ? tls->ForIdentity(identity, program.log()) : nullptr;
  };
  const auto pool_options = [&](const std::string& stage) {
    return StagePoolOptions{.credentials = credentials(rpc::StageIdentity(stage))};
  };

  // The objects are created in the order of use, and so destroyed in the reverse order.
  StagePools pools(flags.stage_names(), pool_options, program.log());
  const RemoteArranging arranging(pools.replicas(Stage::kSlicing));
  const RemoteProjects projects(pools.replicas(Stage::kSlicing));
  Dispatcher dispatcher;
  Fleet fleet(dispatcher);
  std::optional<WorkerPool> workers;
  if (!flags.workers.empty()) {
    workers.emplace(fleet, SplitAddresses(flags.workers), program.log(),
                    WorkerPoolOptions{.credentials = credentials(rpc::kWorkerIdentity)});
  }
  if (flags.split()) {
    for (Runner& runner : pools.AsRunners(flags.split_slots)) fleet.Join(std::move(runner));
  }

  const auto rates =
      flags.rates_file.empty() ? absl::StatusOr<Rates>(Rates()) : ReadRates(flags.rates_file);
  if (!rates.ok()) {
    program.log().Error("cannot use the rates", {{"error", std::string(rates.status().message())}});
    return 1;
  }
  std::unique_ptr<ReloadedFile<WebhookPolicy>> webhooks;
  std::unique_ptr<ReloadedFile<Tenants>> tenants;
  if (!OpenReloaded(flags.webhooks_file, "webhooks", WebhookPolicy::Parse, program, webhooks) ||
      !OpenReloaded(flags.tenants_file, "tenants", ParseTenants, program, tenants))
    return 1;
  std::unique_ptr<ReloadedFile<S3Credentials>> s3_credentials;
  StoreOptions stores = flags.stores;
  stores.name = flags.runner.owner;
  if (!OpenBucket(flags.s3, program, s3_credentials, stores.s3)) return 1;
  CoordinatorOptions options{
      .stores = std::move(stores),
      .spool_dir = flags.spool_dir,
      .runner = flags.runner_options(),
      .rates = *rates,
      .default_profile = flags.default_profile,
      .memory_bytes = flags.memory_mib << 20,
      .min_free_bytes = flags.min_free_mib << 20,
      .max_database_bytes = flags.max_database_gib << 30,
      .build_id = std::string(BuildId()),
      .stages_fit =
          [&](Process process) {
            return pools.Away(process).empty() && pools.AreOfThisBuild(process);
          },
      .away_stages = [&](Process process) { return pools.Away(process); },
      .maintenance = flags.maintenance(),
      .sharing = flags.share_cache ? ResultSharing::kOn : ResultSharing::kOff,
      .metrics = &program.metrics().registry()};
  if (webhooks) options.webhooks = [&webhooks] { return webhooks->Get(); };
  if (tenants) options.tenants = [&tenants] { return tenants->Get(); };
  const JobStages job_stages = {pools.stages(), arranging, projects};
  auto coordinator = OpenPatiently(options, job_stages, dispatcher, program);
  if (absl::IsCancelled(coordinator.status())) return 0;
  if (!coordinator.ok()) {
    program.log().Error("cannot open the state",
                        {{"error", std::string(coordinator.status().message())}});
    return 1;
  }
  CoordinatorMetrics::Sources sources = {(*coordinator)->jobs(),
                                         dispatcher,
                                         fleet,
                                         flags.stores.state_dir,
                                         (*coordinator)->database_fill(),
                                         flags.max_database_gib << 30,
                                         flags.maintenance().sweep.keep_jobs_s};
  sources.preset_uses = [&presets = (*coordinator)->presets()] {
    return CoordinatorMetrics::PresetUses{presets.found(), presets.loaded()};
  };
  sources.stages_up = [&pools] {
    std::map<std::string, bool> up;
    for (const auto& [stage, pool] : pools.Pools()) up[stage] = !pool->IsAway();
    return up;
  };
  program.metrics().Show(std::make_shared<CoordinatorMetrics>(std::move(sources)));
  const StatusBoard board(
      {.name = flags.runner.owner,
       .store = StoreName(flags),
       .state_dir = flags.stores.state_dir,
       .jobs = (*coordinator)->jobs(),
       .fleet = fleet,
       .stages = pools.Pools(),
       .log = program.log(),
       .add_progress = [&](JobRecord& job) { (*coordinator)->feed().AddProgress(job); }});
  program.metrics().ShowPage("/statusz", [&board] { return board.Page(); });
  if (absl::Status started = (*coordinator)->Start(); !started.ok()) {
    program.log().Error("cannot start", {{"error", std::string(started.message())}});
    return 1;
  }
  program.ReadyWhile([&] { return (*coordinator)->store_answers(); });
  const auto on_signal = [&] {
    (*coordinator)->Drain(flags.drain_of_jobs());
    (*coordinator)->Stop();
  };
  rpc::ServeFlags serve = flags.serve;
  serve.server.interceptors.push_back(
      [&] { return std::make_unique<AuditLogFactory>((*coordinator)->callers(), program.log()); });
  return program.Run(serve, (*coordinator)->services(), on_signal,
                     &(*coordinator)->queued_methods());
}

}  // namespace

int Main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "migrate") return Migrate(argc - 1, argv + 1);
  if (argc > 1 && std::string_view(argv[1]) == "move-blobs") return MoveBlobs(argc - 1, argv + 1);
  rpc::ServerProgram program("coordinator");
  CLI::App app(
      "slicefarm-coordinator: accepts jobs, distributes them over workers or stages, and stores "
      "them durably");
  app.footer(
      "`slicefarm-coordinator migrate` migrates a PostgreSQL database to the current "
      "schema,\n`slicefarm-coordinator move-blobs` moves blobs into a bucket.");
  CoordinatorFlags flags;
  AddCoordinatorFlags(app, &flags);
  CLI11_PARSE(app, argc, argv);
  return Run(program, flags);
}

}  // namespace slicefarm::coordinator
