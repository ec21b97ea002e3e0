#include "services/beading/algo/island_memo.h"

#include <algorithm>
#include <utility>

namespace slicefarm::beading {
namespace {

uint64_t Mixed(uint64_t digest, uint64_t value) {
  return (digest ^ value) * 0x9e3779b97f4a7c15u ^ digest >> 29;
}

/// Returns a digest of some points of an outline.
uint64_t DigestOf(const PolygonWithHoles& outline) {
  uint64_t digest = Mixed(outline.outer.size(), outline.holes.size());
  const auto add = [&digest](const Polygon& ring) {
    for (const Point p : {ring.front(), ring[ring.size() / 2]})
      digest = Mixed(Mixed(digest, static_cast<uint64_t>(p.x)), static_cast<uint64_t>(p.y));
  };
  add(outline.outer);
  std::ranges::for_each(outline.holes, add);
  return digest;
}

}  // namespace

IslandMemo::RadiusOf IslandMemo::Noting(RadiusOf ask) {
  return [this, ask = std::move(ask)](double x, double y, double radius_nm) {
    const double deciding = ask(x, y, radius_nm);
    answers_.push_back({x, y, radius_nm, deciding});
    return deciding;
  };
}

const KnownIsland* IslandMemo::Find(const IslandKey& key, const RadiusOf& ask) {
  answers_.clear();
  const KnownIsland* known = FindIn(current_, key, ask, current_);
  return known != nullptr ? known : FindIn(before_, key, ask, current_);
}

const KnownIsland* IslandMemo::FindIn(Entries& entries, const IslandKey& key, const RadiusOf& ask,
                                      Entries& found) {
  const auto [begin, end] = entries.equal_range(DigestOf(key.outline));
  for (auto at = begin; at != end; ++at) {
    const Entry& entry = at->second;
    const bool known =
        entry.key == key && std::ranges::all_of(entry.answers, [&](const Answer& answer) {
          return ask(answer.x, answer.y, answer.radius_nm) == answer.deciding_nm;
        });
    if (!known) continue;
    return &(&entries == &found ? at : found.insert(entries.extract(at)))->second.island;
  }
  return nullptr;
}

void IslandMemo::Keep(IslandKey key, KnownIsland island) {
  const uint64_t digest = DigestOf(key.outline);
  current_.emplace(digest, Entry{std::move(key), std::exchange(answers_, {}), std::move(island)});
}

void IslandMemo::NextLayer() { before_ = std::exchange(current_, {}); }

}  // namespace slicefarm::beading
