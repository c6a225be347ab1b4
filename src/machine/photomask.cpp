#include "machine/photomask.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "machine/pilot.h"
#include "machine/zenit.h"

namespace unstep::machine {
namespace {

constexpr std::int32_t kRunUpPulses = 6'250;  // 0.5 mm
constexpr double kRateUm = 10;                // per second and step of the rate

Error refused(const std::string& what) {
  return {ErrorCode::out_of_range, "photomask: " + what};
}

Status check(const MaskJob& job) {
  if (job.columns < 1 || job.rows < 1) return refused("no dots");
  if (job.rate < 2 || job.rate > 1000)
    return refused("rate " + std::to_string(job.rate) + " is not in 2..1000");
  if (job.width_us < 1 || job.width_us > LaserModulator::kMaxWidthUs)
    return refused("a flash of " + std::to_string(job.width_us) +
                   " us is not in 1..1000");
  const std::int64_t most = ReversibleCounter::kMaxMagnitude - 2 * kRunUpPulses;
  const std::int64_t pitch = job.pitch_pulses;
  if (pitch < 1 || pitch * std::max(job.columns, job.rows) > most)
    return refused("the grid is wider than the counter of 23 bits");
  const double period =
      static_cast<double>(pitch) * kPulseUm / (job.rate * kRateUm);
  if (period * 1e9 < LaserModulator::kMinPeriodNs)
    return refused("more than 500 flashes a second");
  return {};
}

/// A computer that runs the rows through the controller.
class Operator {
 public:
  Operator(const MaskJob& job, Zenit& zenit)
      : job_(job), zenit_(zenit), pilot_(zenit) {}

  Status run(const std::vector<MaskRow>& rows) {
    zenit_.reset();
    zenit_.command(Operation::load_dr1, Axis::x,
                   static_cast<std::uint32_t>(job_.width_us));
    zenit_.command(Operation::pulse_mode);
    for (const MaskRow& row : rows) {
      zenit_.tick();
      pilot_.go(Axis::x, row.start);
      pilot_.go(Axis::y, row.y);
      Status status = pilot_.arrive(30 * seconds_across());
      if (!status) return status;
      status = expose(row);
      if (!status) return status;
    }
    return {};
  }

 private:
  /// Seconds for the widest way at full speed, and a little.
  [[nodiscard]] double seconds_across() const {
    return 1 + job_.pitch_pulses * kPulseUm *
                   std::max(job_.columns, job_.rows) / kMaxSpeedUm;
  }

  static Status flashed(bool all) {
    if (all) return {};
    return Error{ErrorCode::internal, "photomask: dots were lost"};
  }

  Status expose(const MaskRow& row) {
    const std::uint64_t before = zenit_.laser().flashes();
    const auto wait_for = [&](int dots, double seconds) {
      return flashed(pilot_.wait(
          [&] {
            return zenit_.laser().flashes() >=
                   before + static_cast<std::uint64_t>(dots);
          },
          seconds));
    };
    zenit_.tick();
    // Where it stands is known to the pulse, so the first flash is too.
    const auto first = static_cast<std::uint32_t>(
        std::abs(row.first - pilot_.counter(Axis::x)));
    zenit_.command(Operation::load_dr2, Axis::x, first);
    zenit_.command(Operation::reset_cr);
    zenit_.command(Operation::laser_on);
    zenit_.command(Operation::load_cr2, Axis::x,
                   to_direct_code(row.direction * job_.rate));
    zenit_.command(Operation::constant_speed);
    zenit_.command(Operation::start_motor);
    const double seconds =
        4 * seconds_across() * kMaxSpeedUm / (job_.rate * kRateUm);
    Status status = wait_for(1, seconds);
    if (!status) return status;
    zenit_.command(Operation::load_dr2, Axis::x,
                   static_cast<std::uint32_t>(job_.pitch_pulses));
    status = wait_for(job_.columns, seconds);
    if (!status) return status;
    // The last flash ends before the motor brakes.
    for (int tick = 0; tick * kTickSeconds * 1e6 < job_.width_us; ++tick)
      zenit_.tick();
    zenit_.command(Operation::laser_off);
    return {};
  }

  const MaskJob& job_;
  Zenit& zenit_;
  Pilot pilot_;
};

MaskReport measure(const MaskJob& job, const std::vector<MaskRow>& rows,
                   const Zenit& zenit) {
  MaskReport report;
  report.dots = static_cast<int>(zenit.flashes().size());
  report.seconds = zenit.seconds();
  report.top_speed_um = zenit.top_speed_um();
  const double pitch = job.pitch_pulses * kPulseUm;
  double squares = 0;
  for (int i = 0; i < report.dots; ++i) {
    const int row = i / job.columns;
    const int place = i % job.columns;
    const int column = rows[static_cast<std::size_t>(row)].direction > 0
                           ? place
                           : job.columns - 1 - place;
    const Flash& flash = zenit.flashes()[static_cast<std::size_t>(i)];
    const double x = column * pitch;
    const double y = row * pitch;
    const double error = std::max(std::hypot(flash.x0_um - x, flash.y0_um - y),
                                  std::hypot(flash.x1_um - x, flash.y1_um - y));
    report.worst_um = std::max(report.worst_um, error);
    squares += error * error;
    report.smear_um = std::max(
        report.smear_um,
        std::hypot(flash.x1_um - flash.x0_um, flash.y1_um - flash.y0_um));
  }
  report.rms_um = std::sqrt(squares / report.dots);
  return report;
}

}  // namespace

Result<std::vector<MaskRow>> plan_mask(const MaskJob& job) {
  if (const Status status = check(job); !status) return status.error();
  const double smear_um = job.width_us * 1e-6 * job.rate * kRateUm;
  const auto early = static_cast<std::int32_t>(smear_um / 2 / kPulseUm + 0.5);
  std::vector<MaskRow> rows;
  rows.reserve(static_cast<std::size_t>(job.rows));
  for (int i = 0; i < job.rows; ++i) {
    MaskRow row;
    row.direction = i % 2 == 0 ? 1 : -1;
    row.y = i * job.pitch_pulses;
    const std::int32_t dot =
        row.direction > 0 ? 0 : (job.columns - 1) * job.pitch_pulses;
    // Count n begins at n going up; going down n - 1 begins there.
    row.first = row.direction > 0 ? dot - early : dot - 1 + early;
    row.start = row.first - row.direction * kRunUpPulses;
    rows.push_back(row);
  }
  return rows;
}

Result<MaskReport> expose_mask(const MaskJob& job, const Plant& plant,
                               std::uint64_t seed) {
  const auto rows = plan_mask(job);
  if (!rows) return rows.error();
  Zenit zenit(plant, seed);
  const Status status = Operator(job, zenit).run(*rows);
  if (!status) return status.error();
  if (zenit.flashes().size() != static_cast<std::size_t>(job.columns) *
                                    static_cast<std::size_t>(job.rows))
    return Error{ErrorCode::internal, "photomask: dots were lost"};
  return measure(job, *rows, zenit);
}

}  // namespace unstep::machine
