#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// Returns the file as binary G-code (.bgcode), version 1, as Prusa's firmware reads it. It has
/// metadata of file, printer, print and slicer, and thumbnails. The program is in blocks of up to
/// 64 KiB of text, encoded by MeatPack with comment lines and compressed by Heatshrink 12/4. Each
/// block has a CRC32.
///
/// `gcode`: the form that slicefarm and PrusaSlicer write. Its head has thumbnails and "generated
/// by". Its end has the `key = value` lines of filament and times, then the settings between
/// "prusaslicer_config = begin" and "end". All of these become metadata and are removed from the
/// program.
///
/// Errors: InvalidArgument for a line of more than 64 KiB, and for thumbnails that are not base64.
/// Cost: O(bytes). Source: libbgcode, doc/specifications.md.
absl::StatusOr<std::string> BinaryGcode(std::string_view gcode);

}  // namespace slicefarm::gcode
