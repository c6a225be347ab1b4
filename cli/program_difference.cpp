#include "cli/program_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "cli/message.h"
#include "unstep/deviation.h"
#include "unstep/program.h"

namespace unstep::cli {

std::optional<std::string> first_motion(const Page& a, const Page& b) {
  const Result<Program> first = read_gcode(a.program, {});
  if (!first) return "the first is no program: " + first.error().message;
  const Result<Program> second = read_gcode(b.program, {});
  if (!second) return "the second is no program: " + second.error().message;
  const auto in_a = program_moves(*first, true);
  const auto in_b = program_moves(*second, true);
  if (!in_a || !in_b) return "the motions cannot be told";
  // Inches have decimals that mm have not.
  const auto near = [](std::int64_t x, std::int64_t y) {
    return std::abs(x - y) <= 254;
  };
  const std::size_t count = std::min(in_a->size(), in_b->size());
  for (std::size_t i = 0; i < count; ++i) {
    const ProgramMove& x = (*in_a)[i];
    const ProgramMove& y = (*in_b)[i];
    const bool arc = x.kind == ProgramItem::Kind::clockwise ||
                     x.kind == ProgramItem::Kind::counter;
    if (x.kind != y.kind || x.plane != y.plane ||
        !std::equal(x.end.begin(), x.end.end(), y.end.begin(), near) ||
        (arc && !std::equal(x.centre.begin(), x.centre.end(), y.centre.begin(),
                            near)) ||
        std::abs(x.feed - y.feed) > 1e-3 || x.spindle != y.spindle) {
      return fmt::format(
          "motion {}, line {} of the first, differs from line "
          "{} of the second",
          i + 1, x.line, y.line);
    }
  }
  if (in_a->size() == in_b->size()) return std::nullopt;
  return fmt::format("{} in the first and {} in the second",
                     counted(in_a->size(), "motion"), grouped(in_b->size()));
}

Result<ProgramVerdict> judge_program(const Page& original, const Page& shorter,
                                     double bound_mm) {
  const Result<Program> first = read_gcode(original.program, {});
  if (!first) return first.error();
  const Result<Program> second = read_gcode(shorter.program, {});
  if (!second) return second.error();
  // Somewhat more than the bound, so that the message says how much more.
  const double limit = std::clamp(16 * bound_mm, 1e-4, 1000.0);
  const Result<ProgramDeviation> found =
      measure_program_deviation(*first, *second, limit);
  if (!found && found.error().code == ErrorCode::corrupt) {
    return ProgramVerdict{false, found.error().message};
  }
  if (!found) return found.error();
  const bool within = found->least <= bound_mm;
  const double distance =
      within ? std::min(found->distance, bound_mm) : found->distance;
  std::string text =
      fmt::format("deviates by {} {:.4g} mm, of {:.6g} mm allowed",
                  found->least > limit ? "more than" : "up to",
                  found->least > limit ? limit : distance, bound_mm);
  if (found->line > 0) {
    text += fmt::format(", at ({:.6g}, {:.6g}, {:.6g}), line {}", found->at[0],
                        found->at[1], found->at[2], found->line);
  }
  return ProgramVerdict{within, std::move(text)};
}

}  // namespace unstep::cli
