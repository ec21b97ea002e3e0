#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spdlog {
class logger;
}

namespace slicefarm::rpc {

/// One field of a log line. The names in use: job, layer_first, layer_last, method, peer, seconds,
/// code, reason, error, address, replica, layers, bytes.
struct LogField {
  std::string_view name;
  std::variant<int64_t, double, std::string> value;
};
using LogFields = std::vector<LogField>;

/// Logs to stderr, one JSON object a line:
///   {"ts":"2026-11-21T12:00:00.123Z","level":"info","svc":"beading","msg":"range
///   done","job":"j1","layer_first":0}
/// Texts are cut to 2 KiB and made UTF-8. Never log mesh bytes or tokens. Thread-safe; cheap to
/// copy.
class JsonLog {
 public:
  /// `service`: the program, such as `beading`.
  explicit JsonLog(std::string_view service);
  /// For tests: through a logger with sinks of its own.
  JsonLog(std::string_view service, std::shared_ptr<spdlog::logger> logger);

  void Info(std::string_view message, const LogFields& fields = {}) const;
  void Warn(std::string_view message, const LogFields& fields = {}) const;
  void Error(std::string_view message, const LogFields& fields = {}) const;

 private:
  std::shared_ptr<spdlog::logger> logger_;  // shared: the sinks outlive whoever logs last
};

}  // namespace slicefarm::rpc
