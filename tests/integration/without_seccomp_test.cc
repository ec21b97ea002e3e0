#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

// Test program that starts another one like a container that forbids seccomp to its programs.
//   without-seccomp PROGRAM ARGUMENT...
int main(int, char** argv) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  const bool forbidden =
      filter != nullptr &&
      seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(seccomp), 0) == 0 &&
      seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(prctl), 1,
                       SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP, 0)) == 0 &&
      seccomp_load(filter) == 0;
  if (forbidden) execv(argv[1], argv + 1);
  std::perror("without-seccomp");
  return 127;
}
