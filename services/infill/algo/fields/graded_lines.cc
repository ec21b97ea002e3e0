#include "services/infill/algo/fields/graded_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slicefarm::infill {
namespace {

/// Step in mm at which the field is sampled along a line. The position of a change between two
/// samples is interpolated from their values.
constexpr double kLookMm = 0.25;

/// Part of a line, given by its ends.
struct DenseSpan {
  double from = 0;
  double to = 0;
};

/// Returns the parts of a line between `from` and `to` where the field is above `level`.
std::vector<DenseSpan> Above(const LineAxes& frame, double v, double from, double to, double level,
                             const LayerField& field) {
  std::vector<DenseSpan> spans;
  const auto count =
      std::max<int64_t>(1, static_cast<int64_t>(std::ceil((to - from) / (kLookMm * kNmPerMm))));
  const double step = (to - from) / static_cast<double>(count);
  double last_u = from;
  double last = field.DensityAt(frame.At(from, v)) - level;
  if (last > 0) spans.push_back({from, to});
  for (int64_t i = 1; i <= count; ++i) {
    const double u = i == count ? to : from + static_cast<double>(i) * step;
    const double value = field.DensityAt(frame.At(u, v)) - level;
    if ((value > 0) != (last > 0)) {
      const double at = last_u + (u - last_u) * last / (last - value);
      if (value > 0) {
        spans.push_back({at, to});
      } else {
        spans.back().to = at;
      }
    }
    last_u = u, last = value;
  }
  return spans;
}

/// Removes gaps that are too short, then parts that are too short. A part that touches an end of
/// the line is kept.
std::vector<DenseSpan> WithoutShort(const std::vector<DenseSpan>& spans, double from, double to,
                                    double min_length) {
  std::vector<DenseSpan> joined;
  for (const DenseSpan& span : spans) {
    if (!joined.empty() && span.from - joined.back().to < min_length) {
      joined.back().to = span.to;
    } else {
      joined.push_back(span);
    }
  }
  std::erase_if(joined, [&](const DenseSpan& span) {
    return span.to - span.from < min_length && span.from != from && span.to != to;
  });
  return joined;
}

}  // namespace

double RankOf(int64_t index) {
  auto bits = static_cast<uint32_t>(index);
  uint32_t reversed = 0;
  for (int i = 0; i < 32; ++i, bits >>= 1) reversed = reversed << 1 | (bits & 1);
  return (static_cast<double>(reversed) + 0.5) / 4294967296.0;
}

absl::StatusOr<std::vector<Piece>> GradedPieces(const MultiPolygon& region,
                                                std::span<const LineFamily> families,
                                                const LayerField& field,
                                                const GradedLines& graded) {
  std::vector<Piece> pieces;
  for (const LineFamily& family : families) {
    const auto lines = CutLines(region, family);
    if (!lines.ok()) return lines.status();
    for (int32_t piece = 0; piece < lines->PieceCount(); ++piece) {
      const Crossing& from = lines->crossings[lines->order[2 * piece]];
      const Crossing& to = lines->crossings[lines->order[2 * piece + 1]];
      const double v = lines->first_v + lines->pitch * from.line;
      const int64_t index = std::llround((v - family.phase_nm) / family.pitch_nm);
      const double level = graded.greatest * RankOf(index);
      const auto spans = WithoutShort(Above(lines->frame, v, from.u, to.u, level, field), from.u,
                                      to.u, graded.min_length_nm);
      for (const DenseSpan& span : spans) {
        Piece part{{lines->frame.At(span.from, v), lines->frame.At(span.to, v)}};
        if (part.points[0] == part.points[1]) continue;
        if (span.from == from.u) part.from = {from.ring, from.edge};
        if (span.to == to.u) part.to = {to.ring, to.edge};
        pieces.push_back(std::move(part));
      }
    }
  }
  return pieces;
}

}  // namespace slicefarm::infill
