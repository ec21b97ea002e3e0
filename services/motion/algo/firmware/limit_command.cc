#include "services/motion/algo/firmware/limit_command.h"

namespace slicefarm::motion {
namespace {

constexpr char kAxes[] = {'X', 'Y', 'Z', 'E'};

}  // namespace

LimitCommand& LimitCommand::Set(std::string_view parameter, double value) {
  return value > 0 ? SetEven0(parameter, value) : *this;
}

LimitCommand& LimitCommand::SetEven0(std::string_view parameter, double value) {
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

void ReadM204(const GcodeLine& line, MachineLimits& limits) {
  for (const char word : {'S', 'P'}) ReadLimit(line[word], limits.max_acceleration_extruding_mm_s2);
  for (const char word : {'S', 'T'}) ReadLimit(line[word], limits.max_acceleration_travel_mm_s2);
  ReadLimit(line['R'], limits.max_acceleration_retracting_mm_s2);
}

void WriteM204(double print_mm_s2, double travel_mm_s2, GcodeText& out) {
  LimitCommand("M204", out).Set("P", print_mm_s2).Set("T", travel_mm_s2);
}

void WriteM204(double all_mm_s2, GcodeText& out) { LimitCommand("M204", out).Set("S", all_mm_s2); }

void ReadLimit(std::optional<double> given, double& value) {
  if (given && *given > 0) value = *given;
}

}  // namespace slicefarm::motion
