#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace slicefarm::gcode {

// Constants of the format of binary G-code (.bgcode). Source: libbgcode's specification, version 1.
inline constexpr std::string_view kBinaryMagic = "GCDE";
inline constexpr uint32_t kBinaryVersion = 1;
inline constexpr uint16_t kCrc32 = 1;
inline constexpr uint16_t kIni = 0;  ///< code of the metadata's encoding: lines `key=value`
inline constexpr uint16_t kMeatPackComments = 2;

enum BlockType : uint16_t {
  kFileMetadata = 0,
  kGcode = 1,
  kSlicerMetadata = 2,
  kPrinterMetadata = 3,
  kPrintMetadata = 4,
  kThumbnail = 5,
};

enum Compression : uint16_t { kNone = 0, kDeflate = 1, kHeatshrink11 = 2, kHeatshrink12 = 3 };

}  // namespace slicefarm::gcode
