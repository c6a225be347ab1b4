#include "fuzz/target.h"
#include "unstep/formats.h"

/// Any bytes as a recording of encoders of every kind: an error of one line, or
/// one chain within the range of coordinates. The first byte chooses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  if (size == 0) return 0;
  PulseReadOptions options;
  options.limits = fuzz::limits();
  options.counts = 1 << (data[0] >> 3) % 3;
  if ((data[0] & 64U) != 0) options.channels = {"1", "a"};
  if ((data[0] & 128U) != 0) options.high = 0.5;
  const auto format = static_cast<PulseFormat>(data[0] % 5);
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  (void)recognise_pulses(bytes);
  const Result<VectorPage> page = read_pulses(bytes, format, options);
  if (!page) {
    fuzz::require_sound(page.error());
    return 0;
  }
  fuzz::require(page->drawing.chains.size() == 1, "one chain");
  const Chain& chain = page->drawing.chains[0];
  fuzz::require(chain.steps.size() <= options.limits.max_steps, "the limit");
  for (const Step step : chain.steps) {
    fuzz::require(step < 8, "steps are Freeman codes");
    fuzz::require(chain.connectivity == Connectivity::eight || step % 2 == 0,
                  "steps fit the connectivity");
  }
  return 0;
}
