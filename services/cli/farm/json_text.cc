#include "services/cli/farm/json_text.h"

#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>

namespace slicefarm::cli {
namespace {

std::string ToJson(const google::protobuf::Message& message, bool indented) {
  google::protobuf::util::JsonPrintOptions print;
  print.add_whitespace = indented;
  print.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, print);
  return status.ok() ? json : "{}";
}

void ClearSettings(v1::JobSpec& spec) {
  spec.clear_settings();
  spec.clear_project_settings();
  spec.clear_without_effect();
  spec.clear_notes();
  for (v1::Object& object : *spec.mutable_objects()) {
    object.clear_settings();
    for (v1::Part& part : *object.mutable_parts()) part.clear_settings();
    for (v1::HeightRange& range : *object.mutable_height_ranges()) range.clear_settings();
  }
}

}  // namespace

std::string JsonLine(const google::protobuf::Message& message) { return ToJson(message, false); }

std::string IndentedJson(const google::protobuf::Message& message) { return ToJson(message, true); }

std::string JsonOfJob(v1::Job job, const std::string& output) {
  ClearSettings(*job.mutable_spec());
  auto json = nlohmann::ordered_json::parse(JsonLine(job), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return "{}";
  if (!output.empty()) json["output"] = output;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace slicefarm::cli
