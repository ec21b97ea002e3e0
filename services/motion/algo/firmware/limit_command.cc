#include "services/motion/algo/firmware/limit_command.h"

namespace slicefarm::motion {
namespace {

constexpr char kAxes[] = {'X', 'Y', 'Z', 'E'};

}  // namespace

LimitCommand& LimitCommand::Set(std::string_view parameter, double value) {
  if (value <= 0) return *this;
  if (!begun_) out_ << name_;
  begun_ = true;
  out_ << ' ' << parameter;
  out_.Real(value, 3);
  return *this;
}

LimitCommand& LimitCommand::SetAxes(std::span<const double, 4> values, double factor) {
  for (size_t i = 0; i < values.size(); ++i) Set({&kAxes[i], 1}, values[i] * factor);
  return *this;
}

void ReadAxes(const GcodeLine& line, double unit, std::array<double, 4>& values) {
  for (size_t i = 0; i < values.size(); ++i)
    if (const auto value = line[kAxes[i]]) values[i] = *value * unit;
}

void ReadLimit(std::optional<double> given, double& value) {
  if (given && *given > 0) value = *given;
}

}  // namespace slicefarm::motion
