#pragma once

#include <cstddef>
#include <cstdint>

#include "unstep/program.h"

/// The units and the axes of programs, for arithmetic.
namespace unstep {

/// Program units of a millimetre.
inline constexpr double kPerMm = static_cast<double>(kProgramUnitsPerMm);

inline constexpr std::size_t kAxisE = 9;

/// A bit for each axis whose coordinate is an angle: a, b and c.
inline constexpr std::uint16_t kAngles = 7U << 3;

}  // namespace unstep
