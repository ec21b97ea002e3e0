#include "services/motion/algo/firmware/numbered_objects.h"

namespace slicefarm::motion {

std::string NumberedObjects::LabelOf(std::string_view name, size_t /*index*/) const {
  return std::string(name);
}

void NumberedObjects::DefineCopies(std::span<const CopySummary> /*copies*/,
                                   std::span<const std::string> labels, GcodeText& out) const {
  out << "M486 T";
  out.Integer(static_cast<int64_t>(labels.size())) << '\n';
  for (size_t i = 0; i < labels.size(); ++i) {
    out << "M486 S";
    out.Integer(static_cast<int64_t>(i)) << "\nM486 A" << labels[i] << "\nM486 S-1\n";
  }
}

void NumberedObjects::BeginCopy(std::string_view /*label*/, size_t index, GcodeText& out) const {
  out << "M486 S";
  out.Integer(static_cast<int64_t>(index)) << '\n';
}

void NumberedObjects::EndCopy(std::string_view /*label*/, size_t /*index*/, GcodeText& out) const {
  out << "M486 S-1\n";
}

}  // namespace slicefarm::motion
