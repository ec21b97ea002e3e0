#include "processes/fdm/settings/shells.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/model/limits.h"
#include "common/model/options/infill_options.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm {
namespace {

/// Heights of stacked layers. The lowest layer may have a different height.
struct LayerStack {
  Coord first_nm = 0;
  Coord others_nm = 0;
};

LayerStack StackOf(const JobRows& settings) {
  const auto& object = settings.object;
  return {object.on_bed ? settings.slicing.first_layer_height_nm : object.layer_height_nm,
          object.layer_height_nm};
}

/// Returns the number of layers that always reach `thickness_mm`, at any height.
double MostLayers(double thickness_mm, const LayerStack& stack) {
  constexpr double kRounding = 1e-6;
  const double others_mm = ToMm(static_cast<double>(stack.others_nm));
  const double first_mm = ToMm(static_cast<double>(std::min(stack.first_nm, stack.others_nm)));
  return std::ceil((thickness_mm - first_mm) / others_mm - kRounding) + 1;
}

void DeriveShell(double thickness_mm, const LayerStack& stack, int32_t& layers, ShellExtra& spare) {
  spare = {};
  if (layers == 0 || thickness_mm <= 0) return;
  const auto most = static_cast<int32_t>(std::clamp<double>(
      MostLayers(thickness_mm, stack), layers, std::max<double>(layers, limits::kMaxLayers)));
  spare = {.layers = most - layers, .enough_nm = FromMm(thickness_mm)};
  layers = most;
}

}  // namespace

void DeriveShells(const SettingValues& draft, JobRows& settings) {
  InfillOptions& infill = FdmOf(settings).region.infill;
  const LayerStack stack = StackOf(settings);
  DeriveShell(draft.Number("top_solid_min_thickness"), stack, infill.top_solid_layers,
              infill.top_spare);
  DeriveShell(draft.Number("bottom_solid_min_thickness"), stack, infill.bottom_solid_layers,
              infill.bottom_spare);
}

int32_t BottomLayers(const JobRows& settings) {
  const InfillOptions& infill = FdmOf(settings).region.infill;
  const LayerStack stack = StackOf(settings);
  int32_t layers = 0;
  Coord height_nm = 0;
  while (layers < infill.bottom_solid_layers &&
         !IsSpared(infill.bottom_spare, infill.bottom_solid_layers, layers + 1, height_nm)) {
    height_nm += layers == 0 ? stack.first_nm : stack.others_nm;
    ++layers;
  }
  return layers;
}

}  // namespace slicefarm::config::fdm
