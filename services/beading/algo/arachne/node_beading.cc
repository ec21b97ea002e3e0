#include "services/beading/algo/arachne/node_beading.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::beading {
namespace {

/// Replaces the middle bead by two halves side by side.
void SplitMiddle(NodeBeading& beading, double radius) {
  beading.sides.push_back({beading.middle_width / 2, radius - beading.middle_width / 4});
  beading.has_middle = false;
  beading.middle_width = 0;
}

SideBead Lerp(const SideBead& a, const SideBead& b, double ratio) {
  return {std::lerp(a.width, b.width, ratio), std::lerp(a.location, b.location, ratio)};
}

double InnerEdge(const SideBead& bead) { return bead.location + bead.width / 2; }

}  // namespace

NodeBeading FromBeading(const Beading& beading) {
  NodeBeading node;
  const int half = beading.count() / 2;
  for (int i = 0; i < half; ++i) {
    node.sides.push_back(
        {static_cast<double>(beading.widths_nm[i]), static_cast<double>(beading.locations_nm[i])});
  }
  node.has_middle = beading.count() % 2 == 1;
  if (node.has_middle) node.middle_width = static_cast<double>(beading.widths_nm[half]);
  return node;
}

NodeBeading Between(const NodeBeading& a, const NodeBeading& b, double ratio, double radius) {
  NodeBeading from = a;
  if (from.has_middle && b.sides.size() > from.sides.size()) SplitMiddle(from, radius);
  NodeBeading mixed = b;
  const size_t common = std::min(from.sides.size(), b.sides.size());
  for (size_t i = 0; i < common; ++i) mixed.sides[i] = Lerp(from.sides[i], b.sides[i], ratio);
  mixed.middle_width = std::lerp(from.middle_width, b.middle_width, ratio);
  return mixed;
}

NodeBeading Blend(const NodeBeading& a, const NodeBeading& b, double ratio, double radius) {
  NodeBeading from = a;
  if (from.has_middle && b.sides.size() > from.sides.size()) SplitMiddle(from, radius);
  NodeBeading mixed = b;
  const size_t common = std::min(from.sides.size(), b.sides.size());
  for (size_t i = 0; i < common; ++i) mixed.sides[i] = Lerp(from.sides[i], b.sides[i], ratio);
  if (common == 0) return mixed;
  double edge = InnerEdge(mixed.sides[common - 1]);
  for (size_t i = common; i < mixed.sides.size(); ++i) {
    const bool is_marker = b.sides[i].width == 0;
    const double inner = is_marker ? edge : std::max(edge, InnerEdge(b.sides[i]));
    mixed.sides[i] = {inner - edge, (inner + edge) / 2};
    edge = inner;
  }
  return mixed;
}

}  // namespace slicefarm::beading
