#include "machine/carriage.h"

#include <cmath>

#include "machine/motor_control.h"

namespace unstep::machine {

Plant Plant::noisier(double factor) const {
  Plant plant = *this;
  plant.force_noise_n *= factor;
  plant.fringe_noise *= factor;
  plant.head_noise_um *= factor;
  return plant;
}

std::uint64_t Noise::bits() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27) * 0x94d049bb133111ebU;
  return z ^ z >> 31;
}

double Noise::next() {
  std::int32_t sum = 0;
  for (int word = 0; word < 2; ++word) {
    const std::uint64_t b = bits();
    sum += static_cast<std::int32_t>((b & 0xffff) + (b >> 16 & 0xffff) +
                                     (b >> 32 & 0xffff) + (b >> 48));
  }
  // Eight uniforms of 0..65535: mean 4 * 65535, variance 8 * 65536^2 / 12.
  constexpr double kScale = 1 / (65536 * 0.81649658092772603);
  return (sum - 4 * 65535) * kScale;
}

void Carriage::tick(double duty, Noise& noise) {
  constexpr double kUm = 1e6;
  double force = duty * plant_.force_n + plant_.force_noise_n * noise.next() -
                 plant_.drag * speed_um_ / kUm;
  // Dry friction takes speed away, at most all of it.
  const double free = speed_um_ + force / plant_.mass_kg * kTickSeconds * kUm;
  const double stopping =
      plant_.dry_friction_n / plant_.mass_kg * kTickSeconds * kUm;
  speed_um_ =
      std::abs(free) <= stopping ? 0 : free - std::copysign(stopping, free);
  position_um_ += speed_um_ * kTickSeconds;
}

}  // namespace unstep::machine
