#include "common/wire/support/geometry_wire.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

using google::protobuf::RepeatedField;

constexpr Coord kMost = std::numeric_limits<int32_t>::max();

/// Returns a number with 0 in its upper half exactly if the value fits in 32 bits.
uint64_t Excess(Coord value) { return static_cast<uint64_t>(value) + (uint64_t{1} << 31); }

bool Fits(Coord value) { return Excess(value) >> 32 == 0; }

absl::Status OutOfRange(std::span<const Point> points) {
  for (const Point p : points) {
    if (!Fits(p.x)) return CheckCoord(p.x);
    if (!Fits(p.y)) return CheckCoord(p.y);
  }
  return absl::OkStatus();
}

/// Writes x, y, x, y, ... to `to`. The range is checked once for all points, so that the loop only
/// copies.
bool CopyPoints(std::span<const Point> points, int32_t* to) {
  uint64_t excess = 0;
  for (const Point p : points) {
    excess |= Excess(p.x) | Excess(p.y);
    *to++ = static_cast<int32_t>(p.x);
    *to++ = static_cast<int32_t>(p.y);
  }
  return excess >> 32 == 0;
}

void CopyPoints(const int32_t* xy_nm, std::vector<Point>* to) {
  for (Point& p : *to) {
    p = {xy_nm[0], xy_nm[1]};
    xy_nm += 2;
  }
}

uint64_t Sum(const RepeatedField<uint32_t>& values) {
  uint64_t sum = 0;
  for (const uint32_t value : values) sum += value;
  return sum;
}

absl::Status CheckSizes(const v1::MultiPolygon& proto) {
  if (proto.xy_nm_size() % 2 != 0) return Malformed("xy_nm", "an odd number of values");
  const uint64_t points = proto.xy_nm_size() / 2;
  if (points > limits::kMaxPointsPerLayer) {
    return LimitError(Reason::kRequestTooLarge, "points of a region", limits::kMaxPointsPerLayer,
                      static_cast<int64_t>(points));
  }
  if (Sum(proto.ring_sizes()) != points) {
    return Malformed("ring_sizes", "their sum is not the number of points");
  }
  if (Sum(proto.rings_per_island()) != static_cast<uint64_t>(proto.ring_sizes_size())) {
    return Malformed("rings_per_island", "their sum is not the number of rings");
  }
  if (std::ranges::any_of(proto.ring_sizes(), [](uint32_t size) { return size < 3; })) {
    return Malformed("ring_sizes", "a ring of fewer than 3 points");
  }
  if (std::ranges::any_of(proto.rings_per_island(), [](uint32_t rings) { return rings == 0; })) {
    return Malformed("rings_per_island", "an island without rings");
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckCoord(Coord value_nm) {
  if (Fits(value_nm)) return absl::OkStatus();
  return LimitError(Reason::kOutOfRange, "coordinate in nm", kMost, value_nm);
}

absl::Status ToProto(Point point, v1::Point* proto) {
  if (!Fits(point.x) || !Fits(point.y)) return OutOfRange({&point, 1});
  proto->set_x_nm(static_cast<int32_t>(point.x));
  proto->set_y_nm(static_cast<int32_t>(point.y));
  return absl::OkStatus();
}

Point FromProto(const v1::Point& proto) { return {proto.x_nm(), proto.y_nm()}; }

absl::Status PackPoints(std::span<const Point> points, RepeatedField<int32_t>* xy_nm) {
  const int count = static_cast<int>(2 * points.size());
  xy_nm->Reserve(xy_nm->size() + count);
  if (!CopyPoints(points, xy_nm->AddNAlreadyReserved(count))) return OutOfRange(points);
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Point>> UnpackPoints(const RepeatedField<int32_t>& xy_nm,
                                                std::string_view field) {
  if (xy_nm.size() % 2 != 0) return Malformed(field, "an odd number of values");
  std::vector<Point> points(xy_nm.size() / 2);
  CopyPoints(xy_nm.data(), &points);
  return points;
}

absl::Status ToProto(const MultiPolygon& polygons, v1::MultiPolygon* proto) {
  proto->mutable_xy_nm()->Reserve(static_cast<int>(2 * PointCount(polygons)));
  const auto add = [proto](const Polygon& ring) {
    proto->add_ring_sizes(static_cast<uint32_t>(ring.size()));
    return PackPoints(ring, proto->mutable_xy_nm());
  };
  for (const PolygonWithHoles& island : polygons) {
    proto->add_rings_per_island(static_cast<uint32_t>(1 + island.holes.size()));
    if (absl::Status status = add(island.outer); !status.ok()) return status;
    for (const Polygon& hole : island.holes) {
      if (absl::Status status = add(hole); !status.ok()) return status;
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<MultiPolygon> FromProto(const v1::MultiPolygon& proto) {
  if (absl::Status status = CheckSizes(proto); !status.ok()) return status;
  const int32_t* xy_nm = proto.xy_nm().data();
  auto ring_size = proto.ring_sizes().begin();
  const auto next = [&] {
    Polygon ring(*ring_size++);
    CopyPoints(xy_nm, &ring);
    xy_nm += 2 * ring.size();
    return ring;
  };
  MultiPolygon polygons;
  polygons.reserve(proto.rings_per_island_size());
  for (const uint32_t rings : proto.rings_per_island()) {
    PolygonWithHoles& island = polygons.emplace_back();
    island.outer = next();
    island.holes.reserve(rings - 1);
    for (uint32_t hole = 1; hole < rings; ++hole) island.holes.push_back(next());
  }
  return polygons;
}

}  // namespace slicefarm
