#include "services/infill/algo/lines/clip_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"

namespace slicefarm::infill {
namespace {

constexpr Coord kClipSquareNm = 1'000'000;

/// Scale and shift of curves relative to the region. A curve may run exactly through a corner or
/// along an edge. So that neighbouring segments agree on the curve's side, curves are shifted by
/// less than a nanometre, in a direction that almost no edge has. The test of sides is still exact.
constexpr Coord kScale = 1024;
constexpr Point kAside{313, 511};
Point OfRegion(Point p) { return {kScale * p.x, kScale * p.y}; }
Point OfCurve(Point p) { return OfRegion(p) + kAside; }

/// Crossing of a curve's segment and an edge.
struct Meeting {
  double t = 0;  ///< position along the segment, in [0, 1]
  EdgePosition place;
  bool enters = false;
};

class Clipper {
 public:
  explicit Clipper(const MultiPolygon& region) : region_(region), edges_(region, kClipSquareNm) {}

  void Clip(const Curve& curve) {
    current_ = {};
    current_.points.clear();
    state_ = State::kUnknown;
    head_.clear();
    const size_t count = curve.points.size();
    Append(curve.points[0]);
    for (size_t i = 1; i < count + (curve.closed ? 1 : 0); ++i)
      Follow(curve.points[i - 1], curve.points[i == count ? 0 : i]);
    Finish(curve);
  }

  std::vector<Piece> Take() { return std::move(pieces_); }

 private:
  enum class State { kUnknown, kInside, kOutside };

  /// Adds a point to the current piece, or to the head of the curve if its side is still unknown.
  void Append(Point p) {
    if (state_ == State::kOutside) return;
    Polyline& points = state_ == State::kUnknown ? head_ : current_.points;
    if (points.empty() || points.back() != p) points.push_back(p);
  }

  void Follow(Point p, Point q) {
    FindMeetings(p, q);
    for (const Meeting& meeting : meetings_) {
      const Point at{p.x + std::llround(meeting.t * static_cast<double>(q.x - p.x)),
                     p.y + std::llround(meeting.t * static_cast<double>(q.y - p.y))};
      if (meeting.enters) {
        current_ = {};
        current_.from = meeting.place;
        state_ = State::kInside;
        Append(at);
      } else if (state_ != State::kOutside) {
        Append(at);
        if (state_ == State::kUnknown) {
          head_end_ = meeting.place;
        } else {
          current_.to = meeting.place;
          Emit(std::move(current_));
        }
        state_ = State::kOutside;
      }
    }
    Append(q);
  }

  void FindMeetings(Point p, Point q) {
    near_.clear();
    meetings_.clear();
    Box box;
    box.Add(p), box.Add(q);
    box = box.Grown(1);
    edges_.ForEachNear(box, [this](int32_t edge) { near_.push_back(edge); });
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    const Point from = OfCurve(p), to = OfCurve(q);
    for (const int32_t number : near_) {
      const EdgeIndex::Edge& edge = edges_.At(number);
      Box of_edge;
      of_edge.Add(edge.a), of_edge.Add(edge.b);
      if (!of_edge.Intersects(box)) continue;
      const Point a = OfRegion(edge.a), b = OfRegion(edge.b);
      const bool p_in = Orientation(a, b, from) >= 0, q_in = Orientation(a, b, to) >= 0;
      if (p_in == q_in || (Orientation(from, to, a) >= 0) == (Orientation(from, to, b) >= 0))
        continue;
      const double dp = Cross(b - a, from - a), dq = Cross(b - a, to - a);
      const double t = dp == dq ? 0.5 : std::clamp(dp / (dp - dq), 0.0, 1.0);
      meetings_.push_back({t, {edge.ring, edge.edge}, q_in});
    }
    std::stable_sort(meetings_.begin(), meetings_.end(),
                     [](const Meeting& a, const Meeting& b) { return a.t < b.t; });
  }

  void Finish(const Curve& curve) {
    if (state_ == State::kUnknown) {  // no edge was met
      const Point p = curve.points[0];
      for (const PolygonWithHoles& island : region_) {
        if (Locate(p, island) == Side::kOutside) continue;
        Piece whole{curve.points};
        whole.closed = curve.closed;
        Emit(std::move(whole));
        return;
      }
      return;
    }
    if (state_ == State::kInside && !curve.closed) Emit(std::exchange(current_, {}));
    if (head_end_.ring < 0) return;
    // The curve began inside. A closed curve returns to its beginning.
    Piece first{std::exchange(head_, {}), {}, std::exchange(head_end_, {})};
    if (curve.closed) {
      if (state_ != State::kInside) return;
      first.from = current_.from;
      Polyline& points = current_.points;
      if (!points.empty() && points.back() == first.points.front()) points.pop_back();
      first.points.insert(first.points.begin(), points.begin(), points.end());
    }
    Emit(std::move(first));
  }

  void Emit(Piece piece) {
    if (piece.points.size() >= 2) pieces_.push_back(std::move(piece));
  }

  const MultiPolygon& region_;
  const EdgeIndex edges_;
  std::vector<int32_t> near_;
  std::vector<Meeting> meetings_;
  State state_ = State::kUnknown;
  Piece current_;
  Polyline head_;  ///< points from the curve's beginning to the first edge
  EdgePosition head_end_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> ClipCurves(const MultiPolygon& region, std::span<const Curve> curves) {
  if (region.empty()) return {};
  Clipper clipper(region);
  for (const Curve& curve : curves)
    if (curve.points.size() >= 2) clipper.Clip(curve);
  return clipper.Take();
}

}  // namespace slicefarm::infill
