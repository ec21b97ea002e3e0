#include "services/slicing/algo/topology/edge_table.h"

#include <algorithm>

namespace slicefarm::slicing {
namespace {

/// Half-edge in the bucket of its lower vertex.
struct Entry {
  uint32_t far = 0;  ///< upper vertex
  /// 2 * half-edge, plus 1 if the half-edge leads from the upper to the lower vertex
  uint32_t code = 0;

  uint32_t half_edge() const { return code / 2; }
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

/// Entries in the order of their lower vertex; `ends[v]` is the end of the bucket of v.
struct Buckets {
  std::vector<Entry> entries;
  std::vector<uint32_t> ends;
};

Buckets SortByLowerVertex(std::span<const Triangle> triangles, size_t vertex_count) {
  Buckets buckets;
  buckets.ends.assign(vertex_count + 1, 0);
  // Element v + 1 counts the entries of v. So after summing, each element is the start of its
  // bucket, and after filling, its end.
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) ++buckets.ends[std::min(t[i], t[(i + 1) % 3]) + 1];
  for (size_t v = 1; v <= vertex_count; ++v) buckets.ends[v] += buckets.ends[v - 1];
  buckets.entries.resize(3 * triangles.size());
  uint32_t half_edge = 0;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i, ++half_edge) {
      const uint32_t from = t[i], to = t[(i + 1) % 3];
      const bool down = from > to;
      buckets.entries[buckets.ends[down ? to : from]++] = {down ? from : to, 2 * half_edge + down};
    }
  }
  return buckets;
}

void SortBucket(std::span<Entry> bucket) {
  constexpr size_t kFewEntries = 24;
  if (bucket.size() > kFewEntries) {
    std::sort(bucket.begin(), bucket.end());
    return;
  }
  for (size_t i = 1; i < bucket.size(); ++i) {
    const Entry moving = bucket[i];
    size_t j = i;
    for (; j > 0 && moving.far < bucket[j - 1].far; --j) bucket[j] = bucket[j - 1];
    bucket[j] = moving;
  }
}

/// Adds the half-edges of one edge to the table.
void AddEdge(std::span<const Entry> edge, EdgeTable& table) {
  if (edge.size() == 2) {
    table.twins[edge[0].half_edge()] = edge[1].half_edge();
    table.twins[edge[1].half_edge()] = edge[0].half_edge();
    table.conflicts += edge[0].code % 2 == edge[1].code % 2;
  } else if (edge.size() == 1) {
    ++table.open_edges;
  } else {
    for (const Entry& entry : edge) table.fans.push_back(entry.half_edge());
    table.fan_starts.push_back(static_cast<uint32_t>(table.fans.size()));
  }
}

}  // namespace

EdgeTable BuildEdgeTable(std::span<const Triangle> triangles, size_t vertex_count) {
  Buckets buckets = SortByLowerVertex(triangles, vertex_count);
  EdgeTable table;
  table.twins.assign(3 * triangles.size(), kNoTwin);
  uint32_t begin = 0;
  for (size_t v = 0; v < vertex_count; ++v) {
    const uint32_t end = buckets.ends[v];
    const std::span<Entry> bucket(buckets.entries.data() + begin, end - begin);
    SortBucket(bucket);
    for (size_t from = 0; from < bucket.size();) {
      size_t to = from + 1;
      while (to < bucket.size() && bucket[to].far == bucket[from].far) ++to;
      AddEdge(bucket.subspan(from, to - from), table);
      from = to;
    }
    begin = end;
  }
  return table;
}

}  // namespace slicefarm::slicing
