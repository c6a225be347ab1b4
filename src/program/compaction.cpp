#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "program/arc_merge.h"
#include "program/run_cover.h"
#include "program/run_finder.h"
#include "program/units.h"
#include "unstep/program.h"

/// Runs of lines that nothing separates become fewer lines and arcs.
/// docs/algorithms.md, "Compaction of programs".
namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

/// The tolerance is used but for this, in program units: more than rounding
/// in doubles can make of it, 0.4 nm.
constexpr double kMargin = 4;

/// Rounds to a multiple of the grid, halves away from 0.
std::int64_t on_grid(std::int64_t value, std::int64_t grid) {
  const std::int64_t half = grid / 2;
  return value < 0 ? -((-value + half) / grid * grid)
                   : (value + half) / grid * grid;
}

/// Program units of the last decimal; 1 where the unit has no such decimal.
std::int64_t grid_of(int decimals, bool inches) {
  std::int64_t grid = inches ? 254 : 10;
  for (int i = decimals; i < 6; ++i) grid *= 10;
  if (decimals > 6) grid = 1;
  return grid;
}

std::uint64_t cutting_motions(const Program& program) {
  return static_cast<std::uint64_t>(std::count_if(
      program.items.begin(), program.items.end(), [](const ProgramItem& item) {
        return item.is_motion() && item.kind != Kind::rapid;
      }));
}

bool has_arcs_in_a_row(const Program& program) {
  return std::adjacent_find(program.items.begin(), program.items.end(),
                            [](const ProgramItem& a, const ProgramItem& b) {
                              return a.is_arc() && a.kind == b.kind;
                            }) != program.items.end();
}

class Compaction {
 public:
  Compaction(const Program& in, const CompactOptions& options)
      : in_(in),
        options_(options),
        runs_(in, options.extrusion_tolerance),
        tolerance_(options.tolerance_mm * kPerMm - kMargin) {
    out_.text = in.text;
    out_.modes = in.modes;
    out_.others = in.others;
    out_.start = in.start;
    out_.notes = in.notes;
    out_.decimals = in.decimals;
    out_.items.reserve(in.items.size() / 4 + 16);
    written_ = {in.start.end[0], in.start.end[1], in.start.end[2]};
  }

  Result<Program> make(CompactReport& report) {
    find_exact();
    for (std::size_t i = 0; i < in_.items.size();) {
      const std::size_t end = runs_.run_end(i);
      if (end > i) {
        write_run(i, end);
        i = end;
      } else {
        write_single(i);
        ++i;
      }
    }
    report.lines_before = cutting_motions(in_);
    report.lines_after = cutting_motions(out_);
    for (const ProgramItem& item : out_.items) {
      report.arcs_after += item.is_arc();
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] const ProgramItem& before(std::size_t index) const {
    return index == 0 ? in_.start : in_.items[index - 1];
  }

  /// True if the position after the item must be the program's own: what
  /// follows builds on it.
  [[nodiscard]] bool needs_exact(std::size_t index) const {
    const ProgramItem& item = in_.items[index];
    return item.is_arc() || item.keep_text || exact_before_[index + 1];
  }

  /// For each item, whether it needs the exact position before it. Text that
  /// does nothing passes on what comes next.
  void find_exact() {
    exact_before_.assign(in_.items.size() + 1, false);
    for (std::size_t i = in_.items.size(); i-- > 0;) {
      const ProgramItem& item = in_.items[i];
      const ProgramItem& from = before(i);
      exact_before_[i] = item.keep_text || item.unknown_effect ||
                         item.is_arc() || item.modes != from.modes ||
                         item.known != from.known ||
                         (!item.is_motion() && exact_before_[i + 1]);
    }
  }

  [[nodiscard]] std::int64_t grid(const ProgramItem& item) const {
    const bool inches = in_.modes[item.modes].inches.value_or(false);
    int decimals = options_.decimals;
    if (decimals < 0) {
      decimals = 0;
      // The rounding of a corner is at most 0.87 of a decimal.
      while (decimals<in_.decimals&& static_cast<double>(
                          grid_of(decimals, inches)) *
                      0.87 * 8>
                 tolerance_) {
        ++decimals;
      }
    }
    return decimals >= in_.decimals ? 1 : grid_of(decimals, inches);
  }

  /// Where the output goes for item `index`: an axis that rests stays.
  [[nodiscard]] std::array<std::int64_t, 3> rounded(
      std::size_t index, const std::array<std::int64_t, 3>& at) const {
    const ProgramItem& item = in_.items[index];
    const ProgramItem& from = before(index);
    if (needs_exact(index)) return item.end;
    const std::int64_t step = grid(item);
    std::array<std::int64_t, 3> to = item.end;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to[axis] = item.end[axis] == from.end[axis] && item.known == from.known
                     ? at[axis]
                     : on_grid(item.end[axis], step);
    }
    return to;
  }

  void write_single(std::size_t index) {
    ProgramItem item = in_.items[index];
    if (item.is_motion() && !item.keep_text) {
      item.end = rounded(index, written_);
    } else if (!item.is_motion() && item.end == before(index).end) {
      item.end = written_;
    }
    written_ = item.end;
    out_.items.push_back(item);
  }

  /// Items begin ... end - 1.
  void write_run(std::size_t begin, std::size_t end) {
    const ProgramItem& first = in_.items[begin];
    const ProgramPlane plane =
        in_.modes[first.modes].plane.value_or(ProgramPlane::xy);
    const auto axes = plane_axes(plane);
    const std::int64_t step = grid(first);
    fill_run(begin, end, axes);
    CoverOptions cover;
    cover.tolerance = tolerance_;
    const bool arcs_known = in_.modes[first.modes].plane.has_value() &&
                            in_.modes[first.modes].absolute_centres.has_value();
    cover.arcs = options_.arcs && arcs_known;
    cover.arc.grid =
        static_cast<double>(centre_grid(step > 1 ? step : own_grid(first)));
    const double rounding = step > 1 ? static_cast<double>(step) : 0;
    const double square = tolerance_ * tolerance_ - 1.5 * rounding * rounding;
    cover.arc.tolerance = square > 0 ? std::sqrt(square) : 0;
    // The ends of quadrants are rounded to 0.1 um.
    if (options_.rules.quadrants) cover.arc.tolerance -= 1e-4 * kPerMm;
    cover.arc.rules = options_.rules;
    cover_run(run_, cover, pieces_);
    const std::size_t before_run = out_.items.size();
    for (const CoverPiece& piece : pieces_) {
      // One motion stays even where none moves: it sets mode and feed.
      const bool last = &piece == &pieces_.back();
      const bool needed = last && out_.items.size() == before_run;
      write_piece(begin, piece, axes, needed);
    }
  }

  /// Centres may need more decimals than a program of whole numbers has.
  [[nodiscard]] std::int64_t centre_grid(std::int64_t step) const {
    while (static_cast<double>(step) * 0.87 * 8 > tolerance_ &&
           step % 10 == 0) {
      step /= 10;
    }
    return step;
  }

  /// The grid of the program's own decimals.
  [[nodiscard]] std::int64_t own_grid(const ProgramItem& item) const {
    return grid_of(in_.decimals, in_.modes[item.modes].inches.value_or(false));
  }

  /// Vertex 0 is where the run begins.
  void fill_run(std::size_t begin, std::size_t end,
                const std::array<std::size_t, 3>& axes) {
    const std::array<std::int64_t, 3> origin = before(begin).end;
    const auto point = [&](const std::array<std::int64_t, 3>& p) {
      return RunPoint{static_cast<double>(p[axes[0]] - origin[axes[0]]),
                      static_cast<double>(p[axes[1]] - origin[axes[1]]),
                      static_cast<double>(p[axes[2]] - origin[axes[2]])};
    };
    run_.vertex.clear();
    run_.written.clear();
    run_.vertex.push_back({});
    run_.written.push_back(point(written_));
    run_ends_.clear();
    run_ends_.push_back(written_);
    for (std::size_t i = begin; i < end; ++i) {
      run_ends_.push_back(rounded(i, run_ends_.back()));
      run_.vertex.push_back(point(in_.items[i].end));
      run_.written.push_back(point(run_ends_.back()));
    }
    run_origin_ = origin;
  }

  void write_piece(std::size_t begin, const CoverPiece& piece,
                   const std::array<std::size_t, 3>& axes, bool needed) {
    ProgramItem item = in_.items[begin + piece.last - 1];
    const bool moves =
        run_ends_[piece.last] != written_ ||
        runs_.extruded(out_.items.empty() ? in_.start : out_.items.back(),
                       item) != 0;
    item.end = run_ends_[piece.last];
    if (piece.is_arc) {
      item.kind = piece.arc.clockwise ? Kind::clockwise : Kind::counter;
      item.radius = std::llround(piece.arc.radius);
      item.centre = {run_origin_[axes[0]] + std::llround(piece.arc.x),
                     run_origin_[axes[1]] + std::llround(piece.arc.y)};
    } else if (!moves && !needed) {
      return;
    }
    written_ = item.end;
    out_.items.push_back(item);
  }

  const Program& in_;
  CompactOptions options_;
  RunFinder runs_;
  double tolerance_;
  Program out_;
  std::array<std::int64_t, 3> written_{};  ///< where the output is
  std::vector<bool> exact_before_;
  Polyline run_;
  std::vector<std::array<std::int64_t, 3>> run_ends_;
  std::array<std::int64_t, 3> run_origin_{};
  std::vector<CoverPiece> pieces_;
};

}  // namespace

Result<Program> compact(const Program& program, const CompactOptions& options,
                        CompactReport* report) {
  if (!(options.tolerance_mm >= 1e-5 && options.tolerance_mm <= 1e6)) {
    return Error{ErrorCode::out_of_range,
                 "the tolerance of a program is 0.00001 mm to 1 km"};
  }
  if (options.decimals >= 0) {
    // The rounding of a corner is at most 0.87 of a decimal.
    double rounding = 8.7;
    for (int i = 0; i < options.decimals; ++i) rounding /= 10;
    for (const ProgramModes& modes : program.modes) {
      const double unit = modes.inches == true ? 25.4 : 1;
      if (options.decimals < program.decimals &&
          rounding / 10 * unit > options.tolerance_mm / 4) {
        return Error{ErrorCode::out_of_range,
                     "too few decimals for the tolerance"};
      }
    }
  }
  try {
    CompactReport done;
    // Arcs keep their ends, so that what they use of the tolerance is theirs.
    std::optional<Program> merged;
    if (has_arcs_in_a_row(program)) {
      merged = program;
      merge_arcs(*merged, options.tolerance_mm * kPerMm - kMargin,
                 options.rules);
    }
    Result<Program> made =
        Compaction(merged ? *merged : program, options).make(done);
    if (merged) done.lines_before = cutting_motions(program);
    if (made && options.rules.quadrants) {
      made = split_arcs(*made, options.rules);
    }
    if (report != nullptr) *report = done;
    return made;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
