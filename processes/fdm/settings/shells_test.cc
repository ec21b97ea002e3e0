#include "processes/fdm/settings/shells.h"

#include <gtest/gtest.h>

#include <string>

#include "common/config/resolve.h"
#include "common/model/options/infill_options.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/draft_of_test.h"

namespace slicefarm::config::fdm::shells_test {
namespace {

ResolvedSettings Resolved(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value});
  auto resolved = Resolve(settings, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? *std::move(resolved) : ResolvedSettings{};
}

struct Case {
  const char* name;
  const char *layers, *thickness, *layer_height, *first_layer_height;
  int32_t most, spare;
  int32_t on_bed;
};

TEST(DeriveShells, LayersAreAsManyAsThicknessAsksFor) {
  const Case cases[] = {{"more", "2", "0.9", "0.2", "0.2", 5, 3, 5},
                        {"exact multiples take no more", "2", "0.6", "0.2", "0.2", 3, 1, 3},
                        {"just reached", "3", "0.7", "0.1", "0.1", 7, 4, 7},
                        {"layers ask for more", "7", "0.9", "0.2", "0.2", 7, 0, 7},
                        {"none stays none", "0", "0.9", "0.2", "0.2", 0, 0, 0},
                        {"a thick first layer counts as such", "3", "0.5", "0.15", "0.2", 4, 1, 3},
                        {"so does a thin one", "1", "0.6", "0.2", "0.1", 4, 3, 4}};
  for (const Case& c : cases) {
    const ResolvedSettings resolved = Resolved({{"bottom_solid_layers", c.layers},
                                                {"bottom_solid_min_thickness", c.thickness},
                                                {"layer_height", c.layer_height},
                                                {"first_layer_height", c.first_layer_height}});
    const InfillOptions& infill = FdmOf(resolved.settings).region.infill;
    EXPECT_EQ(infill.bottom_solid_layers, c.most) << c.name;
    EXPECT_EQ(infill.bottom_spare.layers, c.spare) << c.name;
    EXPECT_EQ(BottomLayers(resolved.settings), c.on_bed) << c.name;
    EXPECT_NE(resolved.effective_text.find(std::string("\nbottom_solid_layers = ") + c.layers),
              std::string::npos)
        << c.name << ": as it was given, so that the text means the same again";
    EXPECT_EQ(infill.top_spare, ShellExtra{}) << c.name;
  }
}

TEST(DeriveShells, VasesAreHollowFromThere) {
  const ResolvedSettings vase = Resolved({{"spiral_vase", "1"},
                                          {"bottom_solid_layers", "3"},
                                          {"bottom_solid_min_thickness", "0.5"},
                                          {"layer_height", "0.15"},
                                          {"first_layer_height", "0.2"}});
  EXPECT_EQ(vase.settings.object.hollow_from, 3);
}

}  // namespace
}  // namespace slicefarm::config::fdm::shells_test
