#include "services/lab/tours/first_tours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::lab::first_tours_test {
namespace {

using ordering::Costs;
using ordering::Tour;
using ::testing::ElementsAre;

Costs OnALine(const std::vector<double>& xs) {
  std::vector<Vector2> points;
  for (const double x : xs) points.push_back({x, 0});
  return Costs::OfPoints(points, ordering::Metric::kNearest);
}

TEST(FirstTours, NearestNeighbourGoesOnToTheNearest) {
  EXPECT_THAT(NearestNeighbourTour(OnALine({0, 10, 3, -4}), 0), ElementsAre(0, 2, 1, 3));
}

TEST(FirstTours, InsertionTakesTheFarthest) {
  // On a line, every order of insertion gives the best tour: to the far end and back.
  const Costs costs = OnALine({0, 10, 3, -4, 7});
  EXPECT_EQ(TourLength(costs, InsertionTour(costs)), 28);
}

TEST(FirstTours, OfFewOrCoincidentNodes) {
  for (const size_t count : {1, 2, 3, 4, 30}) {
    for (const int range : {1, 100}) {
      const Costs costs = ordering::RandomCosts(count, 5, range);
      const auto size = static_cast<int32_t>(count);
      EXPECT_TRUE(ordering::Keeps(NearestNeighbourTour(costs, size - 1), size, {}));
      EXPECT_TRUE(ordering::Keeps(InsertionTour(costs), size, {}));
    }
  }
}

// Results of J. L. Bentley (1992) and D. S. Johnson, L. A. McGeoch (1997) for such instances.
TEST(FirstTours, AreAsGoodAsPublishedOnes) {
  for (const auto& [name, optimum] :
       {std::pair("kroA100", 21282), std::pair("berlin52", 7542), std::pair("eil51", 426)}) {
    const Costs costs = ordering::CorpusInstance(name).costs;
    const auto ratio = [&, optimum = optimum](const Tour& tour) {
      return static_cast<double>(TourLength(costs, tour)) / optimum;
    };
    EXPECT_LE(ratio(NearestNeighbourTour(costs, 0)), 1.35) << name;
    EXPECT_LE(ratio(InsertionTour(costs)), 1.15) << name;
  }
}

}  // namespace
}  // namespace slicefarm::lab::first_tours_test
