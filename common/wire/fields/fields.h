#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/members.h"
#include "common/wire/fields/enumerators.h"
#include "common/wire/fields/field_reader.h"
#include "common/wire/fields/field_writer.h"

namespace slicefarm {

// Serialization of the options of stages. The values of the members follow one another without
// names or field numbers, because both ends have the same build (StageCall). A new member needs no
// change in this file.
//
// Supported types are numbers, booleans, enumerations, texts, cutters, aggregates of supported
// types, and vectors, arrays and optionals of any supported type. A struct that is derived from a
// settings row and has further tables declares both: the type Row and the function TablesOf. Equal
// long texts (SharedText) are sent once.

namespace internal {

template <typename T>
inline constexpr bool kIsVector = false;
template <typename T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <typename T>
inline constexpr bool kIsArray = false;
template <typename T, size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;
template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Writes a value of any supported type.
template <typename T>
void WriteField(const T& value, FieldWriter& writer) {
  if constexpr (std::is_enum_v<T>) {
    writer.Write(static_cast<int64_t>(value));
  } else if constexpr (kIsVector<T> || kIsArray<T>) {
    if constexpr (kIsVector<T>) writer.Write(static_cast<int64_t>(value.size()));
    for (const auto& item : value) WriteField(item, writer);
  } else if constexpr (kIsOptional<T>) {
    writer.Write(value.has_value());
    if (value.has_value()) WriteField(*value, writer);
  } else if constexpr (requires { writer.Write(value); }) {
    writer.Write(value);
  } else if constexpr (requires { typename T::Row; }) {
    WriteField(static_cast<const typename T::Row&>(value), writer);
    std::apply([&](const auto&... table) { (WriteField(table, writer), ...); }, T::TablesOf(value));
  } else {
    std::apply([&](const auto&... member) { (WriteField(member, writer), ...); }, MembersOf(value));
  }
}

/// Reads a value that WriteField wrote.
template <typename T>
void ReadField(FieldReader& reader, T* value) {
  if constexpr (std::is_enum_v<T>) {
    *value = static_cast<T>(reader.Index(kEnumerators<T>));
  } else if constexpr (kIsVector<T>) {
    value->clear();
    for (int64_t left = reader.Count(); left > 0 && reader.ok(); --left)
      ReadField(reader, &value->emplace_back());
  } else if constexpr (kIsArray<T>) {
    for (auto& item : *value) ReadField(reader, &item);
  } else if constexpr (kIsOptional<T>) {
    value->reset();
    if (reader.Index(2) == 1) ReadField(reader, &value->emplace());
  } else if constexpr (requires { reader.Read(value); }) {
    reader.Read(value);
  } else if constexpr (requires { typename T::Row; }) {
    ReadField(reader, static_cast<typename T::Row*>(value));
    std::apply([&](auto&... table) { (ReadField(reader, &table), ...); }, T::TablesOf(*value));
  } else {
    std::apply([&](auto&... member) { (ReadField(reader, &member), ...); }, MembersOf(*value));
  }
}

}  // namespace internal

/// Returns the members of an aggregate as bytes. Cost: O(bytes).
template <typename T>
std::string PackFields(const T& value) {
  internal::FieldWriter writer;
  internal::WriteField(value, writer);
  return std::move(writer).Finish();
}

/// Returns the aggregate that PackFields wrote. Errors: REQUEST_MALFORMED for missing or additional
/// bytes, for numbers that are not finite or beyond limits::kMaxPrintHeight, and for unknown
/// enumerators; REQUEST_TOO_LARGE for texts of more than limits::kMaxFieldBytes. CheckOptions, not
/// this function, checks the ranges of single values. Cost: O(bytes), in time and in memory.
template <typename T>
absl::StatusOr<T> UnpackFields(std::string_view bytes) {
  internal::FieldReader reader(bytes);
  T value;
  internal::ReadField(reader, &value);
  if (absl::Status status = reader.Finish(); !status.ok()) return status;
  return value;
}

}  // namespace slicefarm
