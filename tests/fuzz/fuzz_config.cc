#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "common/config/projects/ini.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

// Checks for each process: if settings resolve, the text of the result must resolve to the same
// settings.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace config = slicefarm::config;
  const auto given = config::ReadIni({reinterpret_cast<const char*>(data), size});
  if (!given.ok()) return 0;
  for (const slicefarm::ProcessInfo& info : slicefarm::kProcesses) {
    const auto resolved = config::Resolve(*given, info.process);
    if (!resolved.ok()) continue;
    const auto lines = config::ReadIni(resolved->effective_text);
    if (!lines.ok()) std::abort();
    const auto again = config::Resolve(*lines, info.process);
    if (!again.ok() || again->settings != resolved->settings) std::abort();
    if (again->effective_text != resolved->effective_text) std::abort();
  }
  return 0;
}
