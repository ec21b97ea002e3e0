#include "common/rpc/security/file_watch.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/base/stoppable_sleep.h"

namespace slicefarm::rpc {
namespace {

constexpr uintmax_t kMaxBytes = 16 << 20;

absl::Status Unreadable(const std::string& path, const std::string& why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, path + " " + why,
                   {{"file", path}});
}

}  // namespace

absl::StatusOr<std::string> ReadTextFile(const std::string& path) {
  std::error_code error;
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return Unreadable(path, "cannot be read: " + error.message());
  if (size > kMaxBytes) return Unreadable(path, "is too large");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || !file.is_open()) return Unreadable(path, "cannot be read");
  return text;
}

FileWatch::FileWatch(std::string path, std::string text,
                     std::function<void(const absl::StatusOr<std::string>&)> changed,
                     std::chrono::milliseconds every)
    : path_(std::move(path)),
      changed_(std::move(changed)),
      every_(every),
      known_(std::move(text)),
      thread_([this](const std::stop_token& stop) { Loop(stop); }) {}

void FileWatch::Loop(const std::stop_token& stop) {
  while (SleepUnlessStopped(stop, every_)) {
    absl::StatusOr<std::string> now = ReadTextFile(path_);
    const bool same = now.ok() == known_.ok() && (!now.ok() || *now == *known_);
    if (!same) {
      changed_(now);
      known_ = std::move(now);
    }
  }
}

}  // namespace slicefarm::rpc
