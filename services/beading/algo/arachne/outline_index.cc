#include "services/beading/algo/arachne/outline_index.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <limits>
#include <vector>

namespace slicefarm::beading {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using BoostSegment = bg::model::segment<BoostPoint>;

BoostPoint ToBoost(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

std::vector<BoostSegment> SegmentsOf(const MultiPolygon& outlines) {
  std::vector<BoostSegment> segments;
  ForEachRing(outlines, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      segments.emplace_back(ToBoost(ring[i]), ToBoost(ring[i + 1 == ring.size() ? 0 : i + 1]));
  });
  return segments;
}

}  // namespace

struct OutlineIndex::Tree {
  bg::index::rtree<BoostSegment, bg::index::quadratic<16>> segments;
};

OutlineIndex::OutlineIndex(const MultiPolygon& outlines)
    : tree_(std::make_unique<Tree>(Tree{decltype(Tree::segments)(SegmentsOf(outlines))})) {}
OutlineIndex::~OutlineIndex() = default;
OutlineIndex::OutlineIndex(OutlineIndex&&) noexcept = default;
OutlineIndex& OutlineIndex::operator=(OutlineIndex&&) noexcept = default;

double OutlineIndex::DistanceFrom(double x, double y) const {
  const BoostPoint place(x, y);
  const auto nearest = tree_->segments.qbegin(bg::index::nearest(place, 1));
  return nearest == tree_->segments.qend() ? std::numeric_limits<double>::infinity()
                                           : bg::distance(place, *nearest);
}

}  // namespace slicefarm::beading
