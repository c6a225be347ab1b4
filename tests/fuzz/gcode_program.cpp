#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

#include "fuzz/target.h"
#include "unstep/program.h"

namespace unstep {
namespace {

/// A program that is written can be read, and moves as before.
void require_same_motions(const Program& program,
                          const GcodeReadOptions& options) {
  const Result<std::string> text = write_gcode(program, {});
  fuzz::require(static_cast<bool>(text), "a program can be written");
  const Result<Program> again = read_gcode(*text, options);
  if (!again) {
    fuzz::require(again.error().code == ErrorCode::limit_exceeded,
                  again.error().message);
    return;
  }
  const auto before = program_moves(program, true);
  const auto after = program_moves(*again, true);
  fuzz::require(before && after, "motions can be told");
  fuzz::require(before->size() == after->size(), "motions are as many");
  for (std::size_t i = 0; i < before->size(); ++i) {
    const ProgramMove& a = (*before)[i];
    const ProgramMove& b = (*after)[i];
    fuzz::require(a.kind == b.kind, "motions are of one kind");
    for (std::size_t axis = 0; axis < kProgramAxes; ++axis) {
      fuzz::require(std::abs(a.end[axis] - b.end[axis]) <= 254,
                    "motions end where they did");
    }
  }
}

}  // namespace
}  // namespace unstep

/// Any text as a program: what can be read can be shortened, written and read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  GcodeReadOptions options;
  options.limits = {1U << 16, 1U << 12, 4U << 20, 10'000};
  const Result<Program> program = read_gcode(text, options);
  if (!program) {
    fuzz::require_sound(program.error());
    return 0;
  }
  options.limits = {1U << 20, 1U << 16, 64U << 20, 100'000};
  require_same_motions(*program, options);
  CompactOptions how;
  how.tolerance_mm = 0.01;
  const Result<Program> shorter = compact(*program, how);
  fuzz::require(static_cast<bool>(shorter), "a program can be shortened");
  fuzz::require(shorter->items.size() <= program->items.size(),
                "a shorter program is not longer");
  require_same_motions(*shorter, options);
  return 0;
}
