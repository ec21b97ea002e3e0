#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/base/trace_context.h"
#include "common/rpc/observe/line_limiter.h"

namespace spdlog {
class logger;
}

namespace slicefarm::rpc {

/// One field of a log line. Names in use: job, tenant, trace_id, span_id, layer_first, layer_last,
/// worker, method, peer, seconds, code, reason, error, address, replica, layers, bytes, suppressed.
struct LogField {
  std::string_view name;
  std::variant<int64_t, double, std::string> value;
};
using LogFields = std::vector<LogField>;

/// Adds trace_id and span_id; adds nothing for an empty trace.
void AddTrace(const TraceContext& trace, LogFields* fields);

/// Warning or error that the log has written.
struct Problem {
  std::chrono::system_clock::time_point time;
  std::string text;  ///< message and fields of the line, as JSON
};

/// Logs to stderr, one JSON object per line:
///   {"ts":"2026-11-21T12:00:00.123Z","level":"info","svc":"beading","build":"5e0f...",
///    "msg":"range done","job":"j1","layer_first":0}
/// Texts are cut to 2 KiB and converted to UTF-8. The number of warnings and errors with the same
/// message is limited (LineLimits). The next written line with this message states the number of
/// omitted lines (`suppressed`). Never log mesh bytes or tokens. Thread-safe; cheap to copy: copies
/// share their limits.
class JsonLog {
 public:
  /// Makes a log to stderr. `service`: name of the program, such as `beading`.
  explicit JsonLog(std::string_view service);
  /// Makes a log for tests. `logger` has its own sinks.
  JsonLog(std::string_view service, std::shared_ptr<spdlog::logger> logger,
          const LineLimits& limits = {});

  void Info(std::string_view message, const LogFields& fields = {}) const;
  void Warn(std::string_view message, const LogFields& fields = {}) const;
  void Error(std::string_view message, const LogFields& fields = {}) const;

  /// Returns the latest problems, newest first.
  std::vector<Problem> RecentProblems() const;

 private:
  struct Shared;
  void WriteProblem(int level, std::string_view message, LogFields fields) const;

  std::shared_ptr<Shared> shared_;  // shared: the sinks must outlive the last copy
};

}  // namespace slicefarm::rpc
