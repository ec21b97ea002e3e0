#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// The text of a file of settings. Errors: REQUEST_MALFORMED naming the file if it cannot be read
/// or is larger than 16 MiB.
absl::StatusOr<std::string> ReadTextFile(const std::string& path);

/// Looks at a file again and again, from a thread of its own. By its content: files that are
/// mounted or linked anew need not have another date.
class FileWatch {
 public:
  /// `text`: what the watcher knows already; empty: nothing. `changed` is told each other text, and
  /// that the file cannot be read, once until it can.
  FileWatch(std::string path, std::string text,
            std::function<void(const absl::StatusOr<std::string>&)> changed,
            std::chrono::milliseconds every = std::chrono::seconds(1));
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

 private:
  void Loop(const std::stop_token& stop);

  const std::string path_;
  const std::function<void(const absl::StatusOr<std::string>&)> changed_;
  const std::chrono::milliseconds every_;
  absl::StatusOr<std::string> known_;  ///< of the thread alone
  std::jthread thread_;                ///< the last member: it uses the others
};

}  // namespace slicefarm::rpc
