#include "services/motion/algo/firmware/firmware.h"

#include "services/motion/algo/firmware/grbl.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion {

void Firmware::WriteMix(std::span<const double> shares, GcodeText& out) const {
  for (size_t i = 0; i < shares.size(); ++i) {
    out << "M163 S";
    out.Integer(static_cast<int64_t>(i)) << " P";
    out.Real(shares[i], 3) << '\n';
  }
  out << "M164 S0\n";
}

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
  if (name == "grbl") return &Grbl();
  return nullptr;
}

}  // namespace slicefarm::motion
