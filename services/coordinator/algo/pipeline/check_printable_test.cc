#include "services/coordinator/algo/pipeline/check_printable.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"

namespace slicefarm::coordinator::check_printable_test {
namespace {

SlicedLayer Layer(bool outline) {
  SlicedLayer layer;
  layer.sections.emplace_back();
  if (outline) layer.sections.back().regions.emplace_back();
  return layer;
}

TEST(CheckPrintable, WantsAnOutlineInOneLayerAtLeast) {
  EXPECT_TRUE(CheckPrintable(std::vector{Layer(false), Layer(true)}).ok());
  for (const std::vector<SlicedLayer>& layers :
       {std::vector<SlicedLayer>{}, std::vector{Layer(false)}, std::vector{SlicedLayer{}}})
    EXPECT_EQ(DetailOf(CheckPrintable(layers)).reason, Reason::kNothingToPrint);
}

}  // namespace
}  // namespace slicefarm::coordinator::check_printable_test
