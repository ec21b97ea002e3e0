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

/// One field of a log line. The names in use: job, tenant, trace_id, span_id, layer_first,
/// layer_last, worker, method, peer, seconds, code, reason, error, address, replica, layers, bytes,
/// suppressed.
struct LogField {
  std::string_view name;
  std::variant<int64_t, double, std::string> value;
};
using LogFields = std::vector<LogField>;

/// trace_id and span_id; nothing of an empty trace.
void AddTrace(const TraceContext& trace, LogFields* fields);

/// A warning or an error that was written.
struct Problem {
  std::chrono::system_clock::time_point time;
  std::string text;  ///< the line's message and fields, as JSON
};

/// Logs to stderr, one JSON object a line:
///   {"ts":"2026-11-21T12:00:00.123Z","level":"info","svc":"beading","build":"5e0f...",
///    "msg":"range done","job":"j1","layer_first":0}
/// Texts are cut to 2 KiB and made UTF-8. Of warnings and errors with the same message only so many
/// are written (LineLimits), and the next line that is says how many were not (`suppressed`). Never
/// log mesh bytes or tokens. Thread-safe; cheap to copy: copies share their limits.
class JsonLog {
 public:
  /// `service`: the program, such as `beading`.
  explicit JsonLog(std::string_view service);
  /// For tests: through a logger with sinks of its own.
  JsonLog(std::string_view service, std::shared_ptr<spdlog::logger> logger,
          const LineLimits& limits = {});

  void Info(std::string_view message, const LogFields& fields = {}) const;
  void Warn(std::string_view message, const LogFields& fields = {}) const;
  void Error(std::string_view message, const LogFields& fields = {}) const;

  /// The last ones, newest first.
  std::vector<Problem> RecentProblems() const;

 private:
  struct Shared;
  void WriteProblem(int level, std::string_view message, LogFields fields) const;

  std::shared_ptr<Shared> shared_;  // shared: the sinks outlive whoever logs last
};

}  // namespace slicefarm::rpc
