#pragma once

#include <cstdint>

/// The laser modulator of "Zenit".
namespace unstep::machine {

/// Pulse mode: whenever the carriage has moved DR2 pulses, either way, a flash
/// of DR1 us begins and the counter CR starts again. Level mode: the voltage
/// in DR1 is held.
class LaserModulator {
 public:
  enum class Mode : std::uint8_t { pulse, level };
  static constexpr int kLevelBits = 10;  ///< 1024 mV, 1 mV a step
  static constexpr std::int32_t kMaxWidthUs = 1000;
  static constexpr std::int64_t kMinPeriodNs = 2'000'000;  ///< 500 Hz

  void set_mode(Mode mode) { mode_ = mode; }
  void switch_on(bool on) { on_ = on; }
  void reset_way() { way_ = 0; }
  /// Width in us or level in mV; the low 10 bits. More than 1000 us is 1000.
  void load_dr1(std::uint32_t value);
  /// Pulses from flash to flash, 24 bits; 0 flashes never.
  void load_dr2(std::uint32_t pulses) { dr2_ = pulses & 0xffffff; }

  /// The carriage moved `pulses`, less than DR2. The pulses after which a flash
  /// begins, with the sign of the way, if one does; otherwise 0. A flash sooner
  /// than 2 ms after the last is refused (and counted).
  std::int64_t move(std::int64_t pulses, std::int64_t now_ns);

  [[nodiscard]] std::int32_t width_us() const;
  /// 0..1023 mV in level mode while on; 0 otherwise.
  [[nodiscard]] std::int32_t level_mv() const;
  [[nodiscard]] std::uint64_t flashes() const { return flashes_; }
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  Mode mode_ = Mode::level;
  bool on_ = false;
  std::uint32_t dr1_ = 0;
  std::uint32_t dr2_ = 0;
  std::int64_t way_ = 0;
  std::int64_t last_ns_ = -kMinPeriodNs;
  std::uint64_t flashes_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace unstep::machine
