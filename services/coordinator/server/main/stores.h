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

/// Where a coordinator keeps its state.
struct StoreOptions {
  std::string state_dir;  ///< SQLite and files in this directory, of one coordinator
  std::string
      postgres;  ///< or a PostgreSQL database, which several may share: how to connect to it
  std::shared_ptr<S3Client> s3 = nullptr;  ///< where blobs are; null: with the other state
  std::string name = {};  ///< of a coordinator among those that share `postgres`; empty: any number
};

/// What a coordinator keeps its state in.
struct Stores {
  std::unique_ptr<StateLock> lock;  ///< of a directory
  std::unique_ptr<JobStore> jobs;   ///< as callers see them
  /// The same ones, as those who run them see them: whatever callers ask for, leases are renewed.
  std::unique_ptr<JobStore> runs;
  std::unique_ptr<BlobStores> blobs;
  /// The same ones, as those who run jobs see them: whatever is being uploaded and downloaded, a
  /// result that was computed is kept. Null where transfers hold nothing that runs need.
  std::unique_ptr<BlobStores> run_blobs;
  std::unique_ptr<ProfileStore> profiles;
  std::unique_ptr<WebhookStore> webhooks;
  std::function<absl::StatusOr<DatabaseFill>()> fill;  ///< of a database that is shared; or null
  std::function<bool()> answers;  ///< false: such a database has been silent for seconds; or null
};

/// `runs`: how many jobs run at the same time. Errors: those of the stores; Unavailable if another
/// process uses the directory; FailedPrecondition if another one has the name; STORE_FAILED if the
/// bucket is away (Unavailable) or refuses us (FailedPrecondition).
absl::StatusOr<Stores> OpenStores(const StoreOptions& options, int runs);

/// What other coordinators do to the jobs; null where there are none.
std::unique_ptr<JobChanges> ListenForChanges(const StoreOptions& options,
                                             JobChanges::Listener listener);

}  // namespace slicefarm::coordinator
