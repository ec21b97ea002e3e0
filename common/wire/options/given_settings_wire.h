#pragma once

#include <vector>

#include "common/model/setting.h"
#include "common/model/setting_source.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

// Conversion of settings in the form in which clients give them.

/// Converts a setting to its message.
inline v1::Setting ToProto(const Setting& setting) {
  v1::Setting proto;
  proto.set_key(setting.key);
  proto.set_value(setting.value);
  proto.set_from_profile(setting.source == Source::kProfile);
  return proto;
}

/// Returns the setting of a message, including its source (profile or request).
inline Setting FromProto(const v1::Setting& proto) {
  return {proto.key(), proto.value(), proto.from_profile() ? Source::kProfile : Source::kRequest};
}

/// Converts all settings and appends their messages.
inline void SettingsToProto(const std::vector<Setting>& settings,
                            google::protobuf::RepeatedPtrField<v1::Setting>* proto) {
  for (const Setting& setting : settings) *proto->Add() = ToProto(setting);
}

/// Returns the settings of all messages.
inline std::vector<Setting> SettingsFromProto(
    const google::protobuf::RepeatedPtrField<v1::Setting>& proto) {
  std::vector<Setting> settings;
  settings.reserve(proto.size());
  for (const v1::Setting& setting : proto) settings.push_back(FromProto(setting));
  return settings;
}

/// Converts the sources of settings to their messages and back.
inline void SourcesToProto(const std::vector<SettingSource>& sources,
                           google::protobuf::RepeatedPtrField<v1::SettingSource>* proto) {
  for (const SettingSource& each : sources) {
    v1::SettingSource& source = *proto->Add();
    source.set_source(each.source);
    source.mutable_keys()->Assign(each.keys.begin(), each.keys.end());
  }
}
inline std::vector<SettingSource> SourcesFromProto(
    const google::protobuf::RepeatedPtrField<v1::SettingSource>& proto) {
  std::vector<SettingSource> sources;
  for (const v1::SettingSource& each : proto)
    sources.push_back({each.source(), {each.keys().begin(), each.keys().end()}});
  return sources;
}

}  // namespace slicefarm
