#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/formats.h"
#include "unstep/trace.h"

/// What the readers of encoder recordings share.
namespace unstep {

/// Bits of a sample: A and B of x, A and B of y.
enum PulseBit : unsigned { kXA = 1, kXB = 2, kYA = 4, kYB = 8 };

/// Samples of one or two encoders become the steps of a chain.
class PulseChain {
 public:
  PulseChain(const PulseReadOptions& options, std::size_t channels)
      : limits_(options.limits),
        x_(options.counts),
        y_(options.counts),
        counts_(options.counts),
        has_y_(channels == 4) {}

  /// All levels at one time. `known` has the bits that were ever seen; an
  /// encoder waits for both of its own. Was a transition illegal? Then
  /// note_illegal() is due. Errors do not name the place.
  Result<bool> sample(unsigned levels, unsigned known = 15);

  /// "sample 12", "12.5 us"
  void note_illegal(const std::string& when);

  /// A page with the chain, and what there is to tell.
  [[nodiscard]] VectorPage finish(std::string_view format);

  [[nodiscard]] std::uint64_t samples() const { return samples_; }

 private:
  Status step(int dx, int dy);

  DecodeLimits limits_;
  QuadratureDecoder x_;
  QuadratureDecoder y_;
  int counts_;
  bool has_y_;
  bool diagonal_ = false;
  std::uint64_t samples_ = 0;
  std::uint64_t illegal_ = 0;
  std::uint64_t x_counts_ = 0;
  std::uint64_t y_counts_ = 0;
  std::vector<std::string> first_illegal_;
  Point at_;
  std::vector<Step> steps_;
};

/// Which of the named channels are A and B of x (and of y): as
/// PulseReadOptions::channels says.
Result<std::vector<std::size_t>> choose_channels(
    const std::vector<std::string>& names,
    const std::vector<std::string>& wanted);

/// Time in seconds with the unit that fits: "12.5 us".
[[nodiscard]] std::string time_text(double seconds);

Result<VectorPage> read_pulse_csv(std::string_view text,
                                  const PulseReadOptions& options);
Result<VectorPage> read_pulse_vcd(std::string_view text,
                                  const PulseReadOptions& options);
Result<VectorPage> read_pulse_sigrok(std::span<const std::uint8_t> bytes,
                                     const PulseReadOptions& options);

/// True if the bytes are a zip archive with the parts of a sigrok session.
[[nodiscard]] bool is_sigrok(std::span<const std::uint8_t> bytes);

}  // namespace unstep
