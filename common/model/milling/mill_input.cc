#include "common/model/milling/mill_input.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/base/sha256.h"

namespace slicefarm {
namespace {

// The numbers are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Vertex) == 3 * sizeof(Coord));
static_assert(sizeof(std::array<uint32_t, 3>) == 3 * sizeof(uint32_t));

template <class T>
std::string_view BytesOf(const T* values, size_t count) {
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

void Add(const IndexedMesh& mesh, Sha256& hash) {
  const std::array<uint64_t, 2> sizes = {mesh.vertices.size(), mesh.triangles.size()};
  hash.Add(BytesOf(sizes.data(), sizes.size()));
  hash.Add(BytesOf(mesh.vertices.data(), mesh.vertices.size()));
  hash.Add(BytesOf(mesh.triangles.data(), mesh.triangles.size()));
}

}  // namespace

std::string DigestOf(const IndexedMesh& part, const IndexedMesh& stock) {
  Sha256 hash;
  Add(part, hash);
  Add(stock, hash);
  return hash.Hex();
}

}  // namespace slicefarm
