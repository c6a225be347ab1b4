#include <algorithm>
#include <array>

#include "unstep/interpolate.h"

namespace unstep {
namespace {

constexpr std::array<MethodInfo, 11> kMethods{{
    {Method::device, "device", "A1",
     "self-counting evaluation function of SU 1089551, 4-connected", true,
     false, false},
    {Method::gate_level, "gate-level", "A3",
     "the same device as a clocked net of its numbered elements", true, false,
     false},
    {Method::rate_multiplier, "rate-multiplier", "B",
     "binary rate multiplier per axis, frames of 2^n pulses", true, false,
     false},
    {Method::evaluation, "evaluation", "C",
     "classic evaluation function F = xk y - yk x, 4-connected", true, false,
     false},
    {Method::evaluation8, "evaluation8", "C",
     "evaluation function with diagonal steps, 8-connected", true, false,
     false},
    {Method::circular, "circular", "D1",
     "circular evaluation function, single or combined steps", false, true,
     false},
    {Method::increments, "increments", "D2",
     "increments per period by an evaluation function with shrinking step",
     true, true, true},
    {Method::cordic, "cordic", "D3",
     "digit by digit, Volder's form, unit steps", true, true, false},
    {Method::meggitt, "meggitt", "D3",
     "digit by digit, Meggitt's form, unit steps", true, true, false},
    {Method::rom, "rom", "D4",
     "table of sin and cos with correction between nodes, unit steps", true,
     true, false},
    {Method::general, "general", "D5",
     "increments per period from any sine source", true, true, true},
}};

}  // namespace

std::span<const MethodInfo> methods() { return kMethods; }

const MethodInfo& method_info(Method method) {
  return kMethods[static_cast<std::size_t>(method)];
}

std::optional<Method> find_method(std::string_view name) {
  const auto* found = std::find_if(
      kMethods.begin(), kMethods.end(),
      [name](const MethodInfo& info) { return info.name == name; });
  if (found == kMethods.end()) return std::nullopt;
  return found->method;
}

}  // namespace unstep
