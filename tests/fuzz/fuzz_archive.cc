#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "common/gcode/archive/gcode_archive.h"

// An archive lists the plates of which it can return the programs, or has an error; a plate that is
// not listed is an error.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace gcode = slicefarm::gcode;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto plates = gcode::PlatesOf(bytes);
  const auto first = gcode::TextOfPlate(bytes, gcode::kFirstPlate);
  if (first.ok() && !plates.ok()) std::abort();
  const auto joined = gcode::JoinedArchive({std::string(bytes)});
  if (joined.ok() && !gcode::PlatesOf(*joined).ok()) std::abort();
  if (!plates.ok()) return 0;
  if (gcode::TextOfPlate(bytes, plates->back() + 1).ok()) std::abort();
  const auto only = gcode::TextOfPlate(bytes, gcode::kOnlyPlate);
  if (only.ok() && plates->size() != 1) std::abort();
  return 0;
}
