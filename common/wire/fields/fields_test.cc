#include "common/wire/fields/fields.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/options/cutter_text.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/settings.h"
#include "processes/engrave/model/engrave_settings.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/laser/model/exposure_settings.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm::fields_test {

enum class Hue : uint8_t { kRed, kGreen, kBlue };

struct Inner {
  Coord length_nm = 5;
  Point place = {1, -2};

  friend bool operator==(const Inner&, const Inner&) = default;
};

struct Outer {
  bool on = false;
  int32_t count = 3;
  double share = 0.25;
  Hue colour = Hue::kGreen;
  std::string name = "a";
  SharedText code = "G28";
  SharedText again = "G28";
  std::vector<Inner> list = {{}, {7, {}}};
  std::array<double, 2> pair = {1, 2};
  std::optional<Inner> maybe = {};

  friend bool operator==(const Outer&, const Outer&) = default;
};

namespace {

/// Calls `visit` with each leaf of `value`: numbers, texts, enumerations.
template <typename T, typename Visit>
void VisitLeaves(T& value, const Visit& visit) {
  if constexpr (internal::kIsVector<T> || internal::kIsArray<T>) {
    for (auto& item : value) VisitLeaves(item, visit);
  } else if constexpr (internal::kIsOptional<T>) {
    if (!value) value.emplace();
    VisitLeaves(*value, visit);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> ||
                       std::is_same_v<T, std::string> || std::is_same_v<T, SharedText> ||
                       std::is_same_v<T, Cutter>) {
    visit(value);
  } else if constexpr (requires { typename T::Row; }) {
    VisitLeaves(static_cast<typename T::Row&>(value), visit);
    std::apply([&](auto&... table) { (VisitLeaves(table, visit), ...); }, T::TablesOf(value));
  } else {
    std::apply([&](auto&... member) { (VisitLeaves(member, visit), ...); }, MembersOf(value));
  }
}

template <typename Leaf>
void Change(Leaf& leaf) {
  if constexpr (std::is_enum_v<Leaf>) {
    leaf = static_cast<Leaf>((static_cast<int>(leaf) + 1) % kEnumerators<Leaf>);
  } else if constexpr (std::is_same_v<Leaf, bool>) {
    leaf = !leaf;
  } else if constexpr (std::is_arithmetic_v<Leaf>) {
    leaf += 1;
  } else if constexpr (std::is_same_v<Leaf, Cutter>) {
    leaf = *ParseCutter(leaf.name() == "ball:4" ? "ball:6" : "ball:4");
  } else {
    leaf = std::string(leaf) + "x";
  }
}

/// Expects that a change of any single leaf changes the bytes, and that reading the bytes returns
/// the changed value.
template <typename T>
void ExpectEachLeafReturns(const T& value) {
  int leaves = 0;
  T copy = value;
  VisitLeaves(copy, [&](auto&) { ++leaves; });
  ASSERT_GT(leaves, 0);
  for (int changed = 0; changed < leaves; ++changed) {
    T sent = value;
    int at = 0;
    VisitLeaves(sent, [&](auto& leaf) {
      if (at++ == changed) Change(leaf);
    });
    const auto back = UnpackFields<T>(PackFields(sent));
    ASSERT_TRUE(back.ok()) << changed << ": " << back.status();
    EXPECT_EQ(*back, sent) << changed;
    EXPECT_NE(*back, value) << changed;
  }
}

TEST(Fields, EachMemberOfAllKindsReturns) { ExpectEachLeafReturns(Outer{}); }

TEST(Fields, EachMemberOfEachStagesOptionsReturns) {
  ExpectEachLeafReturns(SlicingOptions{});
  ExpectEachLeafReturns(FdmSettings{});
  ExpectEachLeafReturns(MotionOptions{});
  ExpectEachLeafReturns(PlanningOptions{});
  ExpectEachLeafReturns(OrderingOptions{});
  ExpectEachLeafReturns(ExposureSettings{});
  ExpectEachLeafReturns(MillSettings{});
  ExpectEachLeafReturns(EngraveSettings{});
}

TEST(Fields, ALongTextOfManyRowsIsSentOnce) {
  const SharedText text = std::string(10'000, 'x');
  std::vector<InfillOptions> table(100);
  for (InfillOptions& row : table) row.density_field = text;
  const std::string bytes = PackFields(table);
  EXPECT_LT(bytes.size(), 100'000U);
  const auto back = UnpackFields<std::vector<InfillOptions>>(bytes);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, table);
  EXPECT_EQ(&back->front().density_field.str(), &back->back().density_field.str());
}

TEST(Fields, EnumeratorsAreCounted) {
  EXPECT_EQ(kEnumerators<Hue>, 3);
  EXPECT_EQ(kEnumerators<FillPattern>, kFillPatternCount);
  EXPECT_EQ(kEnumerators<GcodeFlavor>, 6);
}

TEST(Fields, BytesThatAreCutOffOrTooManyAreRefused) {
  const std::string bytes = PackFields(Outer{});
  for (size_t size = 0; size < bytes.size(); ++size) {
    const auto cut = UnpackFields<Outer>(std::string_view(bytes).substr(0, size));
    EXPECT_EQ(DetailOf(cut.status()).reason, Reason::kRequestMalformed) << size;
  }
  const auto longer = UnpackFields<Outer>(bytes + "x");
  EXPECT_EQ(DetailOf(longer.status()).reason, Reason::kRequestMalformed);
}

template <typename T>
Reason RefusalOf(const T& value) {
  return DetailOf(UnpackFields<T>(PackFields(value)).status()).reason;
}

TEST(Fields, ValuesThatNoAlgorithmTakesAreRefused) {
  EXPECT_EQ(RefusalOf(Outer{.share = std::numeric_limits<double>::quiet_NaN()}),
            Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(Outer{.share = std::numeric_limits<double>::infinity()}),
            Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(Outer{.colour = static_cast<Hue>(3)}), Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(Outer{.list = {{.place = {int64_t{1} << 31, 0}}}}),
            Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(Outer{.list = {{.length_nm = limits::kMaxPrintHeight + 1}}}),
            Reason::kRequestMalformed);
  EXPECT_EQ(RefusalOf(Outer{.name = std::string(limits::kMaxFieldBytes + 1, 'x')}),
            Reason::kRequestTooLarge);
}

// A count larger than the number of remaining bytes is refused before memory is allocated.
TEST(Fields, AHugeCountIsRefused) {
  std::string bytes = PackFields(std::vector<Inner>{});
  bytes[6] = 1;
  const auto back = UnpackFields<std::vector<Inner>>(bytes);
  EXPECT_EQ(DetailOf(back.status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::fields_test
