#include <cstddef>
#include <cstdint>
#include <string>

#include "services/slicing/algo/mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const slicefarm::MeshFile file{"fuzz", slicefarm::MeshFormat::FUZZ_FORMAT,
                                 std::string(data, data + size)};
  (void)slicefarm::slicing::ReadMesh(file, 10'000, {});
  return 0;
}
