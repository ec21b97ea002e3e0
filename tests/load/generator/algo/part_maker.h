#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::load {

/// Size of a part.
enum class PartSize { kTiny, kMedium, kHuge };

/// Mix of parts that clients send.
enum class Mix {
  kTiny,
  kMedium,
  kHuge,
  kMixed,  ///< 80 % tiny, 18 % medium, 2 % huge
};

/// Returns the name of a mix.
std::string_view MixName(Mix mix);
/// Returns the mix with this name; nullopt if there is none.
std::optional<Mix> MixFromName(std::string_view name);

/// Returns the size of the `index`-th part of a run.
PartSize PickSize(Mix mix, uint64_t seed, uint64_t index);

/// Returns the number of triangles of a part of this size: 12, 5 000, 500 000.
int TrianglesOf(PartSize size);

/// Returns a closed part as binary STL of 84 + 50 n bytes. A tiny part is a box of 4 to 12 mm; all
/// others are fluted vases of 20 to 40 mm. Each seed gives other dimensions, so that no cache
/// contains the part. Cost: O(triangles), some 30 ms for a huge part.
std::string MakePart(PartSize size, uint64_t seed);

}  // namespace slicefarm::load
