#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::slicing {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
enum class PlyType : uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// Bytes of a number of this type in a binary file.
size_t PlySize(PlyType type);

/// A number of each element, or a list of them with its length in front.
struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< of a list's length
  PlyType type = PlyType::kFloat;
};

/// What there are `count` of, one after the other.
struct PlyElement {
  std::string name;
  int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  size_t bytes = 0;   ///< of the header, `end_header` and its line end included
  int64_t lines = 0;  ///< of the header
};

/// The header of a PLY. The counts are what it claims: nothing is said about the data.
/// Errors: MESH_MALFORMED naming the line; MESH_TRUNCATED without `end_header`.
absl::StatusOr<PlyHeader> ReadPlyHeader(std::string_view bytes);

}  // namespace slicefarm::slicing
