#include "common/rpc/observe/json_log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "common/base/build_info.h"
#include "common/rpc/utf8.h"

namespace slicefarm::rpc {
namespace {

constexpr size_t kMaxTextBytes = 2048;
constexpr size_t kMaxProblems = 20;

std::string Quoted(std::string_view text) {
  return nlohmann::json(ToUtf8(text, kMaxTextBytes)).dump();
}

std::string ValueText(const LogField& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) return Quoted(*text);
  if (const auto* number = std::get_if<int64_t>(&field.value)) return std::to_string(*number);
  return nlohmann::json(std::get<double>(field.value)).dump();
}

/// Returns the part of a line between the fields of the pattern and the closing brace.
std::string Body(std::string_view message, const LogFields& fields) {
  std::string body = Quoted(message);
  for (const LogField& field : fields) {
    ((body += ',') += Quoted(field.name)) += ':';
    body += ValueText(field);
  }
  return body;
}

}  // namespace

struct JsonLog::Shared {
  Shared(std::shared_ptr<spdlog::logger> to, const LineLimits& limits)
      : logger(std::move(to)), limiter(limits) {}

  const std::shared_ptr<spdlog::logger> logger;  // spdlog's own handle
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::mutex mutex;
  LineLimiter limiter;
  std::deque<Problem> problems;  ///< newest first
};

void AddTrace(const TraceContext& trace, LogFields* fields) {
  if (trace.empty()) return;
  fields->push_back({"trace_id", trace.trace_id});
  fields->push_back({"span_id", trace.span_id});
}

JsonLog::JsonLog(std::string_view service)
    : JsonLog(service,
              std::make_shared<spdlog::logger>(
                  std::string(service), std::make_shared<spdlog::sinks::stderr_sink_mt>())) {}

JsonLog::JsonLog(std::string_view service, std::shared_ptr<spdlog::logger> logger,
                 const LineLimits& limits)
    : shared_(std::make_shared<Shared>(std::move(logger), limits)) {
  shared_->logger->set_formatter(std::make_unique<spdlog::pattern_formatter>(
      R"({"ts":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l","svc":)" + Quoted(service) + R"(,"build":)" +
          Quoted(BuildId()) + R"(,"msg":%v})",
      spdlog::pattern_time_type::utc));
  shared_->logger->flush_on(spdlog::level::info);
}

void JsonLog::Info(std::string_view message, const LogFields& fields) const {
  shared_->logger->info("{}", Body(message, fields));
}

void JsonLog::Warn(std::string_view message, const LogFields& fields) const {
  WriteProblem(spdlog::level::warn, message, fields);
}

void JsonLog::Error(std::string_view message, const LogFields& fields) const {
  WriteProblem(spdlog::level::err, message, fields);
}

void JsonLog::WriteProblem(int level, std::string_view message, LogFields fields) const {
  std::unique_lock lock(shared_->mutex);
  const std::chrono::duration<double> now = std::chrono::steady_clock::now() - shared_->start;
  const std::optional<int64_t> suppressed = shared_->limiter.Pass(message, now.count());
  if (!suppressed) return;
  if (*suppressed > 0) fields.push_back({"suppressed", *suppressed});
  const std::string body = Body(message, fields);
  shared_->problems.push_front({std::chrono::system_clock::now(), "{\"msg\":" + body + "}"});
  if (shared_->problems.size() > kMaxProblems) shared_->problems.pop_back();
  lock.unlock();
  shared_->logger->log(static_cast<spdlog::level::level_enum>(level), "{}", body);
}

std::vector<Problem> JsonLog::RecentProblems() const {
  const std::lock_guard lock(shared_->mutex);
  return {shared_->problems.begin(), shared_->problems.end()};
}

}  // namespace slicefarm::rpc
