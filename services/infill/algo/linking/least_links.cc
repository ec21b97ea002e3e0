#include "services/infill/algo/linking/least_links.h"

#include <span>
#include <utility>
#include <vector>

namespace slicefarm::infill {
namespace {

/// Number and length of links without common ends, in a chain of consecutive edge parts.
struct ChainLinks {
  int count = 0;
  double length_nm = 0;

  bool IsBetterThan(const ChainLinks& other) const {
    return std::pair(-count, length_nm) < std::pair(-other.count, other.length_nm);
  }
};

/// Edge parts of a ring in order, and their lengths as links.
struct SpanRing {
  std::vector<int32_t> spans;
  std::vector<double> length_nm;

  size_t size() const { return spans.size(); }
};

class RingMatcher {
 public:
  RingMatcher(const SpanRing& ring, double max_link_nm) : ring_(ring), max_link_nm_(max_link_nm) {}

  /// Returns the edge parts that are links, as indices on the ring.
  std::vector<size_t> Match() const {
    const size_t count = ring_.size();
    if (count < 2) return {};
    // Without the last edge part the ring is a chain. With it, the two edge parts that share its
    // ends are excluded.
    Chosen without = OfChain(0, count - 1);
    if (!IsLink(count - 1)) return std::move(without.places);
    Chosen with = OfChain(1, count - 2);
    with.links.count += 1;
    with.links.length_nm += ring_.length_nm[count - 1];
    if (!with.links.IsBetterThan(without.links)) return std::move(without.places);
    with.places.push_back(count - 1);
    return std::move(with.places);
  }

 private:
  struct Chosen {
    ChainLinks links;
    std::vector<size_t> places;
  };

  bool IsLink(size_t place) const { return ring_.length_nm[place] <= max_link_nm_; }

  /// Returns as many links as possible, and of these the shortest, among the edge parts from
  /// `first` up to, but not including, `last`.
  Chosen OfChain(size_t first, size_t last) const {
    std::vector<ChainLinks> best(2);  // best[i + 1]: of the first i edge parts
    std::vector<bool> taken(2, false);
    for (size_t place = first; place < last; ++place) {
      ChainLinks with = best[best.size() - 2];
      with.count += 1;
      with.length_nm += ring_.length_nm[place];
      const bool is_taken = IsLink(place) && with.IsBetterThan(best.back());
      best.push_back(is_taken ? with : best.back());
      taken.push_back(is_taken);
    }
    Chosen chosen{best.back(), {}};
    for (size_t place = last; place > first; --place) {
      if (!taken[place - first + 1]) continue;
      chosen.places.push_back(place - 1);
      if (--place == first) break;
    }
    return chosen;
  }

  const SpanRing& ring_;
  const double max_link_nm_;
};

SpanRing RingFrom(const EdgeEnds& ends, int32_t first) {
  SpanRing ring;
  int32_t at = first;
  do {
    ring.spans.push_back(at);
    ring.length_nm.push_back(ends.LinkLength(at));
    at = ends.Next(at);
  } while (at != first);
  return ring;
}

}  // namespace

Links LeastLinks(const EdgeEnds& ends, double max_link_nm) {
  Links links(static_cast<size_t>(ends.size()), false);
  std::vector<bool> seen(static_cast<size_t>(ends.size()), false);
  for (const int32_t end : ends.OnEdge()) {
    if (seen[static_cast<size_t>(end)]) continue;
    const SpanRing ring = RingFrom(ends, end);
    for (const int32_t span : ring.spans) seen[static_cast<size_t>(span)] = true;
    for (const size_t place : RingMatcher(ring, max_link_nm).Match())
      links[static_cast<size_t>(ring.spans[place])] = true;
  }
  return links;
}

}  // namespace slicefarm::infill
