#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "google/protobuf/message.h"

namespace slicefarm::fuzz {

/// A box of 6 x 6 x 4 mm.
inline constexpr std::string_view kBox =
    "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 0 0 4\nv 6 0 4\nv 6 6 4\nv 0 6 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Settings of the job that prints the box.
inline constexpr std::pair<const char*, const char*> kSettings[] = {
    {"layer_height", "1"},         {"first_layer_height", "1"},
    {"nozzle_diameter", "2"},      {"perimeters", "1"},
    {"top_solid_layers", "1"},     {"bottom_solid_layers", "1"},
    {"fill_density", "20%"},       {"extrusion_width", "1.2"},
    {"start_gcode", "G28 ; home"}, {"layer_gcode", ";[layer_num]"}};

/// Folder with a folder of seeds for each fuzzer.
class Seeds {
 public:
  explicit Seeds(std::string folder) : folder_(std::move(folder)) {}

  void Write(const std::string& target, const std::string& name,
             const google::protobuf::Message& message) const {
    const std::filesystem::path path = std::filesystem::path(folder_) / target;
    std::filesystem::create_directories(path);
    std::ofstream(path / name, std::ios::binary) << message.SerializeAsString();
  }

 private:
  const std::string folder_;
};

/// Writes the calls of clients of a coordinator.
void WriteCoordinatorSeeds(const Seeds& seeds);

}  // namespace slicefarm::fuzz
