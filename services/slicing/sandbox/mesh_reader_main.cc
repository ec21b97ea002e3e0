#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/sandbox/reader_side.h"

// slicefarm-mesh-reader: reads one mesh and exits. slicefarm-slicing starts it.
int main() {
  using namespace slicefarm::slicing;
  RunReader(
      [](std::string_view bytes, slicefarm::MeshFormat format, double coordinate_limit,
         ReadDepth depth) { return ReadMeshFile(bytes, format, coordinate_limit, depth, {}); });
}
