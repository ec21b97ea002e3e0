#include "services/coordinator/algo/job_trace.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

using nlohmann::json;

constexpr int kJobProcess = 1;
constexpr int kQueueRow = 1;
constexpr int kRunRow = 2;

/// Returns the JSON text. Replaces bytes that are no UTF-8, because some texts come from outside.
std::string Text(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

absl::Status Damaged(const std::string& why) {
  return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                   "the trace of a job cannot be read: " + why);
}

json SpanToJson(const Span& span) {
  return {{"name", span.name},
          {"track", span.track},
          {"begin_us", span.begin_us},
          {"end_us", span.end_us},
          {"facts", span.facts}};
}

Span SpanFromJson(const json& value) {
  return {value.at("name"), value.at("track"), value.at("begin_us"), value.at("end_us"),
          value.at("facts")};
}

/// Number of an attempt at some work, from 1. `copy`: true if an earlier attempt at the same work
/// was still running when this one began.
struct Attempt {
  int number = 1;
  bool copy = false;
};

/// Returns the attempt of each span. Spans of the same name on different tracks are attempts at the
/// same work.
std::vector<Attempt> Attempts(const std::vector<Span>& spans) {
  struct Before {
    int count = 0;
    int64_t busy_until_us = 0;
  };
  std::map<std::string, Before> before;
  std::vector<Attempt> attempts;
  for (const Span& span : spans) {
    Before& same = before[span.name];
    attempts.push_back({++same.count, same.count > 1 && span.begin_us < same.busy_until_us});
    same.busy_until_us = std::max(same.busy_until_us, span.end_us);
  }
  return attempts;
}

/// Collects the events of a trace in the order of the calls.
class Events {
 public:
  void Name(int process, const std::string& name) {
    events_.push_back({{"ph", "M"},
                       {"name", "process_name"},
                       {"pid", process},
                       {"tid", 0},
                       {"args", {{"name", name}}}});
    events_.push_back({{"ph", "M"},
                       {"name", "process_sort_index"},
                       {"pid", process},
                       {"tid", 0},
                       {"args", {{"sort_index", process}}}});
  }

  void Name(int process, int row, const std::string& name) {
    events_.push_back({{"ph", "M"},
                       {"name", "thread_name"},
                       {"pid", process},
                       {"tid", row},
                       {"args", {{"name", name}}}});
  }

  void Add(const Span& span, int process, int row, json more = json::object()) {
    json facts = span.facts;
    facts.update(more);
    events_.push_back({{"ph", "X"},
                       {"name", span.name},
                       {"cat", "job"},
                       {"ts", span.begin_us},
                       {"dur", span.end_us - span.begin_us},
                       {"pid", process},
                       {"tid", row},
                       {"args", std::move(facts)}});
  }

  json Take() { return std::move(events_); }

 private:
  json events_ = json::array();
};

/// Assigns spans to rows of a process. The spans of one row do not overlap.
class Rows {
 public:
  /// Returns the first row that is free when the span begins.
  int Take(const Span& span) {
    const auto free = std::ranges::find_if(
        busy_until_us_, [&](int64_t until_us) { return until_us <= span.begin_us; });
    const auto row = static_cast<int>(free - busy_until_us_.begin());
    if (free == busy_until_us_.end()) busy_until_us_.push_back(0);
    busy_until_us_[row] = span.end_us;
    return row + 1;
  }

 private:
  std::vector<int64_t> busy_until_us_;
};

void AddOthers(const std::vector<Span>& spans, Events& events) {
  struct Process {
    int id = 0;
    Rows rows;
  };
  std::map<std::string, Process> processes;
  for (const Span& span : spans) processes[span.track];
  int next = kJobProcess + 1;
  for (auto& [track, process] : processes) {
    process.id = next++;
    events.Name(process.id, track);
  }
  const std::vector<Attempt> attempts = Attempts(spans);
  for (size_t i = 0; i < spans.size(); ++i) {
    Process& process = processes[spans[i].track];
    events.Add(spans[i], process.id, process.rows.Take(spans[i]),
               {{"attempt", attempts[i].number}, {"copy", attempts[i].copy}});
  }
}

}  // namespace

JobTrace Joined(JobTrace earlier, const SpanLog& run) {
  JobTrace trace = std::move(earlier);
  std::vector<Span> spans = run.spans();
  trace.spans.insert(trace.spans.end(), std::make_move_iterator(spans.begin()),
                     std::make_move_iterator(spans.end()));
  trace.dropped += run.dropped();
  if (trace.spans.size() <= kMaxJobSpans) return trace;
  const auto over = static_cast<std::ptrdiff_t>(trace.spans.size() - kMaxJobSpans);
  trace.spans.erase(trace.spans.begin(), trace.spans.begin() + over);
  trace.dropped += over;
  return trace;
}

std::string ToJson(const JobTrace& trace) {
  json spans = json::array();
  for (const Span& span : trace.spans) spans.push_back(SpanToJson(span));
  return Text({{"spans", std::move(spans)}, {"dropped", trace.dropped}});
}

absl::StatusOr<JobTrace> JobTraceFromJson(const std::string& text) {
  try {  // the library reports what does not fit by throwing
    const json value = json::parse(text);
    JobTrace trace;
    trace.dropped = value.at("dropped");
    for (const json& span : value.at("spans")) trace.spans.push_back(SpanFromJson(span));
    return trace;
  } catch (const json::exception& error) {
    return Damaged(error.what());
  }
}

std::string ChromeTrace(const JobTrace& trace, const std::vector<Span>& waits,
                        const std::map<std::string, std::string>& about) {
  std::vector<Span> spans = trace.spans;
  // A span that encloses other spans comes before them.
  std::ranges::stable_sort(spans, {},
                           [](const Span& span) { return std::pair(span.begin_us, -span.end_us); });
  const auto others = std::stable_partition(spans.begin(), spans.end(),
                                            [](const Span& span) { return span.track.empty(); });

  Events events;
  events.Name(kJobProcess, "job");
  events.Name(kJobProcess, kQueueRow, "queue");
  events.Name(kJobProcess, kRunRow, "run");
  for (const Span& wait : waits) events.Add(wait, kJobProcess, kQueueRow);
  for (const Span& span : std::span(spans.begin(), others)) {
    events.Add(span, kJobProcess, kRunRow);
  }
  AddOthers({others, spans.end()}, events);

  json facts = about;
  facts["dropped_spans"] = std::to_string(trace.dropped);
  return Text({{"traceEvents", events.Take()}, {"displayTimeUnit", "ms"}, {"otherData", facts}});
}

}  // namespace slicefarm::coordinator
