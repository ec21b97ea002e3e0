#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/model/process.h"

namespace slicefarm::coordinator::sim {

/// What a job of the simulation is: a number of layers, each of which comes to a hash, and a fault.
struct Work {
  enum class Fault {
    kNone,
    kBadInput,           ///< the slicing stage says so
    kBadLayer,           ///< workers say so, of the layer in the middle
    kPoisonLayer,        ///< no worker can make the layer in the middle
    kKillsCoordinators,  ///< that run it
  };

  int64_t id = 0;  ///< equal for equal work
  int32_t layers = 1;
  int64_t layer_us = 1000;  ///< of a worker of speed 1
  Fault fault = Fault::kNone;
  slicefarm::Process process = slicefarm::kDefaultProcess;

  /// Whether the layer in the middle is one of these.
  bool InMiddle(int32_t first, int32_t last) const {
    return first <= layers / 2 && layers / 2 < last;
  }
};

/// What a stage says of input that is at fault.
absl::Status BadInput();

/// What a layer comes to in a build. Another job, layer or build: another hash.
uint64_t LayerHash(int64_t work, const std::string& build, int32_t layer);

/// The name of the G-code that these layers make up, in this order.
std::string GcodeOf(const std::vector<uint64_t>& layers);

/// The same by the work alone: what a job's result has to be.
std::string ExpectedGcode(const Work& work, const std::string& build);

/// The name of its mesh.
std::string MeshOf(const Work& work);

/// Equal for equal work in the same build.
std::string ActionOf(const Work& work, const std::string& build);

}  // namespace slicefarm::coordinator::sim
