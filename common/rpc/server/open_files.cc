#include "common/rpc/server/open_files.h"

#include <sys/resource.h>

namespace slicefarm::rpc {

void RaiseOpenFilesLimit() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  (void)setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace slicefarm::rpc
