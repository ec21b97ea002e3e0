#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/model/process.h"

namespace slicefarm::coordinator::sim {

/// Work of a simulated job: a number of layers, each with a hash as its result, and a fault.
struct Work {
  /// Faults of a work.
  enum class Fault {
    kNone,
    kBadInput,           ///< the slicing stage reports bad input
    kBadLayer,           ///< workers report a bad layer in the middle
    kPoisonLayer,        ///< no worker can make the layer in the middle
    kKillsCoordinators,  ///< coordinators that run it die
  };

  int64_t id = 0;  ///< equal for equal work
  int32_t layers = 1;
  int64_t layer_us = 1000;  ///< time per layer on a worker of slowness 1
  Fault fault = Fault::kNone;
  slicefarm::Process process = slicefarm::kDefaultProcess;

  /// Returns true if the layers [first, last) include the layer in the middle.
  bool InMiddle(int32_t first, int32_t last) const {
    return first <= layers / 2 && layers / 2 < last;
  }
};

/// Returns the error of a stage for bad input.
absl::Status BadInput();

/// Returns the hash of a layer in a build. Different works, layers or builds have different hashes.
uint64_t LayerHash(int64_t work, const std::string& build, int32_t layer);

/// Returns the name of the G-code with these layers in this order.
std::string GcodeOf(const std::vector<uint64_t>& layers);

/// Returns the name of the correct G-code of the work.
std::string ExpectedGcode(const Work& work, const std::string& build);

/// Returns the name of the work's mesh.
std::string MeshOf(const Work& work);

/// Returns the action digest of the work. Equal works in the same build have equal digests.
std::string ActionOf(const Work& work, const std::string& build);

}  // namespace slicefarm::coordinator::sim
