#pragma once

#include <bit>
#include <cstring>
#include <optional>
#include <string_view>

#include "services/slicing/algo/mesh_io/ply_header.h"
#include "services/slicing/algo/mesh_io/text_lines.h"

namespace slicefarm::slicing {

/// Reader of the numbers of an ASCII PLY file. Each word is one number; line ends do not matter.
class PlyText {
 public:
  explicit PlyText(std::string_view bytes) : words_(bytes) {}

  /// Returns the next number. Returns nullopt at the end of the text. Also returns nullopt for a
  /// word that is not a number; malformed() is then true.
  std::optional<double> Next(PlyType) {
    const std::string_view word = words_.Next();
    const std::optional<double> number = word.empty() ? std::nullopt : ParseNumber(word);
    malformed_ = !word.empty() && !number;
    return number;
  }

  /// Returns true if the last word read was not a number.
  bool malformed() const { return malformed_; }

 private:
  Words words_;
  bool malformed_ = false;
};

/// Reader of the numbers of a binary PLY file.
template <std::endian kOrder>
class PlyBinary {
 public:
  explicit PlyBinary(std::string_view bytes) : bytes_(bytes) {}

  /// Returns the next number, or nothing if too few bytes are left.
  std::optional<double> Next(PlyType type) {
    const size_t size = PlySize(type);
    if (size > bytes_.size()) return std::nullopt;
    const char* at = bytes_.data();
    bytes_.remove_prefix(size);
    switch (type) {
      case PlyType::kInt8:
        return As<int8_t, uint8_t>(at);
      case PlyType::kUint8:
        return As<uint8_t, uint8_t>(at);
      case PlyType::kInt16:
        return As<int16_t, uint16_t>(at);
      case PlyType::kUint16:
        return As<uint16_t, uint16_t>(at);
      case PlyType::kInt32:
        return As<int32_t, uint32_t>(at);
      case PlyType::kUint32:
        return As<uint32_t, uint32_t>(at);
      case PlyType::kFloat:
        return As<float, uint32_t>(at);
      case PlyType::kDouble:
        return As<double, uint64_t>(at);
    }
    return std::nullopt;
  }

  /// Always returns false, because every bit pattern is a number.
  bool malformed() const { return false; }

 private:
  template <typename T, typename Bits>
  static double As(const char* at) {
    Bits bits = 0;
    if constexpr (kOrder == std::endian::native) {
      std::memcpy(&bits, at, sizeof bits);
    } else {
      for (size_t i = 0; i < sizeof bits; ++i)
        bits = static_cast<Bits>(static_cast<uint64_t>(bits) << 8 | static_cast<uint8_t>(at[i]));
    }
    return static_cast<double>(std::bit_cast<T>(bits));
  }

  std::string_view bytes_;
};

}  // namespace slicefarm::slicing
