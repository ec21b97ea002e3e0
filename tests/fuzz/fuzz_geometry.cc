#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/cgal_judge_test.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/boolean/region_pairs_test.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"

namespace {

using slicefarm::ClipperBoolean;
using slicefarm::Differences;
using slicefarm::MultiPolygon;
using slicefarm::Operation;
using slicefarm::RegionPair;

[[noreturn]] void Fail(const char* what, const Differences& found, const RegionPair& pair) {
  std::fprintf(stderr, "%s: %s\na: %s\nb: %s\n", what, ToText(found).c_str(),
               ToText(pair.a).c_str(), ToText(pair.b).c_str());
  std::abort();
}

/// Checks boolean operations. The bounds are the same as in
/// common/geometry/boolean/differential_test.cc.
void CheckBooleans(const RegionPair& pair) {
  for (const Operation op : {Operation::kUnion, Operation::kIntersection, Operation::kDifference}) {
    const auto got = TryBoolean(pair.a, pair.b, op);
    if (!got || *got == ClipperBoolean(pair.a, pair.b, op)) continue;
    const Differences found = JudgeBoolean(*got, pair.a, pair.b, op);
    if (found.thickness_nm >= 1 || found.distance_nm >= 0.71) Fail("boolean", found, pair);
  }
}

void CheckOffset(const MultiPolygon& got, const MultiPolygon& want, const RegionPair& pair) {
  if (got == want) return;
  const Differences found = JudgeEqual(got, want);
  if (found.thickness_nm >= 2) Fail("offset", found, pair);
}

void CheckOffsets(const RegionPair& pair, slicefarm::Coord distance_nm) {
  if (distance_nm == 0) return;
  const MultiPolygon want = slicefarm::ClipperOffset(pair.a, distance_nm);
  if (const auto got = TryOffset(pair.a, distance_nm)) CheckOffset(got->polygons, want, pair);
  if (distance_nm > 0 || pair.a.size() != 1) return;
  if (const auto got = TryErode(pair.a[0], -distance_nm)) CheckOffset(*got, want, pair);
}

}  // namespace

/// Compares slicefarm's results with Clipper's, and with CGAL's if they differ. Each two bytes are
/// a choice of MakeRegionPair.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto pick = [&](uint32_t below) -> uint32_t {
    if (size == 0) return 0;
    uint32_t choice = 0;
    for (size_t i = std::min<size_t>(size, 2); i > 0; --i, ++data, --size)
      choice = 256 * choice + *data;
    return choice % below;
  };
  const auto distance_nm = static_cast<slicefarm::Coord>(pick(6000)) * 1'000 - 3'000'000;
  const RegionPair pair = slicefarm::MakeRegionPair(pick);
  CheckBooleans(pair);
  CheckOffsets(pair, distance_nm);
  return 0;
}
