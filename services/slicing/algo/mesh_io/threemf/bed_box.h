#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::slicing::threemf {

/// Bounding box of a bed's corners, in mm.
struct BedBox {
  std::array<double, 2> min = {0, 0};
  std::array<double, 2> size = {0, 0};
};

/// Returns the bounding box of the corners that the setting `key` lists, for example
/// `0x0,250x0,250x210,0x210`, or the same values as a JSON list. Returns nothing if the setting is
/// missing, is not a list of corners, or gives a bed without area.
std::optional<BedBox> BedBoxOf(const std::vector<Setting>& settings, std::string_view key);

}  // namespace slicefarm::slicing::threemf
