#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm {

/// Which trace a piece of work belongs to, and which of its spans asked for it. It is passed on
/// from call to call, and stands in logs, so that all that was done for a job can be found wherever
/// it was done. Source: W3C Trace Context, version 00.
struct TraceContext {
  std::string trace_id = {};  ///< 32 lower-case hex digits, not all 0; empty: no trace
  std::string span_id = {};   ///< 16 of them, not all 0
  bool sampled = true;        ///< whether the caller keeps his part of the trace; only passed on

  bool empty() const { return trace_id.empty(); }

  friend bool operator==(const TraceContext&, const TraceContext&) = default;
};

/// The value of a `traceparent` header; nullopt if it is none, and is to be ignored. Of versions to
/// come, what version 00 has of them.
std::optional<TraceContext> ParseTraceparent(std::string_view text);

/// `00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01`. REQUIRES: !context.empty().
std::string Traceparent(const TraceContext& context);

/// The trace of a job whose client gave none: its id is that of the job, if that has 32 hex digits.
/// The same for the same job, so that each coordinator comes to the same trace.
TraceContext TraceOfJob(std::string_view job_id);

/// A span within `parent`: the same for the same `what`, so that no source of randomness is needed.
/// Of an empty parent, an empty one. Cost: one SHA-256 of some 60 bytes.
TraceContext ChildSpan(const TraceContext& parent, std::string_view what);

}  // namespace slicefarm
