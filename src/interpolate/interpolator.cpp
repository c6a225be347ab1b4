// The common interface: one variant of all the methods' states, kept inside
// the public value.

#include <cmath>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <variant>

#include "interpolate/arc_walk.h"
#include "interpolate/circular.h"
#include "interpolate/device_line.h"
#include "interpolate/evaluation.h"
#include "interpolate/general.h"
#include "interpolate/increments.h"
#include "interpolate/rate_multiplier.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

namespace ip = interpolation;

using State =
    std::variant<ip::DeviceLine<DeviceRegisters>, ip::DeviceLine<GateNet>,
                 ip::RateMultiplier, ip::Evaluation, ip::Evaluation8,
                 ip::Circular, ip::LineIncrements, ip::ArcIncrements,
                 ip::GeneralLine, ip::GeneralArc>;
static_assert(std::is_trivially_copyable_v<State>);

Error refuse(std::string what) {
  return {ErrorCode::out_of_range, std::move(what)};
}

Result<double> path_per_period(const InterpolatorOptions& options) {
  const double length = options.feed * options.period;
  const bool good = options.feed > 0 && options.period > 0 &&
                    length >= 1.0 / 1024 &&
                    length <= static_cast<double>(kMaxPeriodLength);
  if (!good)
    return refuse("feed " + std::to_string(options.feed) + " and period " +
                  std::to_string(options.period) +
                  " must be positive with a product in 2^-10 .. 2^30 units");
  return length;
}

Status check_first_step(std::int32_t h) {
  if (h == 0) return {};
  if (h < 0 || h > 1 << 20 || (h & (h - 1)) != 0)
    return refuse("first step " + std::to_string(h) +
                  " is not a power of two in 1 .. 2^20");
  return {};
}

// n for a path of `extent` units: 13 guard digits keep the error of the
// vector below 1/64 unit for any of the forms (digit_by_digit.h).
constexpr int kGuardDigits = 13;

Result<ip::Sine> make_sine(Method method, const InterpolatorOptions& options,
                           double extent) {
  int n = options.word_length;
  if (n == 0) n = word_length_circular(extent + 1, 1) + kGuardDigits;
  if (n < kMinWordLength) n = kMinWordLength;
  if (options.word_length != 0 && (options.word_length < kMinWordLength ||
                                   options.word_length > kMaxWordLength))
    return refuse("word length " + std::to_string(options.word_length) +
                  " is not in " + std::to_string(kMinWordLength) + " .. " +
                  std::to_string(kMaxWordLength));
  SineSource source = options.source;
  if (method == Method::cordic) source = SineSource::cordic;
  if (method == Method::meggitt) source = SineSource::meggitt;
  if (method == Method::rom) source = SineSource::rom;
  if (source != SineSource::rom)
    return ip::Sine(n, source == SineSource::meggitt);
  const int bits = options.rom_bits == 0 ? kMaxRomBits : options.rom_bits;
  if (bits < kMinRomBits || bits > kMaxRomBits)
    return refuse("table step 2^-" + std::to_string(bits) +
                  ": the exponent is not in " + std::to_string(kMinRomBits) +
                  " .. " + std::to_string(kMaxRomBits));
  return ip::Sine(n, ip::Rom(bits, options.rom_form, options.rom_correction));
}

Result<State> make_line(Method method, Segment segment,
                        const InterpolatorOptions& options) {
  switch (method) {
    case Method::device: return State(ip::DeviceLine<DeviceRegisters>(segment));
    case Method::gate_level: return State(ip::DeviceLine<GateNet>(segment));
    case Method::evaluation: return State(ip::Evaluation(segment));
    case Method::evaluation8: return State(ip::Evaluation8(segment));
    case Method::rate_multiplier: {
      const int need = ip::RateMultiplier::bits_for(segment);
      const int bits = options.rate_bits == 0 ? need : options.rate_bits;
      if (bits < 0 || bits > kMaxRateBits)
        return refuse("register width " + std::to_string(bits) +
                      " is not in 1 .. " + std::to_string(kMaxRateBits));
      if (bits < need)
        return refuse("segment (" + std::to_string(segment.dx) + ", " +
                      std::to_string(segment.dy) + ") needs registers of " +
                      std::to_string(need) + " bits, not " +
                      std::to_string(bits));
      return State(ip::RateMultiplier(segment, bits));
    }
    case Method::increments: {
      const Result<double> length = path_per_period(options);
      if (!length) return length.error();
      const Status step = check_first_step(options.first_step);
      if (!step) return step.error();
      return State(ip::LineIncrements(segment, *length, options.first_step));
    }
    case Method::cordic:
    case Method::meggitt:
    case Method::rom:
    case Method::general: {
      const bool unit = method != Method::general;
      const Result<double> length =
          unit ? Result<double>(ip::kUnitPath) : path_per_period(options);
      if (!length) return length.error();
      const Result<ip::Sine> sine =
          make_sine(method, options, std::hypot(segment.dx, segment.dy));
      if (!sine) return sine.error();
      return State(ip::GeneralLine(segment, *sine, *length, unit));
    }
    case Method::circular: break;
  }
  return Error{ErrorCode::unsupported,
               std::string(method_info(method).name) + " draws no lines"};
}

Result<State> make_arc(Method method, const Arc& arc,
                       const InterpolatorOptions& options) {
  if (!method_info(method).arcs)
    return Error{ErrorCode::unsupported,
                 std::string(method_info(method).name) + " draws no arcs"};
  const Result<ip::ArcGeometry> geometry = ip::check_arc(arc);
  if (!geometry) return geometry.error();
  const bool unit = method != Method::general && method != Method::increments;
  const Result<double> length = unit && method != Method::circular
                                    ? Result<double>(ip::kUnitPath)
                                    : path_per_period(options);
  if (!length) return length.error();
  if (method == Method::circular) {
    if (options.feed > static_cast<double>(kMaxPeriodLength))
      return refuse("feed " + std::to_string(options.feed) +
                    " is above 2^30 units per second");
    return State(ip::Circular(*geometry, options.feed, options.combined));
  }
  if (method == Method::increments) {
    const Status step = check_first_step(options.first_step);
    if (!step) return step.error();
    return State(ip::ArcIncrements(*geometry, *length, options.first_step));
  }
  const Result<ip::Sine> sine =
      make_sine(method, options,
                std::sqrt(static_cast<double>(geometry->radius_squared)));
  if (!sine) return sine.error();
  return State(ip::GeneralArc(*geometry, *sine, *length, unit));
}

}  // namespace

struct InterpolatorAccess {
  static_assert(sizeof(State) <= Interpolator::kStateBytes);
  static_assert(alignof(State) <= 16);

  static Interpolator make(const State& state) {
    Interpolator made;
    new (made.state_.data()) State(state);
    return made;
  }
  static State& state(Interpolator& of) {
    return *std::launder(reinterpret_cast<State*>(of.state_.data()));
  }
  static const State& state(const Interpolator& of) {
    return *std::launder(reinterpret_cast<const State*>(of.state_.data()));
  }
};

Result<Interpolator> Interpolator::line(Method method, Segment segment,
                                        const InterpolatorOptions& options) {
  const Result<State> state = make_line(method, segment, options);
  if (!state) return state.error();
  return InterpolatorAccess::make(*state);
}

Result<Interpolator> Interpolator::arc(Method method, const Arc& arc,
                                       const InterpolatorOptions& options) {
  const Result<State> state = make_arc(method, arc, options);
  if (!state) return state.error();
  return InterpolatorAccess::make(*state);
}

Tick Interpolator::next() {
  return std::visit([](auto& method) { return method.next(); },
                    InterpolatorAccess::state(*this));
}

std::size_t Interpolator::fill(std::span<Tick> out) {
  return std::visit(
      [out](auto& method) {
        std::size_t n = 0;
        while (n < out.size()) {
          out[n] = method.next();
          if (out[n].kind == Tick::Kind::done) break;
          ++n;
        }
        return n;
      },
      InterpolatorAccess::state(*this));
}

std::size_t Interpolator::registers(
    std::span<Register, kMaxRegisters> out) const {
  return std::visit([out](const auto& method) { return method.registers(out); },
                    InterpolatorAccess::state(*this));
}

}  // namespace unstep
