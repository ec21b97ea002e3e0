#include "common/base/available_cpus.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <thread>

namespace slicefarm {
namespace {

std::optional<int64_t> Number(std::string_view text) {
  int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Returns the first word of a file, or an empty text if there is none.
std::string Word(const std::string& path) {
  std::string word;
  std::ifstream(path) >> word;
  return word;
}

/// Returns the number of CPUs that the quota of this program's cgroup allows, or nullopt without a
/// quota. A container's own cgroup is visible as the root of the hierarchy.
std::optional<int> Quota() {
  std::string quota;
  std::string period;
  if (std::ifstream("/sys/fs/cgroup/cpu.max") >> quota >> period) return CpusOfQuota(quota, period);
  return CpusOfQuota(Word("/sys/fs/cgroup/cpu/cpu.cfs_quota_us"),
                     Word("/sys/fs/cgroup/cpu/cpu.cfs_period_us"));
}

}  // namespace

std::optional<int> CpusOfQuota(std::string_view quota, std::string_view period) {
  const auto used = Number(quota);
  const auto of = Number(period);
  if (!used || !of || *used <= 0 || *of <= 0) return std::nullopt;
  return static_cast<int>((*used + *of - 1) / *of);
}

int AvailableCpus() {
  const int cpus = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::min(cpus, Quota().value_or(cpus));
}

}  // namespace slicefarm
