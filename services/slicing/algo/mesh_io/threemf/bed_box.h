#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::slicing::threemf {

/// mm; around a bed's corners.
struct BedBox {
  std::array<double, 2> min = {0, 0};
  std::array<double, 2> size = {0, 0};
};

/// The box of what the setting `key` lists: `0x0,250x0,250x210,0x210`, or the same as a list of
/// JSON. Nothing for no such setting, for what is no list of corners, and for a bed without area.
std::optional<BedBox> BedBoxOf(const std::vector<Setting>& settings, std::string_view key);

}  // namespace slicefarm::slicing::threemf
