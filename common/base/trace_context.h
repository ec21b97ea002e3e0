#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm {

/// Trace to which some work belongs, and the span that requested the work. Each call passes the
/// context on, and logs contain it, so that all work for a job can be found on any machine. Source:
/// W3C Trace Context, version 00.
struct TraceContext {
  std::string trace_id = {};  ///< 32 lower-case hex digits, not all 0; empty: no trace
  std::string span_id = {};   ///< 16 lower-case hex digits, not all 0
  /// True if the caller records its part of the trace; slicefarm only passes it on.
  bool sampled = true;

  bool empty() const { return trace_id.empty(); }

  friend bool operator==(const TraceContext&, const TraceContext&) = default;
};

/// Parses the value of a `traceparent` header. Returns nullopt for an invalid value; the caller
/// should then ignore the header. If the value has a later version, only the fields of version 00
/// are read.
std::optional<TraceContext> ParseTraceparent(std::string_view text);

/// Returns the header value, such as `00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01`.
/// REQUIRES: !context.empty().
std::string Traceparent(const TraceContext& context);

/// Returns the trace of a job for which the client has given no trace. If the job's id has 32 hex
/// digits, it is the trace id. The result depends only on the job's id, so all coordinators get the
/// same trace.
TraceContext TraceOfJob(std::string_view job_id);

/// Returns a new span within the trace of `parent`. Its id depends only on `parent` and `what`, so
/// no source of randomness is needed. An empty parent gives an empty span. Cost: one SHA-256 of
/// about 60 bytes. `what`: name of the work.
TraceContext ChildSpan(const TraceContext& parent, std::string_view what);

}  // namespace slicefarm
