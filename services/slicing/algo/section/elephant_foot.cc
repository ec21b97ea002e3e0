#include "services/slicing/algo/section/elephant_foot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "services/slicing/algo/section/local_width.h"

namespace slicefarm::slicing {
namespace {

constexpr Coord kSampleNm = 100'000;       // initial distance of samples along thin places
constexpr Coord kFinestSampleNm = 10'000;  // smallest distance, for discontinuous shrinkage
constexpr double kToleranceNm = 500;       // error of the shrinkage between samples
constexpr double kSlope = 0.5;             // largest slope of the shrinkage along an outline
constexpr double kCosOfCorner = 0.5;       // an outline that turns by 60 degrees has a corner
constexpr double kOverlapNm = 50;          // overlap of strips, so that no crack remains
constexpr Coord kCrumbNm = 50'000;         // half of the largest width of tips that break off
constexpr double kArcToleranceNm = 2'500;
constexpr Coord kSearchNm = 100;  // accuracy of the search for the largest shrinkage

/// Shrinkage (depth) of the outline at a point of an edge.
struct Sample {
  double at_nm = 0;  ///< distance from the edge's start
  double depth_nm = 0;
};

/// Shrinkage of the outlines of one island.
class Shrinkage {
 public:
  Shrinkage(const PolygonWithHoles& island, Coord compensation_nm, Coord min_width_nm,
            OppositeAngles angles)
      : width_(island, min_width_nm + 2 * compensation_nm, angles),
        compensation_nm_(static_cast<double>(compensation_nm)),
        min_width_nm_(static_cast<double>(min_width_nm)) {
    for (const OutlineEdge& edge : width_.edges()) samples_.push_back(SamplesOf(edge));
    Ramp();
  }

  /// Returns true if all outlines move by the whole compensation.
  bool IsEven() const {
    return std::all_of(samples_.begin(), samples_.end(), [&](const std::vector<Sample>& samples) {
      return std::all_of(samples.begin(), samples.end(),
                         [&](Sample s) { return s.depth_nm == compensation_nm_; });
    });
  }

  /// Returns the areas to remove, as rings that may overlap.
  std::vector<Polygon> Strips() const {
    std::vector<Polygon> strips;
    for (size_t i = 0; i < samples_.size(); ++i) {
      AppendStrips(width_.edges()[i], samples_[i], strips);
      AppendFan(width_.edges()[i], samples_[i].back().depth_nm, strips);
    }
    return strips;
  }

 private:
  static Point On(const OutlineEdge& edge, double at_nm, double depth_nm) {
    return {edge.from.x + std::llround(edge.along.x() * at_nm + edge.inward.x() * depth_nm),
            edge.from.y + std::llround(edge.along.y() * at_nm + edge.inward.y() * depth_nm)};
  }

  Sample SampleAt(const OutlineEdge& edge, double at_nm, Point p,
                  const std::vector<int32_t>& opposite) const {
    const double width = width_.At(edge, p, opposite);
    return {at_nm, std::clamp((width - min_width_nm_) / 2, 0.0, compensation_nm_)};
  }

  /// Appends samples after `begin` up to `end`, so close that linear interpolation between them is
  /// sufficient.
  void Refine(const OutlineEdge& edge, Sample begin, Sample end,
              const std::vector<int32_t>& opposite, std::vector<Sample>& samples) const {
    const double middle = (begin.at_nm + end.at_nm) / 2;
    const Sample found = SampleAt(edge, middle, On(edge, middle, 0), opposite);
    const double straight = (begin.depth_nm + end.depth_nm) / 2;
    if (std::abs(found.depth_nm - straight) <= kToleranceNm) {
      samples.push_back(end);
    } else if (end.at_nm - begin.at_nm > kFinestSampleNm) {
      Refine(edge, begin, found, opposite, samples);
      Refine(edge, found, end, opposite, samples);
    } else {  // there is a step in this interval
      const double low = std::min({begin.depth_nm, found.depth_nm, end.depth_nm});
      samples.back().depth_nm = std::min(samples.back().depth_nm, low);
      samples.push_back({end.at_nm, low});
    }
  }

  /// Appends samples of a piece of an edge that has the same opposite edges over its whole length.
  void AppendPiece(const OutlineEdge& edge, double end_nm, Point to,
                   const std::vector<int32_t>& opposite, std::vector<Sample>& samples) const {
    const double begin_nm = samples.back().at_nm;
    const int pieces = opposite.empty() ? 1 : 1 + static_cast<int>((end_nm - begin_nm) / kSampleNm);
    for (int i = 1; i <= pieces; ++i) {
      const double at = begin_nm + (end_nm - begin_nm) * i / pieces;
      const Sample end = SampleAt(edge, at, i == pieces ? to : On(edge, at, 0), opposite);
      if (opposite.empty())
        samples.push_back(end);
      else
        Refine(edge, samples.back(), end, opposite, samples);
    }
  }

  std::vector<Sample> SamplesOf(const OutlineEdge& edge) const {
    const double length = Distance(edge.from, edge.to);
    const int pieces = 1 + static_cast<int>(length / static_cast<double>(width_.limit_nm()));
    std::vector<Sample> samples;
    Point from = edge.from;
    for (int i = 0; i < pieces; ++i) {
      const double end = length * (i + 1) / pieces;
      const Point to = i + 1 == pieces ? edge.to : On(edge, end, 0);
      const std::vector<int32_t> opposite = width_.Opposite(edge, from, to);
      if (samples.empty()) samples.push_back(SampleAt(edge, 0, from, opposite));
      AppendPiece(edge, end, to, opposite, samples);
      from = to;
    }
    return samples;
  }

  /// Returns true if the shrinkage must be continuous at the edge's end. It may jump only at convex
  /// corners.
  static bool GoesOn(const OutlineEdge& edge) {
    const Vector2 a = edge.inward, b = edge.inward_after;
    return edge.reflex_to || a.x() * b.x() + a.y() * b.y() > kCosOfCorner;
  }

  /// Limits the depths so that they rise by no more than kSlope, beginning with `start_nm`.
  static std::vector<Sample> RampedUp(const std::vector<Sample>& samples, double start_nm) {
    std::vector<Sample> ramped = {{samples[0].at_nm, start_nm}};
    for (size_t i = 1; i < samples.size(); ++i) {
      const auto [t0, d0] = samples[i - 1];
      const auto [t1, d1] = samples[i];
      const double low = ramped.back().depth_nm, risen = low + kSlope * (t1 - t0);
      if (risen >= d1 && low < d0) {
        const double x = (d0 - low) * (t1 - t0) / (kSlope * (t1 - t0) - (d1 - d0));
        if (x < t1 - t0) ramped.push_back({t0 + x, low + kSlope * x});
      }
      ramped.push_back({t1, std::min(d1, risen)});
    }
    return ramped;
  }

  /// Returns the samples in reverse order, measured from the edge's other end.
  static std::vector<Sample> Reversed(const std::vector<Sample>& samples) {
    std::vector<Sample> reversed;
    reversed.reserve(samples.size());
    for (auto it = samples.rbegin(); it != samples.rend(); ++it)
      reversed.push_back({samples.back().at_nm - it->at_nm, it->depth_nm});
    return reversed;
  }

  /// Limits the slope along each ring, in two rounds in each direction. One round is not enough if
  /// the smallest depth is not at the ring's start.
  void Ramp() {
    const std::vector<OutlineEdge>& edges = width_.edges();
    std::vector<double> start(edges.size());
    for (size_t i = 0; i < edges.size(); ++i) start[i] = samples_[i].front().depth_nm;
    for (size_t k = 0; k < 2 * edges.size(); ++k) {
      const size_t i = k % edges.size();
      samples_[i] = RampedUp(samples_[i], start[i]);
      start[i] = samples_[i].front().depth_nm;
      double& next = start[edges[i].next];
      if (GoesOn(edges[i])) next = std::min(next, samples_[i].back().depth_nm);
    }
    for (size_t k = 2 * edges.size(); k-- > 0;) {
      const size_t i = k % edges.size();
      double end = samples_[i].back().depth_nm;
      if (GoesOn(edges[i])) end = std::min(end, samples_[edges[i].next].front().depth_nm);
      samples_[i] = Reversed(RampedUp(Reversed(samples_[i]), end));
    }
  }

  static void AppendStrip(const OutlineEdge& edge, std::vector<Sample>::const_iterator first,
                          std::vector<Sample>::const_iterator last, std::vector<Polygon>& strips) {
    Polygon strip = {On(edge, first->at_nm, -kOverlapNm),
                     On(edge, std::prev(last)->at_nm, -kOverlapNm)};
    for (auto it = last; it != first; --it)
      strip.push_back(On(edge, std::prev(it)->at_nm, std::prev(it)->depth_nm));
    strips.push_back(std::move(strip));
  }

  /// Appends one strip for each run of samples that are not all zero.
  static void AppendStrips(const OutlineEdge& edge, const std::vector<Sample>& samples,
                           std::vector<Polygon>& strips) {
    const auto zero = [](Sample s) { return s.depth_nm == 0; };
    auto it = samples.begin();
    while (true) {
      it = std::find_if_not(it, samples.end(), zero);
      if (it == samples.end()) return;
      auto end = std::find_if(it, samples.end(), zero);
      const auto first = it == samples.begin() ? it : std::prev(it);
      if (end != samples.end()) ++end;
      AppendStrip(edge, first, end, strips);
      it = std::prev(end);
      if (it->depth_nm != 0) return;
    }
  }

  /// Appends the sector between the strips of two edges that meet at a reflex corner.
  static void AppendFan(const OutlineEdge& edge, double depth_nm, std::vector<Polygon>& strips) {
    if (!edge.reflex_to || depth_nm == 0) return;
    const Vector2 a = edge.inward, b = edge.inward_after;
    const double turn =
        Atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());  // always negative
    const double step = 2 * Acos(1 - std::min(1.0, kArcToleranceNm / depth_nm));
    const int steps = std::max(1, static_cast<int>(std::ceil(-turn / step)));
    const Vector2 along_after = {b.y(), -b.x()};
    const auto at = [&](double x, double y) {
      return Point{edge.to.x + std::llround(x), edge.to.y + std::llround(y)};
    };
    Polygon fan = {at(-(a.x() + b.x()) * kOverlapNm, -(a.y() + b.y()) * kOverlapNm)};
    // The sector extends into the strips at both ends.
    fan.push_back(at(b.x() * depth_nm + along_after.x() * kOverlapNm,
                     b.y() * depth_nm + along_after.y() * kOverlapNm));
    for (int i = steps; i >= 0; --i) {
      const double angle = turn * i / steps, c = Cos(angle), s = Sin(angle);
      fan.push_back(at((a.x() * c - a.y() * s) * depth_nm, (a.x() * s + a.y() * c) * depth_nm));
    }
    fan.push_back(at(a.x() * depth_nm - edge.along.x() * kOverlapNm,
                     a.y() * depth_nm - edge.along.y() * kOverlapNm));
    if (SignedArea(fan) < 0) std::reverse(fan.begin(), fan.end());
    strips.push_back(std::move(fan));
  }

  LocalWidth width_;
  double compensation_nm_;
  double min_width_nm_;
  std::vector<std::vector<Sample>> samples_;  ///< samples per edge; at least two
};

/// Returns the largest shrinkage, up to the compensation, that leaves the island's widest point at
/// least min_width wide.
Coord LargestShrinkage(const MultiPolygon& island, Coord compensation_nm, Coord min_width_nm) {
  const auto leaves = [&](Coord shrinkage_nm) {
    return !Offset(island, -(shrinkage_nm + min_width_nm / 2), {.join = Join::kRound}).empty();
  };
  if (leaves(compensation_nm)) return compensation_nm;
  if (!leaves(0)) return 0;
  Coord least = 0, most = compensation_nm;
  while (most - least > kSearchNm) {
    const Coord middle = (least + most) / 2;
    (leaves(middle) ? least : most) = middle;
  }
  return least;
}

/// Returns the island without the removed strips. Returns nothing if the result is not one island
/// with the original number of holes.
std::optional<PolygonWithHoles> Shrunk(const PolygonWithHoles& island, Coord compensation_nm,
                                       Coord min_width_nm, OppositeAngles angles) {
  const Shrinkage shrinkage(island, compensation_nm, min_width_nm, angles);
  MultiPolygon rest = shrinkage.IsEven()
                          ? Offset({island}, -compensation_nm, {.join = Join::kRound})
                          : Difference({island}, Union(shrinkage.Strips(), FillRule::kNonZero));
  if (rest.size() > 1) {
    std::erase_if(rest,
                  [](const PolygonWithHoles& piece) { return Offset({piece}, -kCrumbNm).empty(); });
  }
  if (rest.size() != 1 || rest[0].holes.size() != island.holes.size()) return std::nullopt;
  return std::move(rest[0]);
}

PolygonWithHoles IslandCompensated(const PolygonWithHoles& island, Coord compensation_nm,
                                   Coord min_width_nm) {
  Coord shrinkage_nm = LargestShrinkage({island}, compensation_nm, min_width_nm);
  OppositeAngles angles = kBelow60Degrees;
  for (int tries = 0; tries < 5 && shrinkage_nm > 0; ++tries) {
    if (auto shrunk = Shrunk(island, shrinkage_nm, min_width_nm, angles)) return *std::move(shrunk);
    if (tries > 0) shrinkage_nm /= 2;
    angles = kBelow90Degrees;
  }
  return island;
}

}  // namespace

MultiPolygon ElephantFootCompensated(const MultiPolygon& outlines, Coord compensation_nm,
                                     Coord min_width_nm) {
  if (compensation_nm <= 0) return outlines;
  MultiPolygon compensated;
  compensated.reserve(outlines.size());
  for (const PolygonWithHoles& island : outlines)
    compensated.push_back(
        IslandCompensated(island, compensation_nm, std::max<Coord>(min_width_nm, 0)));
  Canonicalize(compensated);
  return compensated;
}

}  // namespace slicefarm::slicing
