#include "services/infill/algo/fields/streamlines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "common/geometry/rings/simplify.h"
#include "services/infill/algo/fields/cell_limit.h"
#include "services/infill/algo/fields/even_gaps.h"
#include "services/infill/algo/fields/stream_line.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Length of a step, as a share of the separation, and its smallest length in mm.
constexpr double kStepShare = 0.2;
constexpr double kLongestStepMm = 1;
constexpr double kShortestStepMm = 0.01;
/// Smallest distance of a new line's start from other lines, as a share of the separation.
constexpr double kStartShare = 0.95;
/// Smallest distance of a start in the middle of a remaining gap from other lines, as a share of
/// the separation. Such a gap is wider than about 1.3 separations.
constexpr double kGapShare = kEndShare;
/// Smallest length of a line, in separations. A shorter line supports nothing.
constexpr double kShortestLine = 1.5;
/// Distances along a line, in separations. Points of the line nearer than kOwnNear to each other
/// along the line do not count as too near. For the line's start, kOwnStart applies.
constexpr double kOwnNear = 2, kOwnStart = 1;
constexpr double kCosTurn = 0.9945;      // 6 degrees
constexpr double kCosStraight = 0.9999;  // below 1 degree: the step may grow
constexpr double kGridStepMm = 0.5;
constexpr double kSumStepMm = 1;  ///< step of the sum of the requested density
/// Largest number of layouts, and the largest factor between the requested and the used separation.
constexpr int kMostLayouts = 3;
constexpr double kMostScale = 1.3;
constexpr double kTightestMm = 0.05;  ///< least separation; beads are wider
constexpr Coord kLineToleranceNm = 10'000;
constexpr double kMostSteps = 1e6;  ///< largest number of steps of one line

/// Cosine of 60 degrees. Lines at a larger angle to each other may come near: they meet where the
/// field turns by a right angle, and the density must not be reduced there.
constexpr double kCosBeside = 0.5;

/// Point of a line, with the line's direction there and the distance along the line.
struct Mark {
  Vector2 at = Vector2::Zero();
  Vector2 way = Vector2::Zero();
  int32_t line = 0;
  double along = 0;
};

/// Points of lines, indexed by cell.
class MarkGrid {
 public:
  MarkGrid(const StreamBox& box, double cell)
      : box_(box),
        cell_(cell),
        columns_(Count(box.max_x_mm - box.min_x_mm)),
        rows_(Count(box.max_y_mm - box.min_y_mm)),
        cells_(static_cast<size_t>(columns_ * rows_)) {}

  void Add(const Mark& mark) { CellOf(mark.at).push_back(mark); }
  /// Removes the mark that was added last.
  void TakeBack(Vector2 at) { CellOf(at).pop_back(); }

  /// Returns true if a mark for which `counts` is true is within `distance`.
  template <class Counts>
  bool Near(Vector2 at, double distance, Counts counts) const {
    const auto [x0, y0] = Index({at.x() - distance, at.y() - distance});
    const auto [x1, y1] = Index({at.x() + distance, at.y() + distance});
    const double square = distance * distance;
    for (int64_t y = y0; y <= y1; ++y) {
      for (int64_t x = x0; x <= x1; ++x) {
        for (const Mark& mark : cells_[static_cast<size_t>(y * columns_ + x)]) {
          const Vector2 away = mark.at - at;
          if (Dot(away, away) < square && counts(mark)) return true;
        }
      }
    }
    return false;
  }

 private:
  int64_t Count(double extent) const {
    return std::max<int64_t>(1, static_cast<int64_t>(std::ceil(extent / cell_)));
  }
  std::pair<int64_t, int64_t> Index(Vector2 at) const {
    const auto index = [&](double value, double min, int64_t count) {
      return static_cast<int64_t>(
          std::clamp(std::floor((value - min) / cell_), 0.0, static_cast<double>(count - 1)));
    };
    return {index(at.x(), box_.min_x_mm, columns_), index(at.y(), box_.min_y_mm, rows_)};
  }
  std::vector<Mark>& CellOf(Vector2 at) {
    const auto [x, y] = Index(at);
    return cells_[static_cast<size_t>(y * columns_ + x)];
  }

  StreamBox box_;
  double cell_;
  int64_t columns_, rows_;
  std::vector<std::vector<Mark>> cells_;
};

class Tracer {
 public:
  /// Prepares the tracing. `scale`: factor for the requested separations.
  Tracer(const StreamBox& box, const DirectionField& directions, const StreamOptions& options,
         double scale)
      : box_(box),
        directions_(directions),
        options_(options),
        scale_(scale),
        grid_(box, GridCell()) {}

  absl::StatusOr<std::vector<StreamLine>> Run() {
    Start({(box_.min_x_mm + box_.max_x_mm) / 2, (box_.min_y_mm + box_.max_y_mm) / 2}, kStartShare);
    if (absl::Status ok = Spread(); !ok.ok()) return ok;
    for (double y = box_.min_y_mm + kGridStepMm / 2; y < box_.max_y_mm; y += kGridStepMm) {
      for (double x = box_.min_x_mm + kGridStepMm / 2; x < box_.max_x_mm; x += kGridStepMm) {
        if (!Start({x, y}, kGapShare)) continue;
        if (absl::Status ok = Spread(); !ok.ok()) return ok;
      }
    }
    return std::move(lines_);
  }

  /// Returns the total length of lines for the requested separations.
  double LengthAsked() const {
    double asked = 0;
    for (double y = box_.min_y_mm + kSumStepMm / 2; y < box_.max_y_mm; y += kSumStepMm) {
      for (double x = box_.min_x_mm + kSumStepMm / 2; x < box_.max_x_mm; x += kSumStepMm) {
        const double separation = Separation({x, y});
        if (separation > 0) asked += kSumStepMm * kSumStepMm / separation;
      }
    }
    return asked;
  }

 private:
  double Separation(Vector2 at) const {
    const double asked = options_.separation_mm(at.x(), at.y());
    return asked > 0 ? scale_ * std::max(asked, kTightestMm) : 0;
  }

  /// Returns the size of the grid's cells: the separation in the middle of the box.
  double GridCell() const {
    const double middle =
        Separation({(box_.min_x_mm + box_.max_x_mm) / 2, (box_.min_y_mm + box_.max_y_mm) / 2});
    return std::clamp(middle, 0.5, 5.0);
  }

  bool InBox(Vector2 at) const {
    return at.x() >= box_.min_x_mm && at.x() <= box_.max_x_mm && at.y() >= box_.min_y_mm &&
           at.y() <= box_.max_y_mm;
  }

  /// Returns the direction at a point, with the sign chosen to agree with `along`.
  std::optional<Vector2> DirectionAt(Vector2 at, Vector2 along) const {
    const auto found = directions_.At({at.x(), at.y(), options_.z_mm});
    if (!found.has_value()) return std::nullopt;
    const Vector2 direction = options_.across ? TurnedLeft(*found) : *found;
    return Dot(direction, along) < 0 ? Vector2(-direction) : direction;
  }

  struct Step {
    Vector2 to = Vector2::Zero();
    Vector2 direction = Vector2::Zero();  ///< direction at the end of the step
    double length = 0;
  };

  /// Returns one step of order 4, or nothing if it meets a degenerate point.
  std::optional<Step> Advance(Vector2 from, Vector2 along, double& step) const {
    for (;;) {
      const auto k1 = DirectionAt(from, along);
      if (!k1.has_value()) return std::nullopt;
      const auto k2 = DirectionAt(from + *k1 * (step / 2), *k1);
      const auto k3 = k2 ? DirectionAt(from + *k2 * (step / 2), *k2) : std::nullopt;
      const auto k4 = k3 ? DirectionAt(from + *k3 * step, *k3) : std::nullopt;
      const bool shorter = step > 2 * kShortestStepMm;
      if (!k4.has_value()) {
        if (!shorter) return std::nullopt;
      } else if (const double cos = Dot(*k1, *k4); cos >= kCosTurn || !shorter) {
        const Step result{from + (*k1 + *k2 * 2 + *k3 * 2 + *k4) * (step / 6), *k4, step};
        if (cos > kCosStraight) step *= 2;
        return result;
      }
      step /= 2;
    }
  }

  static bool IsBeside(const Mark& mark, Vector2 way) {
    return std::abs(Dot(mark.way, way)) > kCosBeside;
  }

  /// Returns true if a line may continue to a point. `along`: length of the line up to this point.
  bool MayStand(Vector2 at, Vector2 way, int32_t line, double along) const {
    const double separation = Separation(at);
    if (separation <= 0) return false;
    return !grid_.Near(at, kEndShare * separation, [&](const Mark& mark) {
      if (mark.line != line) return IsBeside(mark, way);
      return std::abs(mark.along - along) > kOwnNear * separation &&
             std::abs(mark.along) > kOwnStart * separation;
    });
  }

  /// Follows the field from the start of `line`, forwards or backwards. Returns true if the line
  /// closed.
  bool Follow(StreamLine& line, int32_t number, Vector2 start, Vector2 along, double sign,
              std::vector<Vector2>& marked) {
    const Vector2 first = along;
    Vector2 at = start;
    double length = 0;
    double step = kLongestStepMm;
    for (double steps = 0; steps < kMostSteps; ++steps) {
      const double separation = Separation(at);
      step = std::clamp(step, kShortestStepMm, std::min(kLongestStepMm, kStepShare * separation));
      const auto next = Advance(at, along, step);
      if (!next.has_value() || !InBox(next->to)) {
        // The last point is outside of the box: the region does not end at the box's boundary.
        if (next.has_value()) Put(line, next->to, sign);
        return false;
      }
      length += next->length;
      const Vector2 home = start - next->to;
      if (sign > 0 && length > 2 * separation && Norm(home) < 0.75 * next->length &&
          Dot(first, next->direction) > 0.9)
        return true;
      if (!MayStand(next->to, next->direction, number, sign * length)) return false;
      at = next->to, along = next->direction;
      Put(line, at, sign);
      grid_.Add({at, along, number, sign * length});
      marked.push_back(at);
    }
    return false;
  }

  static void Put(StreamLine& line, Vector2 at, double sign) {
    if (sign > 0) {
      line.points.push_back(at);
    } else {
      line.points.push_front(at);
    }
  }

  /// Starts a new line at this point, unless another line is too near or the new line is too short.
  /// Returns true if the line was added.
  bool Start(Vector2 at, double share) {
    if (!InBox(at)) return false;
    const double separation = Separation(at);
    const auto direction = DirectionAt(at, {1, 0});
    if (separation <= 0 || !direction.has_value()) return false;
    if (grid_.Near(at, share * separation,
                   [&](const Mark& mark) { return IsBeside(mark, *direction); }))
      return false;
    const auto number = static_cast<int32_t>(lines_.size());
    StreamLine line{{at}};
    std::vector<Vector2> marked = {at};
    grid_.Add({at, *direction, number, 0});
    line.closed = Follow(line, number, at, *direction, 1, marked);
    if (!line.closed) Follow(line, number, at, *direction * -1, -1, marked);
    double length = 0;
    for (size_t i = 1; i < line.points.size(); ++i)
      length += Norm(line.points[i] - line.points[i - 1]);
    if (length < kShortestLine * separation) {
      for (size_t i = marked.size(); i-- > 0;) grid_.TakeBack(marked[i]);
      return false;
    }
    lines_.push_back(std::move(line));
    return true;
  }

  /// Starts lines on both sides of the existing lines until there is no more space.
  absl::Status Spread() {
    for (; spread_ < lines_.size(); ++spread_) {
      const std::deque<Vector2> points = lines_[spread_].points;
      for (size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector2 along = points[i + 1] - points[i];
        const double length = Norm(along);
        if (length == 0) continue;
        const Vector2 aside{-along.y() / length, along.x() / length};
        const double separation = Separation(points[i]);
        for (const double side : {separation, -separation})
          Start(points[i] + aside * side, kStartShare);
      }
      points_ += static_cast<double>(points.size());
      absl::Status ok = CheckLineCount(static_cast<double>(lines_.size()));
      ok.Update(CheckFieldSize(kMaxStreamPoints, points_));
      if (!ok.ok()) return ok;
    }
    return absl::OkStatus();
  }

  const StreamBox box_;
  const DirectionField& directions_;
  const StreamOptions& options_;
  const double scale_;
  MarkGrid grid_;
  std::vector<StreamLine> lines_;
  size_t spread_ = 0;
  double points_ = 0;  ///< number of points of the lines from which new lines were started
};

double LengthOf(const StreamLine& line) {
  double length = line.closed ? Norm(line.points.front() - line.points.back()) : 0;
  for (size_t i = 1; i < line.points.size(); ++i)
    length += Norm(line.points[i] - line.points[i - 1]);
  return length;
}

/// Returns lines with about the total length that the separations request: of several layouts, the
/// one with the smallest difference from this length.
absl::StatusOr<std::vector<StreamLine>> EvenLines(const StreamBox& box,
                                                  const DirectionField& directions,
                                                  const StreamOptions& options) {
  std::vector<StreamLine> best;
  const double asked = Tracer(box, directions, options, 1).LengthAsked();
  double scale = 1, least = std::numeric_limits<double>::infinity();
  for (int layout = 0; layout < kMostLayouts && least > kMostBias; ++layout) {
    auto lines = Tracer(box, directions, options, scale).Run();
    if (!lines.ok() || lines->empty()) return lines;
    double length = 0;
    for (const StreamLine& line : *lines) length += LengthOf(line);
    scale = std::clamp(scale * length / asked, 1 / kMostScale, kMostScale);
    if (const double bias = std::abs(length / asked - 1); bias < least) {
      least = bias;
      best = *std::move(lines);
    }
  }
  return best;
}

std::optional<Curve> CurveOf(const StreamLine& line) {
  Polyline points;
  for (const Vector2& at : line.points) {
    const Point point{std::llround(at.x() * kNmPerMm), std::llround(at.y() * kNmPerMm)};
    if (points.empty() || points.back() != point) points.push_back(point);
  }
  if (line.closed) {
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    Polygon ring = SimplifyRing(points, kLineToleranceNm);
    if (ring.size() < 3) return std::nullopt;
    return Curve{std::move(ring), true};
  }
  if (points.size() < 2) return std::nullopt;
  return Curve{SimplifyLine(points, kLineToleranceNm), false};
}

}  // namespace

absl::StatusOr<std::vector<Curve>> Streamlines(const StreamBox& box,
                                               const DirectionField& directions,
                                               const StreamOptions& options) {
  const double cells = (box.max_x_mm - box.min_x_mm) * (box.max_y_mm - box.min_y_mm);
  if (absl::Status ok = CheckFieldSize(kMaxFieldCells, cells); !ok.ok()) return ok;
  auto lines = EvenLines(box, directions, options);
  if (!lines.ok()) return lines.status();
  EvenGaps([&](Vector2 at) { return std::max(options.separation_mm(at.x(), at.y()), kTightestMm); },
           *lines);
  std::vector<Curve> curves;
  for (const StreamLine& line : *lines)
    if (auto curve = CurveOf(line)) curves.push_back(*std::move(curve));
  return curves;
}

}  // namespace slicefarm::infill
