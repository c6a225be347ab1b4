#include <cstddef>
#include <string_view>

#include "fuzz/target.h"
#include "unstep/step_stream.h"

/// A stream of steps or a device profile (the first byte says which): what can
/// be read is written and read again, and its steps, if few, are reversed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1,
                               size - 1);
  StepReadOptions options;
  options.max_steps = 20'000;
  constexpr StepFormat kFormats[] = {StepFormat::binary, StepFormat::csv,
                                     StepFormat::vcd, StepFormat::raw};
  const Result<StepStream> stream =
      data[0] % 5 == 4 ? read_device_profile(bytes, options)
                       : read_steps(bytes, kFormats[data[0] % 5], options);
  if (!stream) {
    fuzz::require_sound(stream.error());
    return 0;
  }
  const Result<std::string> binary = write_steps(*stream, StepFormat::binary);
  fuzz::require(static_cast<bool>(binary), "steps can be written");
  const Result<StepStream> again =
      read_steps(*binary, StepFormat::binary, options);
  fuzz::require(again && *again == *stream, "steps come back");
  if (size > 600) return 0;
  const Result<Program> program = reverse_steps(*stream, {});
  if (!program) {
    fuzz::require_sound(program.error());
    return 0;
  }
  StepMakeOptions how;
  how.step = stream->head.step;
  how.axes = stream->head.axes;
  how.origin = stream->head.origin;
  const Result<StepStream> made = make_steps(*program, how);
  fuzz::require(static_cast<bool>(made), "the program makes steps");
  StepStream untimed = *stream;
  untimed.head.clock = 0;
  for (StepRun& run : untimed.runs) run.waits.clear();
  fuzz::require(*made == untimed, "the same steps");
  return 0;
}
