#include "services/motion/algo/firmware/firmware.h"

#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/bambu.h"
#include "services/motion/algo/firmware/grbl.h"
#include "services/motion/algo/firmware/jerk.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/prusa_buddy.h"
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

void Firmware::WritePressureAdvance(double value, GcodeText& out) const {
  out << "M900 K";
  out.Real(value, 5) << '\n';
}

void Firmware::WriteProgress(int64_t percent, int64_t left_min, int64_t /*layer*/,
                             GcodeText& out) const {
  out << "M73 P";
  out.Integer(percent) << " R";
  out.Integer(left_min) << '\n';
}

void Firmware::WriteSilentProgress(int64_t percent, int64_t left_min, GcodeText& out) const {
  out << "M73 Q";
  out.Integer(percent) << " S";
  out.Integer(left_min) << '\n';
}

void Firmware::WriteChecks(const MotionOptions& /*options*/, const PrintFacts& /*facts*/,
                           GcodeText& /*out*/) const {}

void Firmware::WriteHead(const PrintFacts& /*facts*/, GcodeText& /*out*/) const {}

const CommentWords& Firmware::comments() const {
  static constexpr CommentWords kPrusaSlicers;
  return kPrusaSlicers;
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
    case GcodeFlavor::kPrusaBuddy:
      return PrusaBuddy();
    case GcodeFlavor::kBambu:
      return Bambu();
  }
  return Marlin2();
}

const Firmware* FindFirmware(std::string_view name) {
  if (name == "klipper") return &Klipper();
  if (name == "marlin" || name == "marlin2") return &Marlin2();
  if (name == "rrf" || name == "reprapfirmware") return &RepRap();
  for (const Firmware* firmware : {&PrusaBuddy(), &Bambu(), &Grbl(), &JerkLimited()})
    if (name == firmware->name()) return firmware;
  return nullptr;
}

}  // namespace slicefarm::motion
