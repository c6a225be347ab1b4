#pragma once

#include <cstdint>
#include <optional>

/// The reversible counter of "Zenit": where the carriage is.
namespace unstep::machine {

/// 24 bits: a sign and 23 of magnitude. It counts in direct code on either side
/// of the origin: away from 0 the magnitude grows whatever the sign; a pulse
/// backwards at 0 turns the sign. There is no negative 0.
class ReversibleCounter {
 public:
  static constexpr std::uint32_t kMaxMagnitude = (1U << 23) - 1;
  static constexpr double kMaxPulseHz = 5e6;
  static constexpr std::int64_t kReadPeriodNs = 100'000;  ///< 10 kHz

  void reset();
  /// `word` in direct code; a negative 0 becomes 0.
  void load(std::uint32_t word);

  /// A pulse at `now_ns`, up or down. A pulse sooner than 200 ns (5 MHz) after
  /// the last one is lost; false, and counted in lost().
  bool pulse(bool up, std::int64_t now_ns);

  /// `pulses` up (or down, if negative) that are known to keep the 5 MHz, all
  /// before `now_ns`.
  void add(std::int64_t pulses, std::int64_t now_ns);

  /// A read that waits for the end of a pulse under way, so never sees half a
  /// carry.
  struct Read {
    std::uint32_t word = 0;     ///< direct code
    std::int64_t ready_ns = 0;  ///< when X2 comes
  };
  /// Nothing, and no X2, within 100 us of the last answered read.
  std::optional<Read> read(std::int64_t now_ns);

  /// The number in direct code, and as a number.
  [[nodiscard]] std::uint32_t word() const;
  [[nodiscard]] std::int32_t value() const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// The magnitude passed 2^23 - 1 and began at 0 again, as the gates do. Kept
  /// until reset or load.
  [[nodiscard]] bool overflowed() const { return overflowed_; }

 private:
  void step(bool up);

  std::uint32_t magnitude_ = 0;
  bool negative_ = false;
  bool overflowed_ = false;
  std::uint64_t lost_ = 0;
  std::optional<std::int64_t> last_pulse_ns_;
  std::optional<std::int64_t> last_read_ns_;
};

}  // namespace unstep::machine
