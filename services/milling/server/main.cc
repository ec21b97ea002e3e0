#include "common/rpc/server/serve.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/milling/server/milling_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::milling::MakeLocalMilling();
  return slicefarm::rpc::ServeStage(
      argc, argv, "milling", "Programs of milling machines",
      [&](auto& gate) { return slicefarm::milling::MakeMillingService(*stage, gate); });
}
