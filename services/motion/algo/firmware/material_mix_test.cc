#include "services/motion/algo/firmware/material_mix.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::material_mix_test {
namespace {

/// Returns a field from the first material at x = 0 to the second at x = 10.
MaterialField Gradient(double step) {
  MaterialField field;
  field.step = step;
  for (const double first : {1.0, 0.0})
    field.parts.push_back({.kind = DensityField::Kind::kGrid,
                           .grid = {{2, 1, 1}, {0, 0, 0}, {10, 1, 1}, {first, 1 - first}}});
  return field;
}

std::string TextAlong(const MaterialField& field, std::initializer_list<double> places,
                      GcodeFlavor flavor = GcodeFlavor::kMarlin2) {
  MaterialMix mix(FirmwareOf(flavor), &field);
  GcodeText out;
  for (const double x : places) mix.SetFor({x, 0, 0}, out);
  return out.Take();
}

TEST(MaterialMix, IsToldFirstAndWhereItChangesByMoreThanAStep) {
  EXPECT_EQ(TextAlong(Gradient(0.1), {0, 0.5, 0.9, 1.1, 2, 2.2}),
            "M163 S0 P1\nM163 S1 P0\nM164 S0\n"
            "M163 S0 P0.89\nM163 S1 P0.11\nM164 S0\n"
            "M163 S0 P0.78\nM163 S1 P0.22\nM164 S0\n");
}

TEST(MaterialMix, RepRapFirmwareHasOneCommandForAll) {
  EXPECT_EQ(TextAlong(Gradient(0.1), {0, 2}, GcodeFlavor::kRepRapFirmware),
            "M567 P0 E1:0\nM567 P0 E0.8:0.2\n");
}

TEST(MaterialMix, IsToldAnewOnceForgotten) {
  const MaterialField field = Gradient(0.5);
  MaterialMix mix(FirmwareOf(GcodeFlavor::kMarlin2), &field);
  GcodeText first, second;
  mix.SetFor({3, 0, 0}, first);
  mix.SetFor({3, 0, 0}, second);
  mix.Forget();
  GcodeText third;
  mix.SetFor({3, 0, 0}, third);
  const std::string text = first.Take();
  EXPECT_EQ(text, third.Take());
  EXPECT_EQ(second.Take(), "");
}

TEST(MaterialMix, WithoutAFieldThereIsNone) {
  MaterialMix mix(FirmwareOf(GcodeFlavor::kMarlin2), nullptr);
  GcodeText out;
  mix.SetFor({0, 0, 0}, out);
  EXPECT_EQ(out.Take(), "");
}

}  // namespace
}  // namespace slicefarm::motion::material_mix_test
