#include "services/infill/algo/linking/link_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/lines/shortened.h"

namespace slicefarm::infill {
namespace {

/// A piece keeps this share of its length when both of its corners are cut.
constexpr double kLeastKept = 0.2;
/// Shorter cuts are not worth their corners.
constexpr double kLeastCutNm = 50'000;
/// A cut ends on the edge; looked at is what lies before that.
constexpr double kBeforeEdge = 0.99;

/// Where a piece ends once `cut_nm` is cut off at one of its ends.
Point CutEnd(const Piece& piece, double length, bool at_start, double cut_nm) {
  const Polyline left =
      Shortened(piece.points, length, at_start ? cut_nm : 0, at_start ? 0 : cut_nm);
  return at_start ? left.front() : left.back();
}

class Shaper {
 public:
  Shaper(const EdgeEnds& ends, const EdgeIndex& edges, double cut_nm)
      : ends_(ends), edges_(edges), cut_nm_(cut_nm) {}

  LinkShape Shape(int32_t stretch) const {
    LinkShape shape{stretch, 0, 0, ends_.StretchPoints(stretch)};
    const double length = Length(shape.way);
    const double along = std::min(cut_nm_, length / 2);
    const Polyline middle = Shortened(shape.way, length, along, along);
    const Corner from = CutCorner(stretch, middle.front(), along);
    const Corner to = CutCorner(ends_.Next(stretch), middle.back(), along);
    Polyline way = Shortened(shape.way, length, from.cut_nm > 0 ? along : 0,
                             to.cut_nm > 0 ? along : 0);
    if (from.cut_nm > 0) way.insert(way.begin(), from.inside);
    if (to.cut_nm > 0) way.push_back(to.inside);
    shape.from_cut_nm = from.cut_nm;
    shape.to_cut_nm = to.cut_nm;
    shape.way = std::move(way);
    shape.length_nm = Length(shape.way);
    return shape;
  }

 private:
  struct Corner {
    Point inside;  ///< where the piece ends then
    double cut_nm = 0;
  };

  /// Cuts off the corner between the end of a piece and a place `along_nm` further on the edge, if
  /// that can be.
  Corner CutCorner(int32_t end, Point on_edge, double along_nm) const {
    if (along_nm < kLeastCutNm) return {};
    const Piece& piece = ends_.PieceAt(end / 2);
    const double length = Length(piece.points);
    const double cut_nm = std::min(along_nm, (1 - kLeastKept) / 2 * length);
    if (cut_nm < kLeastCutNm) return {};
    const Point inside = CutEnd(piece, length, end % 2 == 0, cut_nm);
    if (edges_.Meets(inside, PointBetween(inside, on_edge, kBeforeEdge))) return {};
    return {inside, cut_nm};
  }

  const EdgeEnds& ends_;
  const EdgeIndex& edges_;
  const double cut_nm_;
};

}  // namespace

std::vector<LinkShape> ShapeLinks(const EdgeEnds& ends, const Links& links,
                                  const EdgeIndex& edges, double cut_nm) {
  const Shaper shaper(ends, edges, cut_nm);
  std::vector<LinkShape> shapes;
  for (const int32_t end : ends.OnEdge())
    if (links[static_cast<size_t>(end)]) shapes.push_back(shaper.Shape(end));
  return shapes;
}

}  // namespace slicefarm::infill
