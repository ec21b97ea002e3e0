#include "services/infill/algo/fields/even_gaps.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace slicefarm::infill {
namespace {

constexpr int kEvenRounds = 60;
/// Number of passes of 1/4, 1/2, 1/4 over a line's shifts in each round.
constexpr int kSmoothPasses = 16;
/// Limit of the angle by which shifts turn lines (root mean square): 0.7 degrees.
constexpr double kMostTurn = 0.012;
/// Distance between nodes along a line, in separations.
constexpr double kNodeStep = 0.5;
/// Greatest distance of a neighbour, in separations.
constexpr double kFarthest = 2;
/// Limits of the size of the cells in which neighbours are searched. Within them, the cells are as
/// large as the distance between lines. The size changes the cost of the search, not its result.
constexpr double kLeastCellMm = 0.5, kMostCellMm = 5;
constexpr double kNoPlace = 1e9;
/// Number of nodes along a line within which the line is not its own neighbour.
constexpr int64_t kOwnNodes = 6;

struct Node {
  Vector2 home = Vector2::Zero();   ///< position before any shift
  Vector2 aside = Vector2::Zero();  ///< unit vector to the left
  double separation = 0;
  size_t point = 0;  ///< index of the line's point at this node
  double shift = 0;

  Vector2 At() const { return home + aside * shift; }
};

struct NodeLine {
  std::vector<Node> nodes;
  bool closed = false;

  size_t Pieces() const { return nodes.size() < 2 ? 0 : nodes.size() - (closed ? 0 : 1); }
};

NodeLine NodesOf(const StreamLine& line, const std::function<double(Vector2)>& separation_mm) {
  NodeLine result{{}, line.closed};
  const std::deque<Vector2>& points = line.points;
  double since = 0, separation = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0) since += Norm(points[i] - points[i - 1]);
    const bool last = i + 1 == points.size() && !line.closed;
    if (i > 0 && since < kNodeStep * separation && !last) continue;
    const Vector2 along = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
    const double length = Norm(along);
    if (length == 0) continue;
    separation = separation_mm(points[i]);
    result.nodes.push_back(
        {points[i], Vector2{-along.y(), along.x()} * (1 / length), separation, i, 0});
    since = 0;
  }
  return result;
}

/// Line pieces between nodes, in square cells.
class PieceGrid {
 public:
  PieceGrid(const std::vector<NodeLine>& lines, double cell) : lines_(lines), cell_(cell) {
    for (const NodeLine& line : lines) {
      for (const Node& node : line.nodes) {
        low_ = {std::min(low_.x(), node.At().x()), std::min(low_.y(), node.At().y())};
        high_ = {std::max(high_.x(), node.At().x()), std::max(high_.y(), node.At().y())};
      }
    }
    columns_ = Column(high_.x()) + 1;
    cells_.resize(static_cast<size_t>(columns_ * (Row(high_.y()) + 1)));
    for (size_t line = 0; line < lines.size(); ++line) {
      for (size_t i = 0; i < lines[line].Pieces(); ++i) {
        const auto [a, b] = Ends(line, i);
        ForCells(a, b, [&](size_t cell_index) { cells_[cell_index].push_back({line, i}); });
      }
    }
  }

  /// Returns the distance of the next line from a node on its left (`side` 1) or right (-1), or 0
  /// if there is none.
  double Gap(size_t line, size_t node, double side) const {
    const Node& from = lines_[line].nodes[node];
    const Vector2 at = from.At(), path = from.aside * (side * kFarthest * from.separation);
    double nearest = 2;
    ForCells(at, at + path, [&](size_t cell_index) {
      for (const auto& [other, piece] : cells_[cell_index]) {
        if (other == line && IsNear(line, node, piece)) continue;
        const auto [a, b] = Ends(other, piece);
        const double before = Cross(path, a - at), after = Cross(path, b - at);
        if ((before > 0) == (after > 0)) continue;
        const Vector2 meets = a + (b - a) * (before / (before - after));
        const double share = Dot(meets - at, path) / Dot(path, path);
        if (share > 0) nearest = std::min(nearest, share);
      }
    });
    return nearest > 1 ? 0 : nearest * kFarthest * from.separation;
  }

 private:
  std::pair<Vector2, Vector2> Ends(size_t line, size_t piece) const {
    const std::vector<Node>& nodes = lines_[line].nodes;
    return {nodes[piece].At(), nodes[(piece + 1) % nodes.size()].At()};
  }

  bool IsNear(size_t line, size_t node, size_t piece) const {
    const auto count = static_cast<int64_t>(lines_[line].nodes.size());
    const int64_t away = std::abs(static_cast<int64_t>(node) - static_cast<int64_t>(piece));
    return away <= kOwnNodes || (lines_[line].closed && count - away <= kOwnNodes);
  }

  int64_t Column(double x) const { return Index(x, low_.x(), high_.x()); }
  int64_t Row(double y) const { return Index(y, low_.y(), high_.y()); }
  int64_t Index(double value, double low, double high) const {
    return static_cast<int64_t>((std::clamp(value, low, high) - low) / cell_);
  }

  template <class Use>
  void ForCells(Vector2 a, Vector2 b, Use use) const {
    for (int64_t y = Row(std::min(a.y(), b.y())); y <= Row(std::max(a.y(), b.y())); ++y)
      for (int64_t x = Column(std::min(a.x(), b.x())); x <= Column(std::max(a.x(), b.x())); ++x)
        use(static_cast<size_t>(y * columns_ + x));
  }

  const std::vector<NodeLine>& lines_;
  double cell_;
  Vector2 low_{kNoPlace, kNoPlace}, high_{-kNoPlace, -kNoPlace};
  int64_t columns_ = 0;
  std::vector<std::vector<std::pair<size_t, size_t>>> cells_;
};

/// Returns the distance of a node from the middle between its neighbours, positive to the left.
double PullOn(const Node& node, double left, double right,
              const std::function<double(Vector2)>& separation_mm) {
  if (left == 0 || right == 0) return 0;
  const double asked_left = separation_mm(node.At() + node.aside * (left / 2));
  const double asked_right = separation_mm(node.At() - node.aside * (right / 2));
  if (asked_left <= 0 || asked_right <= 0) return 0;
  return (left * asked_right - right * asked_left) / (asked_left + asked_right);
}

void Smooth(NodeLine& line, std::vector<double>& shifts) {
  const size_t count = shifts.size();
  std::vector<double> smooth(count);
  for (int pass = 0; pass < kSmoothPasses; ++pass) {
    for (size_t i = 0; i < count; ++i) {
      const size_t before = i > 0 ? i - 1 : line.closed ? count - 1 : 0;
      const size_t after = i + 1 < count ? i + 1 : line.closed ? 0 : count - 1;
      smooth[i] = 0.5 * shifts[i] + 0.25 * (shifts[before] + shifts[after]);
    }
    shifts.swap(smooth);
  }
}

void Relax(const std::function<double(Vector2)>& separation_mm, double cell,
           std::vector<NodeLine>& lines) {
  std::vector<std::vector<double>> shifts(lines.size());
  {
    const PieceGrid grid(lines, cell);
    for (size_t line = 0; line < lines.size(); ++line) {
      for (size_t i = 0; i < lines[line].nodes.size(); ++i) {
        const Node& node = lines[line].nodes[i];
        shifts[line].push_back(
            node.shift + PullOn(node, grid.Gap(line, i, 1), grid.Gap(line, i, -1), separation_mm));
      }
    }
  }
  for (size_t line = 0; line < lines.size(); ++line) {
    Smooth(lines[line], shifts[line]);
    for (size_t i = 0; i < shifts[line].size(); ++i) lines[line].nodes[i].shift = shifts[line][i];
  }
}

/// Returns the tangent of the angle by which the shifts turn the lines, as root mean square over
/// their length.
double TurnOf(const std::vector<NodeLine>& lines) {
  double squares = 0, length = 0;
  for (const NodeLine& line : lines) {
    for (size_t i = 0; i < line.Pieces(); ++i) {
      const Node& a = line.nodes[i];
      const Node& b = line.nodes[(i + 1) % line.nodes.size()];
      const double along = Norm(b.home - a.home);
      if (along == 0) continue;
      squares += (b.shift - a.shift) * (b.shift - a.shift) / along;
      length += along;
    }
  }
  return length == 0 ? 0 : std::sqrt(squares / length);
}

/// Moves the points between nodes by the interpolated shifts of the nodes.
void Shift(const NodeLine& nodes, StreamLine& line) {
  for (size_t k = 0; k < nodes.Pieces(); ++k) {
    const Node& a = nodes.nodes[k];
    const Node& b = nodes.nodes[(k + 1) % nodes.nodes.size()];
    const size_t end = b.point > a.point ? b.point : line.points.size();
    const Vector2 from = a.aside * a.shift, to = b.aside * b.shift;
    for (size_t i = a.point; i < end; ++i) {
      const double share = static_cast<double>(i - a.point) / static_cast<double>(end - a.point);
      line.points[i] = line.points[i] + from * (1 - share) + to * share;
    }
  }
  if (!nodes.closed) {
    const Node& last = nodes.nodes.back();
    line.points[last.point] = last.At();
  }
}

}  // namespace

void EvenGaps(const std::function<double(Vector2)>& separation_mm, std::vector<StreamLine>& lines) {
  std::vector<NodeLine> nodes;
  double closest = kMostCellMm;
  for (const StreamLine& line : lines) {
    nodes.push_back(NodesOf(line, separation_mm));
    for (const Node& node : nodes.back().nodes) closest = std::min(closest, node.separation);
  }
  if (std::ranges::all_of(nodes, [](const NodeLine& line) { return line.nodes.empty(); })) return;
  for (int round = 0; round < kEvenRounds; ++round) {
    std::vector<NodeLine> next = nodes;
    Relax(separation_mm, std::max(closest, kLeastCellMm), next);
    const double turn = TurnOf(next);
    nodes = std::move(next);
    if (turn <= kMostTurn) continue;
    for (NodeLine& line : nodes)  // as far in this direction as the turn permits
      for (Node& node : line.nodes) node.shift *= kMostTurn / turn;
    break;
  }
  for (size_t i = 0; i < lines.size(); ++i)
    if (nodes[i].nodes.size() > 1) Shift(nodes[i], lines[i]);
}

}  // namespace slicefarm::infill
