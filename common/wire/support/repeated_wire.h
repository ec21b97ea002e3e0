#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/wire/support/wire_error.h"
#include "google/protobuf/repeated_field.h"

namespace slicefarm {

// Conversion of lists. ToProto or FromProto of the element's type converts each element. Errors
// contain the index of the element.

/// Converts all models to messages in the field `field`.
template <typename Model, typename Proto>
absl::Status AllToProto(const std::vector<Model>& models, std::string_view field,
                        google::protobuf::RepeatedPtrField<Proto>* protos) {
  protos->Reserve(static_cast<int>(models.size()));
  for (size_t i = 0; i < models.size(); ++i) {
    if (absl::Status status = ToProto(models[i], protos->Add()); !status.ok()) {
      return Within(field, i, status);
    }
  }
  return absl::OkStatus();
}

/// Converts all messages in the field `field` to models.
template <typename Model, typename Proto>
absl::Status AllFromProto(const google::protobuf::RepeatedPtrField<Proto>& protos,
                          std::string_view field, std::vector<Model>* models) {
  models->reserve(protos.size());
  for (int i = 0; i < protos.size(); ++i) {
    absl::StatusOr<Model> model = FromProto(protos[i]);
    if (!model.ok()) return Within(field, i, model.status());
    models->push_back(*std::move(model));
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
