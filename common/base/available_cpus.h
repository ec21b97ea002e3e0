#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm {

/// CPUs that this process may use at a time, at least 1: those of the machine that it may run on,
/// or fewer if its container has a quota (cgroup v2, `cpu.max`, or v1).
int AvailableCpus();

/// What a cgroup's `cpu.max` allows, in CPUs, rounded up; none: any number. `quota` is "max" or
/// microseconds, of each `period` microseconds.
std::optional<int> CpusOfQuota(std::string_view quota, std::string_view period);

}  // namespace slicefarm
