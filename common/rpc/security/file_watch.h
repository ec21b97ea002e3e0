#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Returns the text of a settings file. Errors: REQUEST_MALFORMED, with the file's name, if the
/// file cannot be read or is larger than 16 MiB.
absl::StatusOr<std::string> ReadTextFile(const std::string& path);

/// Checks on its own thread whether a file has changed. The check compares the content, because
/// mounted or linked files may change without a new modification time.
class FileWatch {
 public:
  /// Starts the thread. `text`: content that the caller has already read; empty: none. `changed`:
  /// called with each new content, and once with an error if the file becomes unreadable. `every`:
  /// interval of the checks.
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
  absl::StatusOr<std::string> known_;  ///< used only by the thread
  std::jthread thread_;                ///< the last member, because it uses all other members
};

}  // namespace slicefarm::rpc
