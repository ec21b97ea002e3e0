#pragma once

#include <cstdint>

namespace slicefarm::coordinator::sim {

/// Counts of events in one seed or in many. A new count also needs a row in kTotals.
struct Totals {
  int64_t jobs = 0;
  int64_t succeeded = 0;
  int64_t cached = 0;
  int64_t failed = 0;
  int64_t overdue = 0;
  int64_t cancelled = 0;
  int64_t deleted = 0;
  int64_t queue_full = 0;
  int64_t request_ids_reused = 0;
  int64_t swept_blobs = 0;
  int64_t kills = 0;
  int64_t deaths = 0;     ///< deaths of coordinators because of their jobs
  int64_t condemned = 0;  ///< jobs that were found to kill coordinators
  int64_t stops = 0;
  int64_t pauses = 0;
  int64_t partitions = 0;
  int64_t worker_kills = 0;
  int64_t lost_messages = 0;
  int64_t doubled_messages = 0;
  int64_t store_faults = 0;
  int64_t claims = 0;
  int64_t takeovers = 0;
  int64_t adoptions = 0;
  int64_t fenced_writes = 0;
  int64_t ranges = 0;
  int64_t requeued = 0;
  int64_t hedges = 0;
  int64_t poisoned = 0;
  int64_t steps = 0;
  int64_t simulated_s = 0;
};

/// Name and member of a count.
struct TotalsField {
  const char* name;
  int64_t Totals::*value;
};

inline constexpr TotalsField kTotals[] = {
    {"jobs", &Totals::jobs},
    {"succeeded", &Totals::succeeded},
    {"cached", &Totals::cached},
    {"failed", &Totals::failed},
    {"overdue", &Totals::overdue},
    {"cancelled", &Totals::cancelled},
    {"deleted", &Totals::deleted},
    {"queue_full", &Totals::queue_full},
    {"request_ids_reused", &Totals::request_ids_reused},
    {"swept_blobs", &Totals::swept_blobs},
    {"kills", &Totals::kills},
    {"deaths", &Totals::deaths},
    {"condemned", &Totals::condemned},
    {"stops", &Totals::stops},
    {"pauses", &Totals::pauses},
    {"partitions", &Totals::partitions},
    {"worker_kills", &Totals::worker_kills},
    {"lost_messages", &Totals::lost_messages},
    {"doubled_messages", &Totals::doubled_messages},
    {"store_faults", &Totals::store_faults},
    {"claims", &Totals::claims},
    {"takeovers", &Totals::takeovers},
    {"adoptions", &Totals::adoptions},
    {"fenced_writes", &Totals::fenced_writes},
    {"ranges", &Totals::ranges},
    {"requeued", &Totals::requeued},
    {"hedges", &Totals::hedges},
    {"poisoned", &Totals::poisoned},
    {"steps", &Totals::steps},
    {"simulated_s", &Totals::simulated_s},
};

}  // namespace slicefarm::coordinator::sim
