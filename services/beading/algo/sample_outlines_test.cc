#include "services/beading/algo/sample_outlines_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"

namespace slicefarm::beading {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Random numbers that are equal with any standard library; the results of its distributions are
/// not.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  double Between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int Count(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<uint64_t>(most - least + 1));
  }
  /// Returns a number with logarithmic distribution: equally likely between 1 and 10 and between 10
  /// and 100.
  double Magnitude(double least, double most) {
    return std::exp(Between(std::log(least), std::log(most)));
  }
  bool Coin() { return Count(0, 1) == 1; }

 private:
  std::mt19937_64 engine_;
};

/// Position; all lengths are in mm.
struct Spot {
  double x = 0;
  double y = 0;
};
using Ring = std::vector<Spot>;
using Rings = std::vector<Ring>;

constexpr double kNm = 1e-6;
constexpr double kUm = 1e-3;

Spot Polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Ring Rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// Returns a shape with one side of points almost on a line.
Rings NearlyStraight(Random& random) {
  const double noise = random.Magnitude(kNm, 20 * kUm), step = random.Magnitude(2 * kUm, 0.5);
  const double depth = random.Magnitude(10 * kUm, 20);
  Ring ring = {{0, -depth}};
  const int count = random.Count(20, 150);
  for (int i = count; i >= 0; --i) ring.push_back({i * step, random.Between(-noise, noise)});
  if (random.Coin()) ring.push_back({-step, -depth / 2});
  return {ring};
}

/// Returns blades from about one point, at almost the same angle.
Rings Fan(Random& random) {
  if (random.Coin()) return NearlyStraight(random);
  const int blades = random.Count(5, 60);
  const double root = random.Magnitude(kUm, 2), length = random.Between(5, 50);
  const double angle = std::min(random.Magnitude(kUm / length, 0.1), 0.9 * kTurn / (2 * blades));
  Ring ring;
  for (int i = 0; i < 2 * blades; ++i) ring.push_back(Polar(i % 2 == 0 ? root : length, i * angle));
  ring.push_back(Polar(root, -kTurn / 4));
  return {ring};
}

Rings Comb(Random& random) {
  const double tooth = random.Magnitude(kUm, 2), gap = random.Magnitude(kUm, 2);
  const double depth = random.Magnitude(0.1, 20), back = random.Magnitude(10 * kUm, 3);
  const int teeth = random.Count(5, 50);
  const double slant = random.Coin() ? random.Between(-0.45, 0.45) * gap : 0;
  Ring ring = {{0, 0}, {teeth * (tooth + gap) - gap, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = i * (tooth + gap);
    ring.insert(ring.end(), {{x + tooth, back},
                             {x + tooth + slant, back + depth},
                             {x + slant, back + depth},
                             {x, back}});
  }
  return {ring};
}

Rings Spiral(Random& random) {
  const double width = random.Magnitude(kUm, 3), gap = random.Magnitude(kUm, 3);
  const double turns = random.Between(1, 6), hub = random.Magnitude(10 * kUm, 5);
  const int steps = random.Count(10, 150);
  Ring ring, back;
  for (int i = 0; i <= steps; ++i) {
    const double turn = turns * i / steps;
    const double radius = hub + turn * (width + gap);
    ring.push_back(Polar(radius + width, turn * kTurn));
    back.push_back(Polar(radius, turn * kTurn));
  }
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return {ring};
}

/// Returns a checkerboard with corners that touch, miss or overlap each other slightly. In half of
/// the cases it is subtracted from a plate.
Rings TouchingCorners(Random& random) {
  const double size = random.Magnitude(50 * kUm, 5);
  const double distance = random.Magnitude(kNm, 10 * kUm);
  const double off = distance * random.Count(-1, 1);
  const int side = random.Count(2, 9);
  Rings rings;
  if (random.Coin()) rings.push_back(Rectangle(-1, -1, side * size + 1, side * size + 1));
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side, column = i % side;
    if ((row + column) % 2 != 0) continue;
    const double x = column * size, y = row * size;
    const double own = random.Coin() ? off : 0;
    rings.push_back(Rectangle(x - own, y - own, x + size + own, y + size + own));
  }
  return rings;
}

/// Returns slots of 1 nm to 1 um into a plate or within it. By the even-odd rule, slots beyond its
/// edge stick out as slivers.
Rings Slots(Random& random) {
  const int count = random.Count(1, 30);
  const double pitch = random.Magnitude(5 * kUm, 3), height = random.Magnitude(0.2, 20);
  Rings rings = {Rectangle(-pitch, 0, count * pitch, height)};
  for (int i = 0; i < count; ++i) {
    const double x = i * pitch, width = random.Magnitude(kNm, kUm);
    const double low = random.Between(0, height / 2);
    const double high = random.Coin() ? height + 1 : random.Between(low, height);
    const double lean = random.Coin() ? random.Between(-0.3, 0.3) * pitch : 0;
    rings.push_back({{x, low}, {x + width, low}, {x + lean + width, high}, {x + lean, high}});
  }
  return rings;
}

Rings StarNoise(Random& random) {
  const double least = random.Magnitude(kUm, 10), most = least + random.Magnitude(kUm, 20);
  const int count = random.Count(5, 300);
  Ring ring;
  for (int i = 0; i < count; ++i)
    ring.push_back(Polar(random.Between(least, most), kTurn * i / count));
  return {ring};
}

/// Returns a line that crosses itself. In half of the cases it is on a coarse grid, so that corners
/// and edges coincide.
Rings CrossingNoise(Random& random) {
  const double size = random.Magnitude(0.1, 50);
  const double grid = random.Coin() ? size / random.Count(3, 30) : 0;
  const int count = random.Count(4, 30);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    Spot spot = {random.Between(0, size), random.Between(0, size)};
    if (grid > 0) spot = {grid * std::round(spot.x / grid), grid * std::round(spot.y / grid)};
    ring.push_back(spot);
  }
  return {ring};
}

/// Returns a bar with teeth or stairs of tiny steps on its long sides.
Rings SawTeeth(Random& random) {
  const double step = random.Magnitude(kUm, 0.5), rise = random.Magnitude(kNm, 50 * kUm);
  const double height = random.Magnitude(20 * kUm, 10);
  const bool stairs = random.Coin();
  const int teeth = random.Count(10, 100);
  Ring ring, top;
  for (int i = 0; i < teeth; ++i) {
    const double drift = stairs ? i * rise : 0;
    for (Ring* side : {&ring, &top}) {
      const double y = drift + (side == &top ? height : 0);
      side->push_back({i * step, y});
      side->push_back({(stairs ? i + 1 : i + 0.5) * step, y + (stairs ? 0 : rise)});
    }
  }
  ring.insert(ring.end(), top.rbegin(), top.rend());
  return {ring};
}

/// Returns thin triangles and bars, separate or across each other.
Rings Slivers(Random& random) {
  const int count = random.Count(1, 12);
  const double spread = random.Magnitude(kUm, 20);
  Rings rings;
  for (int i = 0; i < count; ++i) {
    const double length = random.Between(1, 100), width = random.Magnitude(kNm, 1);
    const double x = random.Between(-spread, spread), y = random.Between(-spread, spread);
    const double tilt = random.Magnitude(kNm, 10);
    if (random.Coin()) {
      rings.push_back({{x, y}, {x + length, y + tilt}, {x, y + width}});
    } else {
      rings.push_back(
          {{x, y}, {x + length, y + tilt}, {x + length, y + tilt + width}, {x, y + width}});
    }
  }
  return rings;
}

struct Kind {
  std::string_view name;
  Rings (*make)(Random& random);
};

constexpr std::array kKinds = {
    Kind{"fan", Fan},
    Kind{"comb", Comb},
    Kind{"spiral", Spiral},
    Kind{"touching corners", TouchingCorners},
    Kind{"slots", Slots},
    Kind{"star noise", StarNoise},
    Kind{"crossing noise", CrossingNoise},
    Kind{"saw teeth", SawTeeth},
    Kind{"slivers", Slivers},
};

std::vector<Polygon> Rounded(const Rings& rings, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<Polygon> rounded;
  for (const Ring& ring : rings) {
    Polygon& polygon = rounded.emplace_back();
    for (const Spot& spot : ring)
      polygon.push_back({FromMm(spot.x * c - spot.y * s), FromMm(spot.x * s + spot.y * c)});
  }
  return rounded;
}

Polygon WavyCircle(int points, double radius, double phase) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double angle = kTurn * i / points;
    const Spot spot = Polar(radius + 2 * std::sin(12 * angle + phase), angle);
    ring.push_back({FromMm(spot.x), FromMm(spot.y)});
  }
  return ring;
}

}  // namespace

HostileOutline MakeHostileOutline(uint64_t seed) {
  Random random(seed);
  const Kind& kind = kKinds[seed % kKinds.size()];
  const Rings rings = kind.make(random);
  const double angle = random.Coin() ? random.Between(0, kTurn) : 0;
  return {kind.name, Union(Rounded(rings, angle), FillRule::kEvenOdd)};
}

PolygonWithHoles WavyRing(int points) {
  Polygon hole = WavyCircle(points / 2, 33, 1);
  std::reverse(hole.begin(), hole.end());
  return {WavyCircle(points - points / 2, 48, 0), {std::move(hole)}};
}

}  // namespace slicefarm::beading
