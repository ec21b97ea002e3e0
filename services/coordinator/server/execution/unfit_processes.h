#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <utility>

#include "common/model/process.h"

namespace slicefarm::coordinator {

/// Processes with stages that are known to be away or of another build. A run that meets such
/// stages has read its meshes, written a trace and waited for the stages in vain. Thread-safe.
class UnfitProcesses {
 public:
  /// `stages_fit`: returns true if the stages of a process are reachable and of this build.
  explicit UnfitProcesses(std::function<bool(Process)> stages_fit)
      : stages_fit_(std::move(stages_fit)) {}

  /// Adds a process after a run has met its stages. Returns false if the process was known.
  bool Add(Process process);
  /// Removes the processes with stages that fit now.
  void Update();
  /// Returns true if the stages of this process are known not to fit.
  bool Has(Process process) const;
  /// Returns true if no stages are known not to fit.
  bool empty() const;
  /// Returns true if the stages of all these processes are known not to fit.
  bool HasAll(ProcessSet processes) const;

 private:
  std::set<Process> Known() const;

  const std::function<bool(Process)> stages_fit_;
  mutable std::mutex mutex_;
  std::set<Process> unfit_;
};

}  // namespace slicefarm::coordinator
