#include <cstddef>
#include <cstdint>
#include <string_view>

#include "services/slicing/algo/mesh_reader/mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  using namespace slicefarm::slicing;
  for (const ReadDepth depth : {ReadDepth::kStructure, ReadDepth::kMeshes})
    (void)ReadMeshFile(bytes, slicefarm::MeshFormat::FUZZ_FORMAT, 10'000, depth, {});
  return 0;
}
