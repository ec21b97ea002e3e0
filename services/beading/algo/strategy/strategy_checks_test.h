#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

inline constexpr Coord kUm = 1'000;

/// Converts to um, rounded down.
inline std::vector<Coord> InUm(std::vector<Coord> nm) {
  for (Coord& value : nm) value /= kUm;
  return nm;
}

struct BeadingCase {
  std::string name;
  Coord thickness_um;
  int count;
  std::vector<Coord> widths_um;
  std::vector<Coord> locations_um;
};

inline void ExpectBeadings(const BeadingStrategy& strategy, const std::vector<BeadingCase>& cases) {
  for (const BeadingCase& c : cases) {
    SCOPED_TRACE(c.name);
    const Beading beading = strategy.Compute(c.thickness_um * kUm, c.count);
    EXPECT_THAT(InUm(beading.widths_nm), testing::ElementsAreArray(c.widths_um));
    EXPECT_THAT(InUm(beading.locations_nm), testing::ElementsAreArray(c.locations_um));
  }
}

inline std::vector<Coord> TransitionsUm(const BeadingStrategy& strategy, int count) {
  std::vector<Coord> thicknesses;
  for (int n = 0; n < count; ++n) thicknesses.push_back(strategy.TransitionThickness(n) / kUm);
  return thicknesses;
}

inline std::vector<Coord> OptimalThicknessesUm(const BeadingStrategy& strategy, int count) {
  std::vector<Coord> thicknesses;
  for (int n = 0; n < count; ++n) thicknesses.push_back(strategy.OptimalThickness(n) / kUm);
  return thicknesses;
}

// Limits up to which the properties from beading_strategy.h are tested for every strategy:
inline constexpr int kMostBeads = 9;
inline constexpr Coord kThickest = 6'000 * kUm;
inline constexpr Coord kStep = 3'331;  // divides no width, so odd thicknesses occur

inline void ExpectSums(const BeadingStrategy& strategy) {
  for (int n = 0; n <= kMostBeads; ++n) {
    for (Coord d = 0; d < kThickest; d += kStep) {
      const Beading b = strategy.Compute(d, n);
      ASSERT_EQ(std::accumulate(b.widths_nm.begin(), b.widths_nm.end(), b.left_over_nm), d)
          << d << " in " << n;
      ASSERT_EQ(b.thickness_nm, d);
    }
  }
}

inline void ExpectSymmetric(const BeadingStrategy& strategy) {
  for (int n = 0; n <= kMostBeads; ++n) {
    for (Coord d = 0; d < kThickest; d += kStep) {
      const Beading b = strategy.Compute(d, n);
      ASSERT_EQ(b.locations_nm.size(), b.widths_nm.size());
      for (int i = 0; i < b.count(); ++i) {
        const int j = b.count() - 1 - i;
        ASSERT_EQ(b.widths_nm[i], b.widths_nm[j]) << d << " in " << n;
        // A marker in the middle represents both sides; it has the position of the first marker.
        if (b.widths_nm[i] == 0) continue;
        // The middle of an odd thickness is rounded down.
        ASSERT_NEAR(b.locations_nm[i] + b.locations_nm[j], d, i == j ? 1 : 0) << d << " in " << n;
      }
    }
  }
}

/// Checks that beads are in order and do not overlap. Inset strategies do not fulfil this.
inline void ExpectSideBySide(const BeadingStrategy& strategy) {
  for (int n = 0; n <= kMostBeads; ++n) {
    for (Coord d = 0; d < kThickest; d += kStep) {
      const Beading b = strategy.Compute(d, n);
      for (int i = 1; i < b.count(); ++i) {
        const Coord apart = b.locations_nm[i] - b.locations_nm[i - 1];
        ASSERT_GE(apart, (b.widths_nm[i] + b.widths_nm[i - 1]) / 2 - 1) << d << " in " << n;
      }
    }
  }
}

/// Checks that widths are continuous, except for one nm per bead, which rounding moves between
/// beads.
inline void ExpectContinuous(const BeadingStrategy& strategy, Coord from = 0) {
  for (int n = 1; n <= kMostBeads; ++n) {
    Beading before = strategy.Compute(from, n);
    for (Coord d = from + kStep; d < kThickest; d += kStep) {
      const Beading b = strategy.Compute(d, n);
      ASSERT_EQ(b.count(), before.count()) << d << " in " << n;
      for (int i = 0; i < b.count(); ++i) {
        ASSERT_GE(b.widths_nm[i], before.widths_nm[i] - n) << d << " in " << n;
        ASSERT_LE(b.widths_nm[i], before.widths_nm[i] + kStep + n) << d << " in " << n;
      }
      before = b;
    }
  }
}

inline void ExpectCountsFollowTransitions(const BeadingStrategy& strategy) {
  int before = 0;
  for (Coord d = 0; d < kThickest; d += kStep) {
    const int n = strategy.OptimalCount(d);
    ASSERT_GE(n, before);
    before = n;
  }
  ASSERT_GT(before, 0);
  for (int n = 0; n < before; ++n) {
    const Coord at = strategy.TransitionThickness(n);
    EXPECT_GT(strategy.OptimalCount(at), n) << at;
    EXPECT_LE(strategy.OptimalCount(at - 1), n) << at;
  }
}

}  // namespace slicefarm::beading
