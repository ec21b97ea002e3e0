#pragma once

#include <functional>
#include <memory>
#include <string>

#include "services/coordinator/server/main/state_lock.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_changes.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"
#include "services/coordinator/store/s3/s3_client.h"
#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// Location of a coordinator's state.
struct StoreOptions {
  std::string state_dir;  ///< directory with SQLite and files, for a single coordinator
  /// Connection string of a PostgreSQL database that several coordinators may share; alternative to
  /// state_dir.
  std::string postgres;
  /// Bucket for the blobs; null: the blobs are in the state directory or in the database.
  std::shared_ptr<S3Client> s3 = nullptr;
  /// Name of the coordinator among all that share `postgres`; empty: no name is reserved.
  std::string name = {};
};

/// Open stores of a coordinator.
struct Stores {
  std::unique_ptr<StateLock> lock;  ///< lock of the state directory; null with a database
  std::unique_ptr<JobStore> jobs;   ///< job store for callers
  /// The same job store for the runner, with connections of its own. So leases are renewed even if
  /// callers use all other connections.
  std::unique_ptr<JobStore> runs;
  std::unique_ptr<BlobStores> blobs;
  /// The same blob stores for runs, with connections of their own. So results are stored even if
  /// transfers use all other connections. Null if transfers cannot block runs; runs then use
  /// `blobs`.
  std::unique_ptr<BlobStores> run_blobs;
  std::unique_ptr<ProfileStore> profiles;
  std::unique_ptr<ProfileStore> preset_bundles;
  std::unique_ptr<WebhookStore> webhooks;
  /// Measures the shared database; empty if there is none.
  std::function<absl::StatusOr<DatabaseFill>()> fill;
  /// Returns false if the shared database has not answered for seconds. Empty if there is none.
  std::function<bool()> answers;
};

/// Opens the stores. `runs`: number of jobs that run at the same time. Errors: see JobStore and
/// BlobStores; Unavailable if another program uses the directory; FailedPrecondition if another
/// coordinator has the name; STORE_FAILED if the bucket is unreachable (Unavailable) or refuses
/// access (FailedPrecondition).
absl::StatusOr<Stores> OpenStores(const StoreOptions& options, int runs);

/// Listens for changes of jobs by other coordinators. Returns null if the store is not shared.
std::unique_ptr<JobChanges> ListenForChanges(const StoreOptions& options,
                                             JobChanges::Listener listener);

}  // namespace slicefarm::coordinator
