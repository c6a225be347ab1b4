// For rs274_test.py. Reads a program, shortens it if asked, prints the motions
// of what it has and writes the program it would write. What is kept as it
// stands is named on standard error.
//
//     program_tool IN [TOLERANCE_MM OUT PROFILE ARCS]

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "unstep/formats.h"
#include "unstep/program.h"

namespace {

using namespace unstep;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 3;
}

void print_moves(const std::vector<ProgramMove>& moves) {
  for (const ProgramMove& move : moves) {
    std::printf("%d %d %u", static_cast<int>(move.kind),
                static_cast<int>(move.plane), move.turns);
    for (std::size_t axis = 0; axis < 9; ++axis) {
      std::printf(" %.7f", static_cast<double>(move.end[axis]) / 1e7);
    }
    std::printf(" %.7f %.7f\n", static_cast<double>(move.centre[0]) / 1e7,
                static_cast<double>(move.centre[1]) / 1e7);
  }
}

GcodeWriteOptions options_of(const std::string& profile,
                             const std::string& arcs) {
  GcodeWriteOptions options;
  if (profile == "grbl") options.profile = GcodeProfile::grbl;
  if (profile == "inch") options.inches = true;
  if (profile == "mm") options.inches = false;
  using ArcForm = GcodeWriteOptions::ArcForm;
  if (arcs == "centre") options.arcs = ArcForm::centre;
  if (arcs == "radius") options.arcs = ArcForm::radius;
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 && count != 6) return 2;
  std::ifstream file(arguments[1], std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)),
                         std::istreambuf_iterator<char>());
  Result<Program> program = read_gcode(text, {});
  if (!program) return fail(program.error());
  if (count == 6) {
    const GcodeWriteOptions options = options_of(arguments[4], arguments[5]);
    CompactOptions how;
    how.tolerance_mm = std::atof(arguments[2]);
    if (how.tolerance_mm > 0) {
      program = compact(*program, how);
      if (!program) return fail(program.error());
    }
    const Result<std::string> out = write_gcode(*program, options);
    if (!out) return fail(out.error());
    std::ofstream(arguments[3], std::ios::binary) << *out;
  }
  const auto moves = program_moves(*program, true);
  if (!moves) return fail(moves.error());
  for (const std::string& note : program->notes) {
    std::fprintf(stderr, "%s\n", note.c_str());
  }
  print_moves(*moves);
  return 0;
}
