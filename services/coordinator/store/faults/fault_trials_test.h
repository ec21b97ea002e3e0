#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "services/coordinator/store/faults/disk_calls_test.h"

namespace slicefarm::coordinator {

/// Step of a life.
struct LifeStep {
  std::string name;
  std::function<absl::Status()> run;
};

/// Sequence of operations of a store in a test, with the promises that the store made during them.
class StoreLife {
 public:
  virtual ~StoreLife() = default;

  /// Opens the store in its directory.
  virtual absl::Status Open() = 0;
  /// Closes the store.
  virtual void Close() = 0;
  /// Returns the steps. Each step may fail and is then repeated.
  virtual std::vector<LifeStep> Steps() = 0;

  /// Returns true if an error sufficiently describes the fault of a call.
  virtual bool Reports(const absl::Status& status, Fault fault) const;

  /// Returns the violations in the state in `directory`, found after `changes` changes of the disk.
  /// Violations are broken promises from before, changed bytes, or a store that does not work. May
  /// change the directory.
  virtual std::vector<std::string> Check(const std::string& directory, size_t changes) const = 0;
};

/// Function that creates a life in an existing directory, which may contain an older state.
using NewLife = std::function<std::unique_ptr<StoreLife>(DiskCalls&, const std::string& directory)>;

/// Options of a trial.
struct TrialOptions {
  NewLife life;
  /// Prepares the directory, which is empty at first.
  std::function<void(const std::string& directory)> prepare = [](const std::string&) {};
  /// Number of errors that are tried at each site, spread over its calls.
  int64_t errors_a_site = INT64_MAX;
  /// Interval of the power cuts, in changes of the disk.
  int64_t cut_every = 1;
  int64_t seed = 1;  ///< seed for the choice of errors and for the state after a power cut
  Lie lie = Lie::kNone;
};

/// Lets calls of a life fail, one per life. Tries each error that a call can return, once or until
/// a step has failed. The life then continues with the same store, or opens the state with a new
/// store. Expects that all steps succeed in the end and that errors have a reason. Expects that
/// Check finds no violations in the final state, nor in its state after a power cut. Prints the
/// counts and records them as properties of the test.
void ExpectErrorsAreSeenTo(const TrialOptions& options);

/// Cuts the power after each change of the disk in a life, for each of the seeds 1 .. `seeds`.
/// Expects that Check finds no violations then, nor after a second cut during the check. Prints and
/// records counts as ExpectErrorsAreSeenTo does.
void ExpectPowerCutsAreSurvived(TrialOptions options, int64_t seeds);

/// Expects that power cuts break a promise if fsync has no effect on the files or directories of
/// `lie`. So these trials detect a store that does not sync.
void ExpectNoticed(Lie lie, TrialOptions options);

}  // namespace slicefarm::coordinator
