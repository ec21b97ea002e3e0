#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "services/coordinator/store/faults/disk_calls_test.h"

namespace slicefarm::coordinator {

struct LifeStep {
  std::string name;
  std::function<absl::Status()> run;
};

/// What a store goes through in a test, and what it promised on the way.
class StoreLife {
 public:
  virtual ~StoreLife() = default;

  virtual absl::Status Open() = 0;
  virtual void Close() = 0;
  /// Each may fail, and is then done again.
  virtual std::vector<LifeStep> Steps() = 0;

  /// Whether an error says enough of what happened to a call.
  virtual bool Tells(const absl::Status& status, Fault fault) const;

  /// What is wrong with the state in `directory`, as it was found after `changes` of the disk: a
  /// promise made before that is broken, bytes that are others, a store that does not work. May
  /// change what is there.
  virtual std::vector<std::string> Check(const std::string& directory, size_t changes) const = 0;
};

/// A life in a directory that is there, and may hold an older state.
using NewLife = std::function<std::unique_ptr<StoreLife>(DiskCalls&, const std::string& directory)>;

struct TrialOptions {
  NewLife life;
  /// Called with the empty directory first.
  std::function<void(const std::string& directory)> prepare = [](const std::string&) {};
  /// So many errors are tried at each site, spread over its calls.
  int64_t errors_a_site = INT64_MAX;
  /// After one of so many changes the power is cut.
  int64_t cut_every = 1;
  int64_t seed = 1;  ///< which ones, and what a power cut leaves
  Lie lie = Lie::kNone;
};

/// Lets calls of a life fail, one a life: with each error that a call can end with, once or until a
/// step failed; the life then goes on with the same store, or a new one opens the state. Expects
/// that steps succeed in the end, that errors have a reason, and that Check finds nothing in what
/// is there at the end, nor in what a power cut would leave of it. The figures are printed, and
/// kept as properties of the test.
void ExpectErrorsAreSeenTo(const TrialOptions& options);

/// Cuts the power after each change of the disk in a life; all of it again for each of the seeds 1
/// .. `seeds`. Expects that Check finds nothing then, nor after a second cut while it looked. The
/// figures as above.
void ExpectPowerCutsAreSurvived(TrialOptions options, int64_t seeds);

/// Expects that power cuts on a disk that lies break a promise: that these trials find a store that
/// does not sync, here one whose fsyncs do nothing.
void ExpectNoticed(Lie lie, TrialOptions options);

}  // namespace slicefarm::coordinator
