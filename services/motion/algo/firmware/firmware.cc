#include "services/motion/algo/firmware/firmware.h"

#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion {

bool Firmware::RefusesSection(double /*section_mm2*/, double /*nozzle_mm*/) const { return false; }

const Firmware& FirmwareOf(GcodeFlavor flavor) {
  switch (flavor) {
    case GcodeFlavor::kMarlin2:
      return Marlin2();
    case GcodeFlavor::kMarlinLegacy:
      return MarlinLegacy();
    case GcodeFlavor::kKlipper:
      return Klipper();
    case GcodeFlavor::kRepRapFirmware:
      return RepRap();
  }
  return Marlin2();
}

const Firmware* FindFirmware(std::string_view name) {
  if (name == "klipper") return &Klipper();
  if (name == "marlin" || name == "marlin2") return &Marlin2();
  if (name == "rrf" || name == "reprapfirmware") return &RepRap();
  return nullptr;
}

}  // namespace slicefarm::motion
