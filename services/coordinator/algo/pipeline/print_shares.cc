#include "services/coordinator/algo/pipeline/print_shares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace slicefarm::coordinator {
namespace {

/// Multiples of this unit below 2^32 are added without rounding.
constexpr double kShareUnit = 1.0 / (1 << 20);

double RoundedDown(double amount) { return std::floor(amount / kShareUnit) * kShareUnit; }

/// Rounds the parts down to multiples of the unit and returns the exact rest of `total`, which is
/// at least 0.
double Divide(double total, std::span<double* const> parts) {
  double sum = 0;
  for (double* part : parts) sum += * part = RoundedDown(std::max(0.0, *part));
  while (sum > total) {
    double& largest =
        **std::ranges::max_element(parts, {}, [](const double* part) { return *part; });
    const double excess = std::ceil((sum - total) / kShareUnit) * kShareUnit;
    const double taken = std::min(largest, excess);
    largest -= taken;
    sum -= taken;
  }
  return total - sum;
}

/// Divides one amount of all items. `amount` returns a reference to the amount of an item.
template <typename Item, typename Amount>
double DivideItems(double total, std::vector<Item>& items, Amount amount) {
  std::vector<double*> parts;
  parts.reserve(items.size());
  for (Item& item : items) parts.push_back(&amount(item));
  return Divide(total, parts);
}

void Add(const FilamentUse& use, FilamentUse& sum) {
  sum.length_mm += use.length_mm;
  sum.volume_mm3 += use.volume_mm3;
  sum.mass_g += use.mass_g;
  sum.cost += use.cost;
}

double Share(double amount, double part, double whole) {
  return whole > 0 ? amount * part / whole : 0;
}

}  // namespace

PrintShare ObjectShares::Total() const {
  PrintShare total;
  for (const PrintShare& copy : copies) {
    total.time_s += copy.time_s;
    Add(copy.filament, total.filament);
  }
  return total;
}

PrintShares DividePrint(std::span<const CopyName> names, std::vector<PrintShare> shares,
                        const PrintShare& total) {
  PrintShares print;
  print.shared.time_s =
      DivideItems(total.time_s, shares, [](PrintShare& share) -> double& { return share.time_s; });
  for (double FilamentUse::*amount : {&FilamentUse::length_mm, &FilamentUse::volume_mm3,
                                      &FilamentUse::mass_g, &FilamentUse::cost})
    print.shared.filament.*amount =
        DivideItems(total.filament.*amount, shares,
                    [&](PrintShare& share) -> double& { return share.filament.*amount; });
  for (size_t i = 0; i < names.size(); ++i) {
    const auto object = static_cast<size_t>(names[i].object);
    if (print.objects.size() <= object) print.objects.resize(object + 1);
    print.objects[object].name = names[i].object_name;
    print.objects[object].copies.push_back(shares[i]);
  }
  return print;
}

CostShares DivideCost(const Cost& cost, const PrintShares& shares, const PrintShare& total) {
  CostShares costs;
  for (const ObjectShares& object : shares.objects)
    for (const PrintShare& copy : object.copies) {
      Cost& own = costs.copies.emplace_back();
      own.currency = cost.currency;
      own.machine = Share(cost.machine, copy.time_s, total.time_s);
      own.energy = Share(cost.energy, copy.time_s, total.time_s);
      own.filament = Share(cost.filament, copy.filament.mass_g, total.filament.mass_g);
    }
  costs.shared.currency = cost.currency;
  costs.shared.setup = cost.setup;
  for (double Cost::*item : {&Cost::machine, &Cost::energy, &Cost::filament})
    costs.shared.*item =
        DivideItems(cost.*item, costs.copies, [&](Cost& own) -> double& { return own.*item; });
  costs.shared_total = cost.Total();
  for (const Cost& copy : costs.copies) costs.shared_total -= copy.Total();
  return costs;
}

}  // namespace slicefarm::coordinator
