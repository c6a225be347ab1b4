#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "formats/gcode_reader_block.h"
#include "unstep/program.h"

/// The machine as far as a program lets it be known.
namespace unstep {

/// LinuxCNC: six of G54 ... G59, three of G59.1 ... G59.3.
inline constexpr int kCoordinateSystems = 9;

struct GcodeState {
  ProgramModes modes;
  std::optional<ProgramItem::Kind> mode;
  /// Program position; where not known, relative to wherever it was, from 0.
  ProgramPosition position{};
  std::uint16_t known = 0;
  double feed = 0;
  double spindle = -1;
  int system = -1;  ///< 0: G54; -1: not known
  std::array<ProgramPosition, kCoordinateSystems> systems{};
  std::array<std::uint16_t, kCoordinateSystems> systems_known{};
  ProgramPosition shift{};  ///< G92
  std::uint16_t shift_known = 0;

  /// After a word that is not understood.
  void forget();
  void forget_position(std::uint16_t axes) {
    known = static_cast<std::uint16_t>(known & ~axes);
  }
  void select_system(int index);
  /// G10 L2: the offset of a system.
  void set_system(int index, std::uint16_t axes, const ProgramPosition& to);
  /// G92: the program position becomes `to`.
  void set_position(std::uint16_t axes, const ProgramPosition& to);
  /// G92.1 and G92.2.
  void clear_shift();
  /// Offsets into modes, after one of them changed; the machine stays.
  void update_offset();
};

}  // namespace unstep
