#include "services/milling/algo/prepared_jobs.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace slicefarm::milling {
namespace {

TriangleMesh InMm(const IndexedMesh& mesh) {
  TriangleMesh in_mm;
  in_mm.points_mm.reserve(mesh.vertices.size());
  for (const Vertex& v : mesh.vertices)
    in_mm.points_mm.push_back({ToMm(static_cast<double>(v.x)), ToMm(static_cast<double>(v.y)),
                               ToMm(static_cast<double>(v.z))});
  in_mm.triangles = mesh.triangles;
  return in_mm;
}

int64_t BytesOf(const TriangleMesh& mesh) {
  return static_cast<int64_t>(mesh.points_mm.size() * sizeof(mesh.points_mm[0]) +
                              mesh.triangles.size() * sizeof(mesh.triangles[0]));
}

int64_t BytesOf(const MillingJob& job) {
  return BytesOf(job.part) + BytesOf(job.stock) +
         static_cast<int64_t>(job.steps.size() * sizeof(job.steps[0]));
}

}  // namespace

std::shared_ptr<PreparedJobs::Entry> PreparedJobs::Find(const MillInput& input) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
    return entry->digest == input.digest && entry->how == input.settings.how;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    auto entry = std::make_shared<Entry>();
    entry->digest = input.digest;
    entry->how = input.settings.how;
    entries_.push_front(std::move(entry));
  }
  return entries_.front();
}

/// Says what an entry takes, and lets go of the oldest ones; of 0 bytes: of itself.
void PreparedJobs::Made(const std::shared_ptr<Entry>& entry, int64_t bytes) {
  const std::lock_guard lock(mutex_);
  entry->bytes = bytes;
  if (bytes == 0) entries_.remove(entry);
  int64_t held = 0;
  for (auto it = entries_.begin(); it != entries_.end();) {
    held += (*it)->bytes;
    const bool goes = held > most_bytes_ && it != entries_.begin() && (*it)->bytes > 0;
    if (goes) held -= (*it)->bytes;
    it = goes ? entries_.erase(it) : std::next(it);
  }
}

absl::StatusOr<std::shared_ptr<const MillingJob>> PreparedJobs::Get(const MillInput& input,
                                                                    const CancelToken& cancel) {
  const std::shared_ptr<Entry> entry = Find(input);
  const std::lock_guard lock(entry->making);
  if (entry->job) return entry->job;
  std::optional<TriangleMesh> stock;
  if (!input.stock.triangles.empty()) stock = InMm(input.stock);
  auto job = PrepareMilling(InMm(input.part), std::move(stock), input.settings.how, cancel);
  if (!job.ok()) {
    Made(entry, 0);
    return job.status();
  }
  entry->job = std::make_shared<const MillingJob>(*std::move(job));
  Made(entry, BytesOf(*entry->job));
  return entry->job;
}

int64_t PreparedJobs::bytes() const {
  const std::lock_guard lock(mutex_);
  int64_t held = 0;
  for (const auto& entry : entries_) held += entry->bytes;
  return held;
}

}  // namespace slicefarm::milling
