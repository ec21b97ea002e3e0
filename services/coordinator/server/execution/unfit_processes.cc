#include "services/coordinator/server/execution/unfit_processes.h"

#include <algorithm>

namespace slicefarm::coordinator {

std::set<Process> UnfitProcesses::Known() const {
  const std::lock_guard lock(mutex_);
  return unfit_;
}

bool UnfitProcesses::Add(Process process) {
  const std::lock_guard lock(mutex_);
  return unfit_.insert(process).second;
}

void UnfitProcesses::Update() {
  // The stages are asked without the lock, because their answers may take long.
  for (const Process process : Known()) {
    if (!stages_fit_(process)) continue;
    const std::lock_guard lock(mutex_);
    unfit_.erase(process);
  }
}

bool UnfitProcesses::Has(Process process) const { return Known().contains(process); }

bool UnfitProcesses::empty() const { return Known().empty(); }

bool UnfitProcesses::HasAll(ProcessSet processes) const {
  const std::set<Process> unfit = Known();
  return std::ranges::all_of(kProcesses, [&](const ProcessInfo& info) {
    return !processes.Has(info.process) || unfit.contains(info.process);
  });
}

}  // namespace slicefarm::coordinator
