#include "services/coordinator/store/jobs/job_record.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

using Json = nlohmann::ordered_json;

/// Reads `key` if it exists and has the right type.
template <typename T>
void Take(const Json& json, const char* key, T& value) {
  const auto found = json.find(key);
  if (found == json.end()) return;
  try {
    value = found->get<T>();
  } catch (const Json::exception&) {
    // A field of another type keeps its default value, like a missing field.
  }
}

absl::Status ParseObject(const std::string& text, Json& json) {
  json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_object()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                   "a record of the store cannot be read");
}

std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json CostJson(const Cost& cost) {
  return {{"currency", cost.currency},
          {"setup", cost.setup},
          {"machine", cost.machine},
          {"energy", cost.energy},
          {"filament", cost.filament}};
}

void TakeCost(const Json& json, Cost& cost) {
  if (!json.is_object()) return;
  Take(json, "currency", cost.currency);
  Take(json, "setup", cost.setup);
  Take(json, "machine", cost.machine);
  Take(json, "energy", cost.energy);
  Take(json, "filament", cost.filament);
}

/// Returns the amounts of a share as a list, because a job may have a thousand of them.
Json ShareJson(const PrintShare& share) {
  const FilamentUse& filament = share.filament;
  return {share.time_s, filament.length_mm, filament.volume_mm3, filament.mass_g, filament.cost};
}

void TakeShare(const Json& json, PrintShare& share) {
  std::array<double, 5> amounts = {};
  try {
    amounts = json.get<std::array<double, 5>>();
  } catch (const Json::exception&) {
    return;  // like Take
  }
  share = {amounts[0], {amounts[1], amounts[2], amounts[3], amounts[4]}};
}

Json SharesJson(const PrintShares& shares) {
  Json json = {{"objects", Json::array()}, {"shared", ShareJson(shares.shared)}};
  for (const ObjectShares& object : shares.objects) {
    Json copies = Json::array();
    for (const PrintShare& copy : object.copies) copies.push_back(ShareJson(copy));
    json["objects"].push_back({{"name", object.name}, {"copies", std::move(copies)}});
  }
  return json;
}

void TakeShares(const Json& json, PrintShares& shares) {
  if (!json.is_object()) return;
  TakeShare(json.value("shared", Json::array()), shares.shared);
  for (const Json& given : json.value("objects", Json::array())) {
    if (!given.is_object()) continue;
    ObjectShares& object = shares.objects.emplace_back();
    Take(given, "name", object.name);
    for (const Json& copy : given.value("copies", Json::array()))
      TakeShare(copy, object.copies.emplace_back());
  }
}

}  // namespace

JobError JobErrorOf(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  return {status.code(), std::string(ReasonName(detail.reason)), std::string(status.message()),
          detail.metadata};
}

std::string ToJson(const JobError& error) {
  return Dump({{"code", static_cast<int>(error.code)},
               {"reason", error.reason},
               {"message", error.message},
               {"metadata", error.metadata}});
}

std::string ToJson(const JobResult& result) {
  return Dump({{"tenant", result.tenant},
               {"gcode_sha256", result.gcode_sha256},
               {"gcode_size", result.gcode_size},
               {"report_sha256", result.report_sha256},
               {"print_time_s", result.print_time_s},
               {"filament_mm", result.filament_mm},
               {"filament_mm3", result.filament_mm3},
               {"filament_g", result.filament_g},
               {"layers", result.layers},
               {"cached", result.cached},
               {"cost", CostJson(result.cost)},
               {"shares", SharesJson(result.shares)},
               {"warnings", result.warnings}});
}

std::string ToJson(const std::map<std::string, std::string>& labels) { return Dump(Json(labels)); }

absl::Status FromJson(const std::string& text, JobError& error) {
  Json json;
  if (absl::Status parsed = ParseObject(text, json); !parsed.ok()) return parsed;
  int code = static_cast<int>(error.code);
  Take(json, "code", code);
  error.code = static_cast<absl::StatusCode>(code);
  Take(json, "reason", error.reason);
  Take(json, "message", error.message);
  Take(json, "metadata", error.metadata);
  return absl::OkStatus();
}

absl::Status FromJson(const std::string& text, JobResult& result) {
  Json json;
  if (absl::Status parsed = ParseObject(text, json); !parsed.ok()) return parsed;
  Take(json, "tenant", result.tenant);
  Take(json, "gcode_sha256", result.gcode_sha256);
  Take(json, "gcode_size", result.gcode_size);
  Take(json, "report_sha256", result.report_sha256);
  Take(json, "print_time_s", result.print_time_s);
  Take(json, "filament_mm", result.filament_mm);
  Take(json, "filament_mm3", result.filament_mm3);
  Take(json, "filament_g", result.filament_g);
  Take(json, "layers", result.layers);
  Take(json, "cached", result.cached);
  TakeCost(json.value("cost", Json::object()), result.cost);
  TakeShares(json.value("shares", Json::object()), result.shares);
  Take(json, "warnings", result.warnings);
  return absl::OkStatus();
}

absl::Status FromJson(const std::string& text, std::map<std::string, std::string>& labels) {
  Json json;
  if (absl::Status parsed = ParseObject(text, json); !parsed.ok()) return parsed;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string()) labels[key] = value.get<std::string>();
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
