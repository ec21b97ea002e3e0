#include "services/coordinator/algo/pipeline/print_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace slicefarm::coordinator::print_shares_test {
namespace {

/// Returns the names of `count` copies of each object, in turn.
std::vector<CopyName> NamesOf(int objects, int count) {
  std::vector<CopyName> names;
  for (int copy = 0; copy < count; ++copy)
    for (int object = 0; object < objects; ++object)
      names.push_back({std::string(1, static_cast<char>('a' + object)), object, copy, count});
  return names;
}

/// Returns shares with `fraction` of the total, divided by random weights.
std::vector<PrintShare> RandomShares(size_t count, const PrintShare& total, double fraction) {
  std::mt19937 random(7);  // NOLINT(cert-msc51-cpp)
  std::vector<double> weights;
  double sum = 0;
  for (size_t i = 0; i < count; ++i) sum += weights.emplace_back(1 + random() % 1'000'000);
  std::vector<PrintShare> shares;
  for (const double weight : weights) {
    const double part = fraction * weight / sum;
    const FilamentUse& all = total.filament;
    shares.push_back(
        {total.time_s * part,
         {all.length_mm * part, all.volume_mm3 * part, all.mass_g * part, all.cost * part}});
  }
  return shares;
}

std::vector<PrintShare> AllOf(const PrintShares& print) {
  std::vector<PrintShare> all = {print.shared};
  for (const ObjectShares& object : print.objects)
    all.insert(all.end(), object.copies.begin(), object.copies.end());
  return all;
}

constexpr PrintShare kTotal = {12345.678901234567,
                               {9876.54321, 23756.1234567, 29.4575930863, 0.7364}};

struct Case {
  const char* name;
  int objects;
  int copies;
  double fraction;  ///< part of the total that copies own
};

class Division : public testing::TestWithParam<Case> {};

TEST_P(Division, AddsUpExactlyInAnyOrder) {
  const Case& given = GetParam();
  const auto names = NamesOf(given.objects, given.copies);
  const PrintShares print =
      DividePrint(names, RandomShares(names.size(), kTotal, given.fraction), kTotal);
  ASSERT_EQ(print.objects.size(), static_cast<size_t>(given.objects));
  std::vector<PrintShare> all = AllOf(print);
  ASSERT_EQ(all.size(), names.size() + 1);
  std::mt19937 random(1);  // NOLINT(cert-msc51-cpp)
  for (int round = 0; round < 10; ++round) {
    EXPECT_EQ((ObjectShares{"", all}.Total()), kTotal);
    std::ranges::shuffle(all, random);
  }
  for (const PrintShare& share : all) {
    EXPECT_GE(share.time_s, 0);
    EXPECT_GE(share.filament.mass_g, 0);
  }
}

TEST_P(Division, LosesLessThanAUnitOfAShare) {
  const Case& given = GetParam();
  const auto names = NamesOf(given.objects, given.copies);
  const auto shares = RandomShares(names.size(), kTotal, given.fraction);
  const PrintShares print = DividePrint(names, shares, kTotal);
  for (size_t i = 0; i < names.size(); ++i) {
    const auto& copies = print.objects[static_cast<size_t>(names[i].object)].copies;
    const double excess_s = std::max(0.0, given.fraction - 1) * kTotal.time_s;
    EXPECT_NEAR(copies[static_cast<size_t>(names[i].copy)].time_s, shares[i].time_s,
                2e-6 + excess_s);
  }
}

TEST_P(Division, CostsAddUpExactly) {
  const Case& given = GetParam();
  const auto names = NamesOf(given.objects, given.copies);
  const PrintShares print =
      DividePrint(names, RandomShares(names.size(), kTotal, given.fraction), kTotal);
  const Cost cost = {"EUR", 1.5, 6.85871050068587, 0.123456789, 0.7364398271575};
  const CostShares costs = DivideCost(cost, print, kTotal);
  ASSERT_EQ(costs.copies.size(), names.size());
  Cost sum = costs.shared;
  double total = costs.shared_total;
  for (const Cost& copy : costs.copies) {
    EXPECT_EQ(copy.setup, 0);
    EXPECT_GT(copy.machine, 0);
    sum.machine += copy.machine;
    sum.energy += copy.energy;
    sum.filament += copy.filament;
    total += copy.Total();
  }
  EXPECT_EQ(sum, cost);
  EXPECT_EQ(total, cost.Total());
}

INSTANTIATE_TEST_SUITE_P(Jobs, Division,
                         testing::Values(Case{"One", 1, 1, 0.9}, Case{"OneWithAll", 1, 1, 1},
                                         Case{"ThreeWithCopies", 3, 7, 0.8},
                                         Case{"Many", 10, 100, 1}, Case{"TooMuch", 3, 2, 1 + 1e-9}),
                         [](const auto& info) { return info.param.name; });

TEST(PrintShares, WithoutCopiesAllIsShared) {
  const PrintShares print = DividePrint({}, {}, kTotal);
  EXPECT_TRUE(print.objects.empty());
  EXPECT_EQ(print.shared, kTotal);
}

TEST(PrintShares, WithoutMassTheFilamentsCostIsShared) {
  const PrintShare total = {10, {}};
  const auto names = NamesOf(1, 1);
  const PrintShares print = DividePrint(names, {{8, {}}}, total);
  const CostShares costs = DivideCost({"", 0, 4, 0, 3}, print, total);
  EXPECT_EQ(costs.copies[0].filament, 0);
  EXPECT_EQ(costs.shared.filament, 3);
  EXPECT_DOUBLE_EQ(costs.copies[0].machine, 3.2 - std::fmod(3.2, 1.0 / (1 << 20)));
}

}  // namespace
}  // namespace slicefarm::coordinator::print_shares_test
