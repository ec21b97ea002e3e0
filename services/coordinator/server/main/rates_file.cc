#include "services/coordinator/server/main/rates_file.h"

#include <fmt/core.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace slicefarm::coordinator {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMaxCurrencyBytes = 16;

absl::Status Refused(std::string_view key, std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("rates: {}: {}", key, why));
}

absl::Status TakeAmount(const std::string& key, const Json& value, Rates& rates) {
  static const std::map<std::string_view, double Rates::*> kAmounts = {
      {"setup", &Rates::setup},
      {"machine_per_hour", &Rates::machine_per_hour},
      {"energy_per_kwh", &Rates::energy_per_kwh},
      {"printer_power_w", &Rates::printer_power_w},
      {"filament_per_kg", &Rates::filament_per_kg}};
  const auto amount = kAmounts.find(key);
  if (amount == kAmounts.end()) return Refused(key, "unknown key");
  if (!value.is_number() || value.get<double>() < 0) {
    return Refused(key, "a number that is 0 or more is needed");
  }
  rates.*amount->second = value.get<double>();
  return absl::OkStatus();
}

absl::Status TakeCurrency(const Json& value, Rates& rates) {
  if (!value.is_string() || value.get_ref<const std::string&>().size() > kMaxCurrencyBytes) {
    return Refused("currency",
                   fmt::format("a text of at most {} bytes is needed", kMaxCurrencyBytes));
  }
  rates.currency = value.get<std::string>();
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<Rates> ParseRates(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return absl::InvalidArgumentError("rates: a JSON object is needed");
  Rates rates;
  for (const auto& [key, value] : json.items()) {
    absl::Status taken =
        key == "currency" ? TakeCurrency(value, rates) : TakeAmount(key, value, rates);
    if (!taken.ok()) return taken;
  }
  return rates;
}

absl::StatusOr<Rates> ReadRates(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!file || !(text << file.rdbuf())) {
    return absl::InvalidArgumentError(fmt::format("rates: {} cannot be read", path));
  }
  return ParseRates(text.str());
}

}  // namespace slicefarm::coordinator
