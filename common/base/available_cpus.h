#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm {

/// Returns the number of CPUs that this program may use at the same time, at least 1. This is the
/// number of the machine's CPUs on which the program may run, limited by the container's quota
/// (cgroup v2, `cpu.max`, or v1).
int AvailableCpus();

/// Returns the number of CPUs that a cgroup's quota allows, rounded up; nullopt if the quota is
/// unlimited. `quota`: first value of `cpu.max`: "max", or the CPU time per period in microseconds.
/// `period`: second value of `cpu.max`, in microseconds.
std::optional<int> CpusOfQuota(std::string_view quota, std::string_view period);

}  // namespace slicefarm
