#include "common/rpc/json_log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "common/rpc/utf8.h"

namespace slicefarm::rpc {
namespace {

constexpr size_t kMaxTextBytes = 2048;

std::string Quoted(std::string_view text) {
  return nlohmann::json(ToUtf8(text, kMaxTextBytes)).dump();
}

std::string ValueText(const LogField& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) return Quoted(*text);
  if (const auto* number = std::get_if<int64_t>(&field.value)) return std::to_string(*number);
  return nlohmann::json(std::get<double>(field.value)).dump();
}

/// What stands between the fields of the pattern and the closing brace.
std::string Body(std::string_view message, const LogFields& fields) {
  std::string body = Quoted(message);
  for (const LogField& field : fields) {
    ((body += ',') += Quoted(field.name)) += ':';
    body += ValueText(field);
  }
  return body;
}

}  // namespace

JsonLog::JsonLog(std::string_view service)
    : JsonLog(service,
              std::make_shared<spdlog::logger>(
                  std::string(service), std::make_shared<spdlog::sinks::stderr_sink_mt>())) {}

JsonLog::JsonLog(std::string_view service, std::shared_ptr<spdlog::logger> logger)
    : logger_(std::move(logger)) {
  logger_->set_formatter(std::make_unique<spdlog::pattern_formatter>(
      R"({"ts":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l","svc":)" + Quoted(service) + R"(,"msg":%v})",
      spdlog::pattern_time_type::utc));
  logger_->flush_on(spdlog::level::info);
}

void JsonLog::Info(std::string_view message, const LogFields& fields) const {
  logger_->info("{}", Body(message, fields));
}

void JsonLog::Warn(std::string_view message, const LogFields& fields) const {
  logger_->warn("{}", Body(message, fields));
}

void JsonLog::Error(std::string_view message, const LogFields& fields) const {
  logger_->error("{}", Body(message, fields));
}

}  // namespace slicefarm::rpc
