#include "common/base/trace_context.h"

#include <algorithm>

#include "common/base/sha256.h"

namespace slicefarm {
namespace {

constexpr size_t kTraceIdDigits = 32;
constexpr size_t kSpanIdDigits = 16;

bool IsLowerHex(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool IsId(std::string_view text) {
  return IsLowerHex(text) && text.find_first_not_of('0') != std::string_view::npos;
}

bool SampledFlag(char low_digit) {
  constexpr std::string_view kOdd = "13579bdf";
  return kOdd.find(low_digit) != std::string_view::npos;
}

}  // namespace

std::optional<TraceContext> ParseTraceparent(std::string_view text) {
  // Length of version-traceid-spanid-flags.
  constexpr size_t kSize = 2 + 1 + kTraceIdDigits + 1 + kSpanIdDigits + 1 + 2;
  if (text.size() < kSize || text[2] != '-' || text[35] != '-' || text[52] != '-') {
    return std::nullopt;
  }
  const std::string_view version = text.substr(0, 2);
  const std::string_view trace_id = text.substr(3, kTraceIdDigits);
  const std::string_view span_id = text.substr(36, kSpanIdDigits);
  const std::string_view flags = text.substr(53, 2);
  if (!IsLowerHex(version) || version == "ff" || !IsLowerHex(flags)) return std::nullopt;
  if (!IsId(trace_id) || !IsId(span_id)) return std::nullopt;
  const bool longer = text.size() > kSize;
  if (longer && (version == "00" || text[kSize] != '-')) return std::nullopt;
  return TraceContext{std::string(trace_id), std::string(span_id), SampledFlag(flags[1])};
}

std::string Traceparent(const TraceContext& context) {
  return "00-" + context.trace_id + "-" + context.span_id + (context.sampled ? "-01" : "-00");
}

TraceContext TraceOfJob(std::string_view job_id) {
  const std::string digest = Sha256Hex(job_id);
  const bool fits = job_id.size() == kTraceIdDigits && IsId(job_id);
  return {fits ? std::string(job_id) : digest.substr(0, kTraceIdDigits),
          digest.substr(kTraceIdDigits, kSpanIdDigits)};
}

TraceContext ChildSpan(const TraceContext& parent, std::string_view what) {
  if (parent.empty()) return {};
  const std::string name = parent.trace_id + parent.span_id + std::string(what);
  return {parent.trace_id, Sha256Hex(name).substr(0, kSpanIdDigits), parent.sampled};
}

}  // namespace slicefarm
