#include "services/coordinator/server/coordinator_flags.h"

#include <CLI/CLI.hpp>

#include "common/model/limits.h"
#include "services/coordinator/remote/address_watch.h"
#include "services/coordinator/server/transfers.h"

namespace slicefarm::coordinator {
namespace {

/// Uploads and downloads hold a thread each: TransferOptions bounds them, and leaves enough for the
/// other calls.
constexpr int kThreads = 256;
constexpr TransferOptions kTransfers;
static_assert(2 * (kTransfers.slots + kTransfers.queue) <= kThreads * 2 / 3);

/// Whatever one connection has open, it does not take all threads.
constexpr int kStreamsPerConnection = 128;

void Check(const CoordinatorFlags& flags) {
  const bool all = !flags.beading.empty() && !flags.infill.empty() && !flags.ordering.empty();
  const bool any = !flags.beading.empty() || !flags.infill.empty() || !flags.ordering.empty();
  if (any && !all) {
    throw CLI::ValidationError("--beading, --infill and --ordering go together");
  }
  if (!any && flags.workers.empty()) {
    throw CLI::ValidationError("either --workers or --beading, --infill and --ordering is needed");
  }
}

}  // namespace

SplitStages::Names CoordinatorFlags::split_names() const {
  return {SplitAddresses(beading), SplitAddresses(infill), SplitAddresses(ordering)};
}

void AddCoordinatorFlags(CLI::App& app, CoordinatorFlags* flags) {
  flags->runner.owner = "coordinator";
  flags->serve.server.max_message_bytes = limits::kMaxPublicMessageBytes;
  flags->serve.server.max_threads = kThreads;
  flags->serve.server.max_streams_per_connection = kStreamsPerConnection;
  AddServeFlags(app, &flags->serve);
  app.add_option("--state-dir", flags->state_dir, "Directory for jobs and blobs; made if needed")
      ->required();
  app.add_option("--slicing", flags->slicing, "Addresses of slicing services, host:port,...")
      ->required();
  app.add_option("--motion", flags->motion, "Addresses of motion services")->required();
  app.add_option("--workers", flags->workers, "Addresses of fused workers");
  app.add_option("--beading", flags->beading, "Addresses of beading services, for split stages");
  app.add_option("--infill", flags->infill, "Addresses of infill services");
  app.add_option("--ordering", flags->ordering, "Addresses of ordering services");
  app.add_option("--split-slots", flags->split_slots,
                 "Layer ranges in flight over the split stages")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--jobs", flags->runner.jobs, "Jobs that run at the same time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.callback([flags] { Check(*flags); });
}

}  // namespace slicefarm::coordinator
