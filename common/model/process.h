#pragma once

#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace slicefarm {

/// Manufacturing process of a job. The process determines the stages through which the job passes.
enum class Process : uint8_t {
  kFdm,
  kLaser,
  kMill,
  kEngrave,
};

/// Name and description of a process.
struct ProcessInfo {
  Process process;
  std::string_view name;  ///< name in jobs, workers and command lines
  std::string_view doc;
};

/// Table of all processes, in the order of Process.
inline constexpr ProcessInfo kProcesses[] = {
    {Process::kFdm, "fdm", "Filament is extruded in layers; the result is G-code"},
    {Process::kLaser, "laser", "A laser scans the area of each layer, in powder or resin"},
    {Process::kMill, "mill", "A cutter mills a part out of its stock, with three axes"},
    {Process::kEngrave, "engrave", "A texture is engraved into a curved surface or built up on it"},
};

/// Process of a job without an explicit process.
inline constexpr Process kDefaultProcess = Process::kFdm;

inline constexpr int kProcessCount = static_cast<int>(std::size(kProcesses));

/// Returns the name of a process, such as "fdm".
constexpr std::string_view ProcessName(Process process) {
  return kProcesses[static_cast<size_t>(process)].name;
}

/// Set of processes, such as the processes that a worker can run.
class ProcessSet {
 public:
  constexpr ProcessSet() = default;
  constexpr ProcessSet(std::initializer_list<Process> processes) {
    for (const Process process : processes) Add(process);
  }

  static constexpr ProcessSet All() {
    ProcessSet all;
    for (const ProcessInfo& info : kProcesses) all.Add(info.process);
    return all;
  }

  constexpr void Add(Process process) { bits_ |= Bit(process); }
  constexpr bool Has(Process process) const { return (bits_ & Bit(process)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

  friend constexpr bool operator==(ProcessSet, ProcessSet) = default;

 private:
  static constexpr uint32_t Bit(Process process) { return 1U << static_cast<uint32_t>(process); }

  uint32_t bits_ = 0;
};

}  // namespace slicefarm
