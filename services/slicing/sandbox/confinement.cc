#include "services/slicing/sandbox/confinement.h"

#include <fmt/core.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <string_view>

#include "common/base/error.h"
#include "services/slicing/sandbox/sanitized_build.h"

namespace slicefarm::slicing {
namespace {

absl::Status Refused(std::string_view step, int error) {
  return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kInternal,
                   fmt::format("the system refuses {} ({})", step, strerrordesc_np(error)));
}

struct Limit {
  std::string_view name;
  __rlimit_resource resource;
  int64_t soft;
  int64_t hard;
};

/// Sets a resource limit. If the present hard limit is lower, uses the hard limit, because the
/// program could not raise it.
absl::Status Set(const Limit& limit) {
  rlimit now = {};
  if (getrlimit(limit.resource, &now) != 0) return Refused(limit.name, errno);
  const rlim_t hard = std::min(static_cast<rlim_t>(limit.hard), now.rlim_max);
  const rlimit value = {std::min(static_cast<rlim_t>(limit.soft), hard), hard};
  return setrlimit(limit.resource, &value) == 0 ? absl::OkStatus() : Refused(limit.name, errno);
}

absl::Status SetLimits(const ReaderLimits& limits) {
  const Limit all[] = {
      // The soft limit ends the program by SIGXCPU, which shows the reason; the hard limit by
      // SIGKILL.
      {"RLIMIT_CPU", RLIMIT_CPU, limits.cpu_s, limits.cpu_s + 1},
      {"RLIMIT_FSIZE", RLIMIT_FSIZE, 0, 0},
      {"RLIMIT_CORE", RLIMIT_CORE, 0, 0},
      {"RLIMIT_NPROC", RLIMIT_NPROC, 0, 0},
      // With the limit 0, the program can open no further file or socket.
      {"RLIMIT_NOFILE", RLIMIT_NOFILE, 0, 0},
      {"RLIMIT_AS", RLIMIT_AS, limits.memory_bytes, limits.memory_bytes},
  };
  for (const Limit& limit : all) {
    if (kSanitizedBuild && (limit.resource == RLIMIT_AS || limit.resource == RLIMIT_NOFILE))
      continue;  // its runtime reserves more, and opens /proc/self/maps to tell of a bug
    if (absl::Status status = Set(limit); !status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status SetTraits(int64_t parent) {
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return Refused("PR_SET_PDEATHSIG", errno);
  if (getppid() != parent) return Refused("PR_SET_PDEATHSIG", ESRCH);  // the parent is already gone
  if (prctl(PR_SET_DUMPABLE, 0) != 0) return Refused("PR_SET_DUMPABLE", errno);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return Refused("PR_SET_NO_NEW_PRIVS", errno);
  return absl::OkStatus();
}

/// Additional system calls of the sanitizers' runtimes.
constexpr int kSanitizerCalls[] = {
    SCMP_SYS(write),        SCMP_SYS(mmap),           SCMP_SYS(mprotect),     SCMP_SYS(futex),
    SCMP_SYS(sched_yield),  SCMP_SYS(clock_gettime),  SCMP_SYS(getpid),       SCMP_SYS(gettid),
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(nanosleep),    SCMP_SYS(getrlimit),      SCMP_SYS(prlimit64),
};

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

/// The following functions add rules to a filter. Each returns 0 or a negative errno, as libseccomp
/// does.
int AllowWrites(scmp_filter_ctx filter) {
  return seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(write), 1,
                          SCMP_A0(SCMP_CMP_EQ, STDOUT_FILENO, 0));
}

/// Allows memory that is neither mapped from a file nor executable. No memory can be made
/// executable afterwards.
int AllowMemory(scmp_filter_ctx filter) {
  const int mapped = seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(mmap), 2,
                                      SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0),
                                      SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS));
  if (mapped != 0) return mapped;
  for (const int call : {SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk), SCMP_SYS(madvise)})
    if (const int added = seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0)) return added;
  return 0;
}

int AllowTheRest(scmp_filter_ctx filter) {
  if (const int added = seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(exit_group), 0))
    return added;
  if (!kSanitizedBuild) return 0;
  for (const int call : kSanitizerCalls)
    if (const int added = seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0)) return added;
  return 0;
}

absl::Status SetFilter() {
  const Filter filter(seccomp_init(SCMP_ACT_KILL_PROCESS), &seccomp_release);
  // libseccomp returns no filter if the system has no seccomp.
  if (filter == nullptr) return Refused("a seccomp filter", EOPNOTSUPP);
  int error = seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  // This attribute makes libseccomp return the system's own error code instead of one code for all.
  if (error == 0) error = seccomp_attr_set(filter.get(), SCMP_FLTATR_API_SYSRAWRC, 1);
  for (const auto add : {&AllowWrites, &AllowMemory, &AllowTheRest})
    if (error == 0) error = add(filter.get());
  if (error == 0) error = seccomp_load(filter.get());
  return error == 0 ? absl::OkStatus() : Refused("a seccomp filter", -error);
}

}  // namespace

absl::Status Confine(Confinement confinement, const ReaderLimits& limits, int64_t parent) {
  if (absl::Status status = SetTraits(parent); !status.ok()) return status;
  if (absl::Status status = SetLimits(limits); !status.ok()) return status;
  return confinement == Confinement::kStrict ? SetFilter() : absl::OkStatus();
}

}  // namespace slicefarm::slicing
