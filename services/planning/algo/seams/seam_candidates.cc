#include "services/planning/algo/seams/seam_candidates.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "common/geometry/covers.h"
#include "services/planning/algo/rings/ring_shape.h"

namespace slicefarm::planning {
namespace {

constexpr double kSpacingNm = 2'000'000;
constexpr double kPaintedSpacingNm = 250'000;
constexpr double kMaxCandidates = 100;
constexpr double kMaxPaintedCandidates = 400;
constexpr double kMinCandidates = 8;
/// Largest number of corners per ring. Of more corners the sharpest are kept.
constexpr size_t kMostCorners = 200;
/// Distance in the plane over which rings are linked and overhangs are measured.
constexpr Coord kReachNm = 2'000'000;
/// Two points nearer than this become one, as a share of the spacing.
constexpr double kTooClose = 0.4;
/// Between two points farther apart than this, points are added, in spacings.
constexpr double kTooFar = 1.5;
/// Distance below which two corners count as one.
constexpr double kSameCornerNm = 100'000;

/// Distance below which a place counts as a point of the ring.
constexpr double kSamePointNm = 50'000;

/// Reasons for a point on a ring, the weakest first. kOver: above a point of the layer below.
/// kCorner: at a corner. kOverCorner: at a ring point above a corner of the layer below. A
/// kOverCorner point stays even beside a close corner. The reason is that the two corners of a
/// bevel are nearly equally sharp, and either may be the sharper one on a given layer. A line of
/// seams must be able to stay on one of them.
enum class Wish { kOver, kOverCorner, kCorner };

/// Requested point, given by its length along a ring.
struct Along {
  double nm = 0;
  Wish wish = Wish::kOver;
};

std::vector<Corner> CornersOf(const RingShape& shape) {
  std::vector<Corner> corners = shape.Corners();
  if (corners.size() <= kMostCorners) return corners;
  std::ranges::stable_sort(corners, std::greater(),
                           [](const Corner& corner) { return std::abs(corner.turn_rad); });
  corners.resize(kMostCorners);
  return corners;
}

double SpacingOn(const RingShape& shape, bool painted) {
  const double length = shape.length_nm();
  const double spacing = painted ? std::max(kPaintedSpacingNm, length / kMaxPaintedCandidates)
                                 : std::max(kSpacingNm, length / kMaxCandidates);
  return std::min(spacing, length / kMinCandidates);
}

/// Merges points that are too close and fills gaps that are too wide. Corners are kept. Returns the
/// lengths along the ring, ascending.
std::vector<double> Spread(std::vector<Along> wanted, const RingShape& shape, double spacing) {
  std::ranges::sort(wanted, {}, [](const Along& a) { return std::pair(a.nm, a.wish); });
  std::vector<Along> kept;
  for (const Along& along : wanted) {
    if (!kept.empty()) {
      Along& last = kept.back();
      const bool two_corners = along.wish != Wish::kOver && last.wish != Wish::kOver;
      if (along.nm - last.nm < (two_corners ? kSameCornerNm : kTooClose * spacing)) {
        if (along.wish > last.wish) last = along;
        continue;
      }
    }
    kept.push_back(along);
  }
  if (kept.empty()) kept.push_back({});
  std::vector<double> all;
  for (size_t i = 0; i < kept.size(); ++i) {
    const double from = kept[i].nm;
    const double to = i + 1 < kept.size() ? kept[i + 1].nm : kept.front().nm + shape.length_nm();
    all.push_back(from);
    if (to - from <= kTooFar * spacing) continue;
    const auto pieces = static_cast<int>(std::lround((to - from) / spacing));
    for (int k = 1; k < pieces; ++k) all.push_back(from + (to - from) * k / pieces);
  }
  for (double& nm : all)
    if (nm >= shape.length_nm()) nm -= shape.length_nm();
  std::ranges::sort(all);
  return all;
}

/// Stores in enforced points their distance from the middle of their section of the ring. A ring
/// that is enforced all around has no sections. `along`: lengths of the points along the ring,
/// ascending.
void MeasureRuns(const std::vector<double>& along, double length_nm,
                 std::vector<SeamCandidate>& candidates) {
  const size_t n = candidates.size();
  const auto free = std::ranges::find(candidates, false, &SeamCandidate::enforced);
  if (free == candidates.end()) return;
  const auto start = static_cast<size_t>(free - candidates.begin());
  const auto at = [&](size_t i) { return along[i % n] + (i < n ? 0 : length_nm); };
  for (size_t first = start; first < start + n; ++first) {
    if (!candidates[first % n].enforced) continue;
    size_t end = first + 1;
    while (candidates[end % n].enforced) ++end;
    const double middle = (at(first) + at(end - 1)) / 2;
    for (; first < end; ++first)
      candidates[first % n].off_middle_mm = static_cast<float>(ToMm(std::abs(at(first) - middle)));
  }
}

/// Rings of one layer, with the points requested on them so far.
class LayerRings {
 public:
  explicit LayerRings(const ObjectSection& section)
      : section_(section), outlines_(OutlineOf(section)) {
    ForEachRing(outlines_, [&](const Polygon& ring) {
      shapes_.emplace_back(ring);
      std::vector<Along>& wanted = wanted_.emplace_back();
      for (const Corner& corner : CornersOf(shapes_.back()))
        wanted.push_back({corner.along_nm, Wish::kCorner});
      const auto rear =
          std::ranges::min_element(ring, {}, [](Point p) { return std::pair(-p.y, p.x); });
      wanted.push_back({shapes_.back().AlongTo(static_cast<size_t>(rear - ring.begin()))});
    });
    votes_.resize(shapes_.size());
  }

  size_t size() const { return shapes_.size(); }

  /// Adds a point above a point of ring `ring_below` in the layer below. `hit`: nearest point of
  /// this layer.
  void Continue(int32_t ring_below, bool from_corner, const RegionEdges::Hit& hit) {
    const auto ring = static_cast<size_t>(hit.ring);
    const auto edge = static_cast<size_t>(hit.edge);
    const double from = shapes_[ring].AlongTo(edge), to = shapes_[ring].AlongTo(edge + 1);
    const double nm = from + hit.share * (to - from);
    const double end = hit.share < 0.5 ? from : to;
    const bool over_corner = from_corner && std::abs(end - nm) < kSamePointNm;
    wanted_[ring].push_back(over_corner ? Along{end, Wish::kOverCorner} : Along{nm, Wish::kOver});
    votes_[ring][ring_below] += kReachNm - hit.distance_nm;
  }

  /// Returns the ring below from which the most points continue on `ring`, weighted by nearness;
  /// -1: none.
  int32_t BelowOf(size_t ring) const {
    int32_t best = -1;
    double most = 0;
    for (const auto& [below, votes] : votes_[ring]) {
      if (votes <= most) continue;
      best = below;
      most = votes;
    }
    return best;
  }

  std::vector<SeamCandidate> CandidatesOn(size_t ring) {
    const RingShape& shape = shapes_[ring];
    const MultiPolygon& enforcers = MarkedIn(section_, PartRole::kSeamEnforcer);
    const MultiPolygon& blockers = MarkedIn(section_, PartRole::kSeamBlocker);
    const bool painted = !enforcers.empty() || !blockers.empty();
    std::vector<SeamCandidate> candidates;
    const auto along = Spread(std::move(wanted_[ring]), shape, SpacingOn(shape, painted));
    candidates.reserve(along.size());
    for (const Bend& bend : shape.BendsAt(along)) {
      SeamCandidate& candidate = candidates.emplace_back();
      candidate.at = bend.at;
      candidate.turn_rad = static_cast<float>(bend.TurnRad());
      candidate.outward = static_cast<uint8_t>(bend.Outward());
      candidate.enforced = Covers(enforcers, candidate.at);
      candidate.blocked = Covers(blockers, candidate.at);
    }
    MeasureRuns(along, shape.length_nm(), candidates);
    return candidates;
  }

 private:
  const ObjectSection& section_;
  const MultiPolygon& outlines_;
  std::vector<RingShape> shapes_;
  std::vector<std::vector<Along>> wanted_;
  std::vector<std::map<int32_t, double>> votes_;  ///< votes by ring, then by ring below
};

}  // namespace

bool IsCorner(const SeamCandidate& candidate) {
  return candidate.turn_rad <= -std::numbers::pi / 12 || candidate.turn_rad >= std::numbers::pi / 6;
}

namespace {

/// Stores in a point its overhang and its distance from the layer below, at most kReachNm.
void MeasureOver(const MultiPolygon& below, const RegionEdges& edges, Coord height_nm,
                 SeamCandidate& candidate) {
  const auto hit = edges.Nearest(candidate.at, kReachNm);
  const double away_nm = hit ? hit->distance_nm : static_cast<double>(kReachNm);
  const bool inside = hit ? hit->inside : Covers(below, candidate.at);
  candidate.away_mm = static_cast<float>(ToMm(away_nm));
  candidate.overhang = inside ? 0 : static_cast<float>(away_nm / static_cast<double>(height_nm));
}

}  // namespace

std::vector<RingCandidates> SeamCandidateFinder::Next(const ObjectSection& section) {
  const MultiPolygon& outlines = OutlineOf(section);
  RegionEdges edges(outlines);
  LayerRings rings(section);
  if (below_) {
    for (size_t ring = 0; ring < below_->rings.size(); ++ring)
      for (const SeamCandidate& candidate : below_->rings[ring].candidates)
        if (const auto hit = edges.Nearest(candidate.at, kReachNm))
          rings.Continue(static_cast<int32_t>(ring), IsCorner(candidate), *hit);
  }
  std::vector<RingCandidates> found;
  for (size_t ring = 0; ring < rings.size(); ++ring)
    found.push_back({rings.BelowOf(ring), rings.CandidatesOn(ring)});
  if (below_) {
    for (RingCandidates& ring : found)
      for (SeamCandidate& candidate : ring.candidates)
        MeasureOver(below_->outlines, below_->edges, std::max<Coord>(section.height_nm, 1),
                    candidate);
  }
  below_.emplace(Below{outlines, std::move(edges), found});
  return found;
}

}  // namespace slicefarm::planning
