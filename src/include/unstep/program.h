#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/grid.h"
#include "unstep/result.h"

/// Programs of numerically controlled machines: read, shortened, written.
///
///     Result<Program> program = read_gcode(text, {});
///     Result<Program> shorter = compact(*program, {.tolerance_mm = 0.005});
///     Result<std::string> out = write_gcode(*shorter, {});
///
/// A program is a list of items in the order of the source: motions that are
/// understood, and text that is written back as it stands. docs/cnc.md says
/// what is understood. Where the state of the machine is not known (after a
/// word that is not understood), nothing is assumed: the lines stay as they
/// are.
namespace unstep {

/// Lengths are in 1e-7 mm (0.1 nm; 254 of them are 1e-6 inch), angles in 1e-7
/// degree.
inline constexpr std::int64_t kProgramUnitsPerMm = 10'000'000;

/// Every position lies in [-kMaxProgramLength, kMaxProgramLength]: 100 km. It
/// is below 2^50, so that doubles hold positions and their sums exactly.
inline constexpr std::int64_t kMaxProgramLength = 1'000'000'000'000'000;

/// x, y, z, then a, b, c (angles), u, v, w and e (extrusion).
inline constexpr std::size_t kProgramAxes = 10;
inline constexpr std::string_view kProgramAxisLetters = "XYZABCUVWE";
inline constexpr std::uint16_t kAllProgramAxes = (1U << kProgramAxes) - 1;

using ProgramPosition = std::array<std::int64_t, kProgramAxes>;

/// The plane of arcs, by its axes: first and second turn counter-clockwise
/// seen from the positive third.
enum class ProgramPlane : std::uint8_t { xy, zx, yz };

/// Index of the plane's axes in a position: first, second, third.
[[nodiscard]] constexpr std::array<std::size_t, 3> plane_axes(
    ProgramPlane plane) {
  switch (plane) {
    case ProgramPlane::zx: return {2, 0, 1};
    case ProgramPlane::yz: return {1, 2, 0};
    default: return {0, 1, 2};
  }
}

/// What is in force while an item is carried out. Everything that may be
/// unknown is: after a word that is not understood nothing is known until the
/// program says it again.
struct ProgramModes {
  std::optional<bool> inches;            ///< G20, else G21
  std::optional<bool> incremental;       ///< G91, else G90
  std::optional<bool> absolute_centres;  ///< G90.1, else G91.1
  std::optional<bool> incremental_e;     ///< M83 or G91, else M82 or G90
  std::optional<ProgramPlane> plane;     ///< G17, G18, G19
  std::optional<bool> per_minute;        ///< G94, else G93 or G95
  std::optional<bool> compensated;       ///< G41, G42, else G40
  /// Program position + offset = machine position: G54 ... G59.3 and G92.
  ProgramPosition offset{};
  /// Which offsets the program itself has said. The others live in the
  /// control and count as 0.
  std::uint16_t offset_known = 0;
  friend bool operator==(const ProgramModes&, const ProgramModes&) = default;
};

/// One thing the program does.
struct ProgramItem {
  enum class Kind : std::uint8_t { text, rapid, line, clockwise, counter };

  Kind kind = Kind::text;
  /// A motion that is written as its text: other words stand on its line.
  bool keep_text = false;
  /// Text whose effect on position or modes is not known.
  bool unknown_effect = false;
  /// Motion mode after the item; text: no mode is in force.
  std::optional<Kind> mode;
  std::uint16_t known = 0;   ///< axes whose program position is known after it
  std::uint16_t words = 0;   ///< motions: the axes named on the line
  std::uint32_t turns = 1;   ///< arcs: the last turn ends at `end`
  std::uint32_t line = 0;    ///< of the source, from 1; 0: none
  std::uint32_t modes = 0;   ///< index of Program::modes, after the item
  std::uint32_t others = 0;  ///< index of Program::others, after the item
  std::array<std::int64_t, 3> end{};     ///< program position x, y, z after it
  std::array<std::int64_t, 2> centre{};  ///< arcs: program position, by plane
  double feed = 0;      ///< mm (or degrees) per minute after it; 0: not known
  double spindle = -1;  ///< S word in force after it; below 0: not known
  std::uint64_t text_begin = 0;  ///< text or keep_text: in Program::text
  std::uint32_t text_size = 0;

  [[nodiscard]] bool is_motion() const { return kind != Kind::text; }
  [[nodiscard]] bool is_arc() const {
    return kind == Kind::clockwise || kind == Kind::counter;
  }
};

/// a, b, c, u, v, w, e.
using ProgramOtherAxes = std::array<std::int64_t, kProgramAxes - 3>;

struct Program {
  std::string text;  ///< what the items' texts are pieces of
  std::vector<ProgramItem> items;
  std::vector<ProgramModes> modes{ProgramModes{}};
  std::vector<ProgramOtherAxes> others{ProgramOtherAxes{}};
  /// What is in force, and known, before the first item.
  ProgramItem start;
  /// Decimals of the positions in the source: at most of any motion.
  int decimals = 0;
  /// One line each: what is kept as it stands, and why.
  std::vector<std::string> notes;

  [[nodiscard]] std::string_view text_of(const ProgramItem& item) const {
    return std::string_view(text).substr(item.text_begin, item.text_size);
  }
  /// Program position after the item.
  [[nodiscard]] ProgramPosition position(const ProgramItem& item) const;
};

/// A motion of the machine: machine coordinates, axes never set count as 0.
struct ProgramMove {
  ProgramItem::Kind kind = ProgramItem::Kind::line;
  ProgramPlane plane = ProgramPlane::xy;
  std::uint32_t turns = 1;
  std::uint32_t line = 0;
  ProgramPosition start{};
  ProgramPosition end{};
  std::array<std::int64_t, 2> centre{};
  double feed = 0;
  double spindle = -1;
};

/// The motions one after the other. unsupported, with its line, if the program
/// has text whose effect is not known, unless `skip_unknown`: then motions
/// go on where the last one ended.
Result<std::vector<ProgramMove>> program_moves(const Program& program,
                                               bool skip_unknown = false);

struct ProgramLimits {
  std::uint64_t max_bytes = std::uint64_t{1} << 31;
  std::uint64_t max_line_bytes = 1U << 16;
  std::uint64_t max_memory = std::uint64_t{4} << 30;  ///< of the Program
};

struct GcodeReadOptions {
  /// Refuses, by its line, whatever would be kept because it is not
  /// understood.
  bool strict = false;
  /// Lines that begin with "/": kept as they are, carried out, or left out.
  enum class BlockDelete : std::uint8_t { keep, execute, skip };
  BlockDelete block_delete = BlockDelete::keep;
  /// What is in force at the start, where the program does not say.
  bool inches = false;
  /// An arc is refused if its radius differs between start and end by more
  /// than both figures, or by more than a hundred times the first.
  double arc_tolerance_mm = 0.005;
  double arc_tolerance_relative = 0.001;
  ProgramLimits limits;
};

/// Reads RS274/NGC as LinuxCNC, GRBL and Marlin write it. Errors are corrupt,
/// out_of_range, limit_exceeded or (strict only) unsupported, and begin with
/// "line N: ".
Result<Program> read_gcode(std::string_view text,
                           const GcodeReadOptions& options);

}  // namespace unstep
