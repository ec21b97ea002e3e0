#include "services/infill/algo/lines/shortened.h"

#include <cmath>

namespace slicefarm::infill {
namespace {

/// Appends the part of a line between two lengths along it.
void AppendPart(const Polyline& line, double from, double to, Polyline& part) {
  const auto append = [&part](Point p) {
    if (part.empty() || part.back() != p) part.push_back(p);
  };
  double at = 0;
  for (size_t i = 1; i < line.size(); ++i) {
    const Point a = line[i - 1], b = line[i];
    const double length = Distance(a, b);
    if (length > 0) {
      const auto along = [&](double s) {
        const double t = (s - at) / length;
        return Point{a.x + std::llround(t * static_cast<double>(b.x - a.x)),
                     a.y + std::llround(t * static_cast<double>(b.y - a.y))};
      };
      if (at <= from && from < at + length) append(along(from));
      if (at > from && at < to) append(a);
      if (at < to && to <= at + length) return append(along(to));
    }
    at += length;
  }
  append(line.back());
}

}  // namespace

Polyline Shortened(const Polyline& line, double length_nm, double start_nm, double end_nm) {
  if (start_nm <= 0 && end_nm <= 0) return line;
  Polyline part;
  if (start_nm + end_nm < length_nm) {
    AppendPart(line, start_nm, length_nm - end_nm, part);
  } else {
    const double middle = length_nm * start_nm / (start_nm + end_nm);
    AppendPart(line, middle, middle, part);
  }
  return part;
}

}  // namespace slicefarm::infill
