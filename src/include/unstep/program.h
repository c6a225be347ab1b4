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
  /// Text that says the motion mode, even if it is the one in force.
  bool names_mode = false;
  bool ends_program = false;  ///< M2, M30 or the closing %
  /// Motion mode after the item, in the source; text: no mode is in force.
  std::optional<Kind> mode;
  std::uint16_t known = 0;   ///< axes whose program position is known after it
  std::uint16_t words = 0;   ///< motions: the axes named on the line
  std::uint32_t turns = 1;   ///< arcs: the last turn ends at `end`
  std::uint32_t line = 0;    ///< of the source, from 1; 0: none
  std::uint32_t modes = 0;   ///< index of Program::modes, after the item
  std::uint32_t others = 0;  ///< index of Program::others, after the item
  std::array<std::int64_t, 3> end{};     ///< program position x, y, z after it
  std::array<std::int64_t, 2> centre{};  ///< arcs: program position, by plane
  std::int64_t radius = 0;               ///< arcs given by R: as given; else 0
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
  /// Lines carried out, where the program has loops or subroutines.
  std::uint64_t max_executed_lines = 10'000'000;
};

struct GcodeReadOptions {
  /// Refuses, by its line, whatever would be kept because it is not
  /// understood.
  bool strict = false;
  /// Lines that begin with "/": kept as they are, carried out, or left out.
  enum class BlockDelete : std::uint8_t { keep, execute, skip };
  BlockDelete block_delete = BlockDelete::keep;
  /// Subroutines, loops and branches (O words of LinuxCNC): the program is
  /// what they make of it, or they and all that follows is kept as it stands.
  /// The same where what they do depends on more than the program says.
  bool execute_flow = true;
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

/// Which arcs a control takes. A control compares the radius at the start of
/// an arc with that at its end, which rounding makes differ.
struct ArcRules {
  double radius_mm = 0.001;       ///< they may differ by this,
  double radius_relative = 8e-4;  ///< or by this share
  double min_radius_mm = 0.01;
  double max_radius_mm = 10'000;
  double max_sweep_degrees = 360;  ///< of one arc; below 360: no full circles
  bool quadrants = false;          ///< no arc passes an extreme of its circle
  /// Arcs are written by R: checked with the centre that follows from it, and
  /// not of 170 to 190 degrees or more than 340, where the centre would depend
  /// on the last digits of the ends.
  bool by_radius = false;
};

struct CompactOptions {
  /// The Frechet distance between the program's path and the shorter one is
  /// never more, in x, y and z, with the rounding of the output.
  double tolerance_mm = 0.005;
  bool arcs = true;
  ArcRules rules{};
  /// Decimals of positions, in the program's own unit. Below 0: as many as
  /// the tolerance needs, never more than the program has.
  int decimals = -1;
  /// Extrusion per length may vary by this share where moves are merged.
  double extrusion_tolerance = 0.02;
};

/// What compact() did.
struct CompactReport {
  std::uint64_t lines_before = 0;  ///< motions that are no rapids
  std::uint64_t lines_after = 0;   ///< of them arcs:
  std::uint64_t arcs_after = 0;
};

/// Merges lines that follow each other into longer lines and into arcs of the
/// plane in force. Feed, spindle and modes are the same over what is merged,
/// and nothing stands between. Arcs that follow each other on one circle become
/// one. Rapids, other arcs, text and motions from or to a
/// position that is not known stay. Where text depends on the exact position,
/// it is exact.
/// out_of_range for the options.
Result<Program> compact(const Program& program, const CompactOptions& options,
                        CompactReport* report = nullptr);

/// Arcs in pieces that the rules allow; the others stay.
Result<Program> split_arcs(const Program& program, const ArcRules& rules);

/// Controls, and what they are used for.
enum class GcodeProfile : std::uint8_t {
  linuxcnc,  ///< M2 at the end
  grbl,      ///< the same
  marlin,    ///< a G word on every line, comments after ";"
  laser,     ///< grbl; the beam instead of a tool
  plotter    ///< grbl; a pen instead of a tool
};

struct GcodeWriteOptions {
  enum class ArcForm : std::uint8_t {
    as_read,  ///< R where the program had R, else I, J and K
    centre,   ///< I, J and K
    radius    ///< R; arcs of 170 to 190 degrees or more than 340 in two
  };
  GcodeProfile profile = GcodeProfile::linuxcnc;
  ArcForm arcs = ArcForm::as_read;
  bool blanks = true;          ///< between words
  std::optional<bool> inches;  ///< motions in this unit; else as the program
  /// Decimals of positions. Below 0: all that they have; where the unit is
  /// converted, 4 of a mm and 5 of an inch.
  int decimals = -1;
  /// M2 where the program has no end; a closing % alone becomes M2.
  bool add_end = true;
  std::string header;  ///< lines before all others
  std::string footer;  ///< lines after all others, before the program's end
};

/// How far a pen or tool goes between what it draws, grid units.
struct TravelReport {
  double before = 0;
  double after = 0;
};

/// Puts the paths of a drawing, and its chains, into an order of short ways
/// between them, turning open ones where that helps; what is drawn stays the
/// same. The way begins at (0, 0), or with y up and a canvas at its upper left
/// corner. The nearest end first, then parts of the order are turned around and
/// single ones moved while that helps (2-opt and or-opt). It is never longer
/// than before. Work is bounded by the number of shapes, not by the clock: the
/// same drawing has the same order everywhere.
TravelReport order_travel(Drawing& drawing);

/// The program as text: motions modal and with as few decimals as they need,
/// text as it stands. The same program gives the same bytes. Where text is
/// carried out, position and modes are those that it had in the source.
/// invalid_argument if a profile cannot say what the program does.
Result<std::string> write_gcode(const Program& program,
                                const GcodeWriteOptions& options);

/// How a drawing becomes a program. Lengths in mm, feeds in mm per minute.
struct DrawProgramOptions {
  GcodeProfile profile = GcodeProfile::linuxcnc;
  double unit_x = 1;  ///< size of a grid unit of the drawing
  double unit_y = 1;
  double feed = 1000;        ///< along the paths
  double plunge_feed = 300;  ///< down to cut_z
  double travel_z = 5;       ///< where the tool goes between paths
  /// Of the tool in the paths. Below any number: 0 for plotter and marlin, -1
  /// for the others.
  double cut_z = std::numeric_limits<double>::lowest();
  double spindle = 0;   ///< linuxcnc, grbl: M3 S at the start, M5 at the end
  double power = 1000;  ///< laser: the S of M3 in the paths
  /// Lines instead of those that lower and lift the tool, or switch the laser.
  std::string tool_on;
  std::string tool_off;
  int decimals = 4;  ///< of positions, 0..7
  ArcRules rules{};
};

/// The paths and chains of a drawing as a program: a rapid to the start of
/// each, tool on, lines and arcs, tool off. X and Y are those of a drawing
/// with y up whose lower left corner of the canvas is (0, 0). Arcs that the
/// rules refuse, and those of units that are not square, become lines within
/// 0.002 mm of them. invalid_argument or out_of_range for drawing and options,
/// or lines of the options that are no G-code. `notes`, if not null, gets what
/// a program does not carry.
Result<Program> draw_program(const Drawing& drawing,
                             const DrawProgramOptions& options,
                             std::vector<std::string>* notes);

/// What the moves of a program draw in its x-y plane, y up, unbounded: paths of
/// lines and arcs between rapids, a grid unit is 1 mm. Moves with the
/// spindle word S0 draw nothing. `notes`, if not null, gets what a drawing does
/// not carry: z and other axes, feeds, rapids, text. out_of_range if it leaves
/// the coordinate range.
Result<Drawing> program_drawing(const Program& program,
                                std::vector<std::string>* notes);

}  // namespace unstep
