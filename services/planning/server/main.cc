#include "common/rpc/server/serve.h"
#include "services/planning/server/planning_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage(
      argc, argv, "planning", "plans supports, rafts, skirts, seams and infill over a whole job",
      slicefarm::planning::MakePlanningService);
}
