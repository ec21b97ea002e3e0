#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::load {

enum class PartSize { kTiny, kMedium, kHuge };

/// Which parts clients send.
enum class Mix {
  kTiny,
  kMedium,
  kHuge,
  kMixed,  ///< 80 % tiny, 18 % medium, 2 % huge
};

std::string_view MixName(Mix mix);
std::optional<Mix> MixFromName(std::string_view name);

/// The size of the `index`-th part of a run.
PartSize PickSize(Mix mix, uint64_t seed, uint64_t index);

/// Triangles of a part of this size: 12, 5 000, 500 000.
int TrianglesOf(PartSize size);

/// A closed part as binary STL, 84 + 50 n bytes. Tiny: a box of 4 to 12 mm; else a fluted vase of
/// 20 to 40 mm. Another seed gives other measures, so that no cache knows it.
/// Cost: O(triangles), some 30 ms for a huge one.
std::string MakePart(PartSize size, uint64_t seed);

}  // namespace slicefarm::load
