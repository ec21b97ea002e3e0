#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::slicing {

/// Encoding of the data behind a PLY header.
enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
/// Number type of a PLY property.
enum class PlyType : uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// Returns the size in bytes of a number of this type in a binary file.
size_t PlySize(PlyType type);

/// Property of an element: one number, or a list of numbers preceded by its length.
struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< type of a list's length
  PlyType type = PlyType::kFloat;
};

/// Kind of element, such as `vertex`. The file has `count` of these elements in sequence.
struct PlyElement {
  std::string name;
  int64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// Parsed PLY header.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  size_t bytes = 0;   ///< size of the header, with `end_header` and its line end
  int64_t lines = 0;  ///< number of lines of the header
};

/// Reads the header of a PLY file. The function does not check the element
/// counts against the data. Errors: MESH_MALFORMED with the line; MESH_TRUNCATED without
/// `end_header`.
absl::StatusOr<PlyHeader> ReadPlyHeader(std::string_view bytes);

}  // namespace slicefarm::slicing
