#include "services/motion/algo/toolpath/divided_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/geometry/between.h"
#include "common/model/bead_section.h"

namespace slicefarm::motion {
namespace {

/// Length of the shortest edge, in nm. Each edge is a line of G-code, so shorter ones cost too
/// much.
constexpr double kLeastEdgeNm = 12'500;
/// Largest ratio of the sections of two consecutive edges.
constexpr double kMostStep = 1.27;
/// Largest ratio of the widths of two consecutive edges if beads are narrower than high. Such a
/// bead's section is a disc.
constexpr double kMostDiscStep = 1.127;

struct WidePoint {
  Point point;
  Coord width_nm = 0;
};

WidePoint Between(const WidePoint& a, const WidePoint& b, double share) {
  const auto change = static_cast<double>(b.width_nm - a.width_nm);
  return {PointBetween(a.point, b.point, share), a.width_nm + std::llround(share * change)};
}

/// Divides the edges of a path, which is given point by point.
class Divider {
 public:
  Divider(Coord bead_height_nm, Path& path) : bead_height_nm_(bead_height_nm), path_(path) {}

  void Start(const WidePoint& at) { Put(at); }

  void GoTo(const WidePoint& to) {
    const WidePoint from = at_;
    const double change = std::abs(static_cast<double>(to.width_nm - from.width_nm));
    const double length = Distance(from.point, to.point);
    const auto pieces_within = [&](Coord tolerance_nm, Coord least_nm) {
      return std::min(std::ceil(change / (2.0 * static_cast<double>(tolerance_nm))),
                      std::floor(length / static_cast<double>(least_nm)));
    };
    const double pieces = std::max(pieces_within(kWidthToleranceNm, kShortBeadNm),
                                   pieces_within(kLongWidthToleranceNm, kLongBeadNm));
    for (int i = 1; i < static_cast<int>(pieces); ++i) GoEvenly(Between(from, to, i / pieces));
    GoEvenly(to);
  }

 private:
  /// Adds points up to `to`: the smallest number with which the ratio of sections is small enough.
  void GoEvenly(const WidePoint& to) {
    const WidePoint from = at_;
    const auto height = static_cast<double>(bead_height_nm_ - from.width_nm);
    if (IsDisc(from) != IsDisc(to))
      GoInOneShape(Between(from, to, height / static_cast<double>(to.width_nm - from.width_nm)));
    GoInOneShape(to);
  }

  bool IsDisc(const WidePoint& at) const { return at.width_nm < bead_height_nm_; }

  void GoInOneShape(const WidePoint& to) {
    const WidePoint from = at_;
    const bool grows = from.width_nm <= to.width_nm;
    std::vector<double> shares = SharesOf(from, to);
    if (!grows) std::ranges::reverse(shares);
    for (const double share : shares) Put(Between(from, to, grows ? share : 1 - share));
    Put(to);
  }

  /// Returns the division points of an edge, as shares of its length from its narrower end. Along
  /// the edge, the section grows linearly; of a bead narrower than high, the width does. So each
  /// piece is longer than the one before by the ratio.
  std::vector<double> SharesOf(const WidePoint& a, const WidePoint& b) const {
    const auto [narrower, wider] = std::minmax({a.width_nm, b.width_nm});
    const bool disc = narrower < bead_height_nm_;
    const double step = disc ? kMostDiscStep : kMostStep;
    const double growth =
        disc ? static_cast<double>(wider) / static_cast<double>(narrower)
             : SectionMm2(wider, bead_height_nm_) / SectionMm2(narrower, bead_height_nm_);
    const double length = Distance(a.point, b.point);
    if (growth <= step || length < 2 * kLeastEdgeNm) return {};
    double whole = step;
    while (whole < growth) whole *= step;
    const double shortest = kLeastEdgeNm / length;
    std::vector<double> shares;
    double share = 0;
    for (double power = step; true; power *= step) {
      share = std::max((power - 1) / (whole - 1), share + shortest);
      if (share > 1 - shortest) return shares;
      shares.push_back(share);
    }
  }

  void Put(const WidePoint& at) {
    path_.points.push_back(at.point);
    path_.widths_nm.push_back(at.width_nm);
    at_ = at;
  }

  const Coord bead_height_nm_;
  Path& path_;
  WidePoint at_;
};

}  // namespace

Path DividedByWidth(Path path, Coord bead_height_nm) {
  if (path.widths_nm.size() == 1) return path;
  const std::vector<Point> points = std::exchange(path.points, {});
  const std::vector<Coord> widths_nm = std::exchange(path.widths_nm, {});
  Divider divider(bead_height_nm, path);
  divider.Start({points.front(), widths_nm.front()});
  for (size_t i = 1; i < points.size(); ++i) divider.GoTo({points[i], widths_nm[i]});
  if (path.closed) {
    divider.GoTo({points.front(), widths_nm.front()});
    path.points.pop_back();
    path.widths_nm.pop_back();
  }
  return path;
}

}  // namespace slicefarm::motion
