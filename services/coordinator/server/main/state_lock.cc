#include "services/coordinator/server/main/state_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "common/base/error.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::unique_ptr<StateLock>> StateLock::Take(const std::string& directory) {
  const std::string path = directory + "/lock";
  const int fd = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0640);
  if (fd < 0) {
    return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                     "open " + path + ": " + std::strerror(errno));
  }
  std::unique_ptr<StateLock> lock(new StateLock(fd));
  if (flock(fd, LOCK_EX | LOCK_NB) == 0) return lock;
  return MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed,
                   "another coordinator uses " + directory);
}

StateLock::~StateLock() { close(fd_); }

}  // namespace slicefarm::coordinator
