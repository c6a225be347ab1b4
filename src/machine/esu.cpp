#include "machine/esu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "machine/carriage.h"

namespace unstep::machine {
namespace {

Status check(const Bitmap& drawing, const EsuOptions& options) {
  const auto refuse = [](const std::string& what) {
    return Error{ErrorCode::out_of_range, "ESU: " + what};
  };
  if (drawing.width() < 1 || drawing.height() < 1)
    return refuse("an empty drawing");
  if (drawing.width() > kEsuField || drawing.height() > kEsuField)
    return refuse(std::to_string(drawing.width()) + " x " +
                  std::to_string(drawing.height()) +
                  " points are more than the field of 4096 x 4096");
  if (!(options.spot_um >= 3 && options.spot_um <= 5))
    return refuse("the spot is not in 3..5 um");
  if (!(options.pitch_um >= 3 && options.pitch_um <= 5))
    return refuse("the pitch is not in 3..5 um");
  if (!(options.instability >= 0 && options.instability <= 0.01))
    return refuse("the instability is not in 0..0.01");
  return {};
}

struct Offset {
  double x = 0;
  double y = 0;
};

/// Where the beam is beside its point.
class Deflection {
 public:
  explicit Deflection(const EsuOptions& options)
      : reach_(options.instability * kEsuField / 2) {
    Noise noise(options.seed);
    for (double& phase : phases_) phase = noise.next() * std::numbers::pi;
  }

  /// At most this far on each axis.
  [[nodiscard]] double reach() const { return reach_; }

  void begin_line(double seconds) {
    // Periods of 97 and 71 s, so that a whole field meets all phases.
    drift_ = {0.8 * reach_ * std::sin(turns(seconds / 97) + phases_[0]),
              0.8 * reach_ * std::sin(turns(seconds / 71) + phases_[1])};
  }
  [[nodiscard]] Offset at(double seconds) const {
    const double hum = turns(seconds * 50);
    return {drift_.x + 0.2 * reach_ * std::sin(hum + phases_[2]),
            drift_.y + 0.2 * reach_ * std::sin(hum + phases_[3])};
  }

 private:
  static double turns(double periods) { return periods * 2 * std::numbers::pi; }
  double reach_;
  std::array<double, 4> phases_{};
  Offset drift_;
};

/// The share of the beam in each of five cells about the one with its middle,
/// along one axis, by the place of the middle within its cell. What is beyond
/// them, less than 2e-6 of the usual beam and 3e-3 of one of 5 um on a pitch
/// of 3 um, is shared out among them.
class Spot {
 public:
  static constexpr int kReach = 2;
  static constexpr int kCells = 2 * kReach + 1;
  using Shares = std::array<float, kCells>;

  explicit Spot(const EsuOptions& options) {
    const double sigma =
        options.spot_um / options.pitch_um / 2.3548200450309493;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      const double middle = (static_cast<double>(i) + 0.5) / kFractions;
      std::array<double, kCells> share{};
      double sum = 0;
      for (int cell = 0; cell < kCells; ++cell) {
        const double from = (cell - kReach - middle) / sigma;
        const double to = from + 1 / sigma;
        const double part = below(to) - below(from);
        share[static_cast<std::size_t>(cell)] = part;
        sum += part;
      }
      for (std::size_t cell = 0; cell < kCells; ++cell)
        shares_[i][cell] = static_cast<float>(share[cell] / sum);
    }
  }

  [[nodiscard]] const Shares& at(double place) const {
    const double fraction = place - std::floor(place);
    return shares_[std::min(static_cast<std::size_t>(fraction * kFractions),
                            shares_.size() - 1)];
  }

 private:
  static constexpr int kFractions = 64;
  static double below(double x) {
    return std::erfc(-x / std::numbers::sqrt2) / 2;
  }
  std::array<Shares, kFractions> shares_;
};

std::int32_t cell(double place) {
  return static_cast<std::int32_t>(std::floor(place));
}

/// The film under a scan. `margin` is how far a point may see.
class Scene {
 public:
  Scene(const Bitmap& drawing, std::int32_t margin)
      : drawing_(drawing), margin_(margin) {}

  [[nodiscard]] bool ink(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < drawing_.width() && y < drawing_.height() &&
           drawing_.get(x, y);
  }

  /// Can the points of a word see no ink? Most of a line drawing is so.
  [[nodiscard]] bool paper(std::size_t word, std::int32_t y) const {
    const std::size_t from = word == 0 ? 0 : word - 1;
    const std::size_t to = std::min(word + 2, drawing_.words_per_row());
    const std::int32_t last = std::min(y + margin_ + 1, drawing_.height());
    for (std::int32_t row = std::max(0, y - margin_); row < last; ++row)
      for (std::size_t i = from; i < to; ++i)
        if (drawing_.row(row)[i] != 0) return false;
    return true;
  }

 private:
  const Bitmap& drawing_;
  std::int32_t margin_;
};

float darkness(const Scene& scene, const Spot& spot, double x, double y) {
  const Spot::Shares& across = spot.at(x);
  const Spot::Shares& down = spot.at(y);
  const std::int32_t left = cell(x) - Spot::kReach;
  const std::int32_t top = cell(y) - Spot::kReach;
  float sum = 0;
  for (int j = 0; j < Spot::kCells; ++j)
    for (int i = 0; i < Spot::kCells; ++i)
      if (scene.ink(left + i, top + j))
        sum += across[static_cast<std::size_t>(i)] *
               down[static_cast<std::size_t>(j)];
  return sum;
}

std::uint8_t transmission(float dark) {
  const float light = 1 - std::min(dark, 1.0F);
  return static_cast<std::uint8_t>(light * kEsuClear + 0.5F);
}

std::size_t points(const Bitmap& drawing) {
  return static_cast<std::size_t>(drawing.pixels());
}

/// The film with the light of all spots on it.
class Exposure {
 public:
  explicit Exposure(const Bitmap& drawing)
      : width_(drawing.width()),
        height_(drawing.height()),
        light_(points(drawing)) {}

  void add(const Spot& spot, double x, double y) {
    const Spot::Shares& across = spot.at(x);
    const Spot::Shares& down = spot.at(y);
    for (int j = 0; j < Spot::kCells; ++j) {
      const std::int32_t row = cell(y) - Spot::kReach + j;
      if (row < 0 || row >= height_) continue;
      for (int i = 0; i < Spot::kCells; ++i) {
        const std::int32_t column = cell(x) - Spot::kReach + i;
        if (column < 0 || column >= width_) continue;
        light_[static_cast<std::size_t>(row) *
                   static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(column)] +=
            across[static_cast<std::size_t>(i)] *
            down[static_cast<std::size_t>(j)];
      }
    }
  }

  [[nodiscard]] Film develop() const {
    Film film{width_, height_, {}};
    film.transmission.resize(light_.size());
    std::ranges::transform(light_, film.transmission.begin(), transmission);
    return film;
  }

 private:
  std::int32_t width_;
  std::int32_t height_;
  std::vector<float> light_;
};

}  // namespace

double esu_seconds(const Film& film) {
  return static_cast<double>(film.transmission.size()) / kEsuPointsPerSecond;
}

Result<Film> esu_scan(const Bitmap& drawing, const EsuOptions& options) {
  if (const Status status = check(drawing, options); !status)
    return status.error();
  Deflection deflection(options);
  const Spot spot(options);
  const Scene scene(drawing, cell(deflection.reach()) + 1 + Spot::kReach);
  Film film{drawing.width(), drawing.height(), {}};
  film.transmission.assign(points(drawing), kEsuClear);
  std::size_t point = 0;
  for (std::int32_t y = 0; y < film.height; ++y) {
    deflection.begin_line(static_cast<double>(point) / kEsuPointsPerSecond);
    for (std::int32_t x = 0; x < film.width;) {
      const std::int32_t end = std::min(x + 64, film.width);
      if (scene.paper(static_cast<std::size_t>(x) / 64, y)) {
        point += static_cast<std::size_t>(end - x);
        x = end;
        continue;
      }
      for (; x < end; ++x, ++point) {
        const Offset offset =
            deflection.at(static_cast<double>(point) / kEsuPointsPerSecond);
        film.transmission[point] = transmission(
            darkness(scene, spot, x + 0.5 + offset.x, y + 0.5 + offset.y));
      }
    }
  }
  return film;
}

Result<Film> esu_write(const Bitmap& drawing, const EsuOptions& options) {
  if (const Status status = check(drawing, options); !status)
    return status.error();
  Deflection deflection(options);
  const Spot spot(options);
  Exposure exposure(drawing);
  std::size_t point = 0;
  for (std::int32_t y = 0; y < drawing.height(); ++y) {
    deflection.begin_line(static_cast<double>(point) / kEsuPointsPerSecond);
    for (std::int32_t x = 0; x < drawing.width(); ++x, ++point) {
      if (!drawing.get(x, y)) continue;
      const Offset offset =
          deflection.at(static_cast<double>(point) / kEsuPointsPerSecond);
      exposure.add(spot, x + 0.5 + offset.x, y + 0.5 + offset.y);
    }
  }
  return exposure.develop();
}

Result<BeamError> esu_beam_error(const Bitmap& drawing,
                                 const EsuOptions& options) {
  if (const Status status = check(drawing, options); !status)
    return status.error();
  Deflection deflection(options);
  double worst = 0;
  double sum = 0;
  std::size_t point = 0;
  for (std::int32_t y = 0; y < drawing.height(); ++y) {
    deflection.begin_line(static_cast<double>(point) / kEsuPointsPerSecond);
    for (std::int32_t x = 0; x < drawing.width(); ++x, ++point) {
      if (!drawing.get(x, y)) continue;
      const Offset offset =
          deflection.at(static_cast<double>(point) / kEsuPointsPerSecond);
      const double square = offset.x * offset.x + offset.y * offset.y;
      worst = std::max(worst, square);
      sum += square;
    }
  }
  if (sum == 0) return BeamError{};
  const double mean = sum / static_cast<double>(drawing.ink());
  return BeamError{std::sqrt(worst) * options.pitch_um,
                   std::sqrt(mean) * options.pitch_um};
}

Result<Bitmap> film_ink(const Film& film, int threshold) {
  if (threshold < 1 || threshold > kEsuClear)
    return Error{
        ErrorCode::out_of_range,
        "ESU: threshold " + std::to_string(threshold) + " is not in 1..127"};
  auto page = Bitmap::create(film.width, film.height);
  if (!page) return page;
  std::size_t point = 0;
  for (std::int32_t y = 0; y < film.height; ++y)
    for (std::int32_t x = 0; x < film.width; ++x, ++point)
      if (film.transmission[point] < threshold) page->set(x, y, true);
  return page;
}

}  // namespace unstep::machine
