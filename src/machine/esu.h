#pragma once

#include <cstdint>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/result.h"

/// The electron scanning device (ESU) in front of "Zenit": it reads film and
/// writes it, point by point.
namespace unstep::machine {

inline constexpr std::int32_t kEsuField = 4096;  ///< points a side
inline constexpr int kEsuClear = 127;            ///< of a 7-bit transmission
inline constexpr double kEsuPointsPerSecond = 1e5;

struct EsuOptions {
  /// Full width at half maximum of the beam, a Gaussian (ours): 3..5 um.
  double spot_um = 4;
  /// From point to point (ours): so the field is 16.4 mm wide.
  double pitch_um = 4;
  /// How far the raster wanders from end to end on each axis, as a share of the
  /// field, 0..0.01. Four fifths are drift, a line at a time; the rest is hum
  /// of the mains, 50 Hz (ours).
  double instability = 0.001;
  std::uint64_t seed = 1;  ///< of the phases of drift and hum
};

/// A piece of film as the device sees it: transmissions of 0, opaque, to 127,
/// clear; row by row from the top, `width` bytes a row.
struct Film {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint8_t> transmission;
};

/// Seconds of the beam for every point of a raster.
[[nodiscard]] double esu_seconds(const Film& film);

/// The transmission at every point of a drawing on film, ink opaque, paper and
/// what is around it clear. One byte a point of memory.
/// out_of_range: a drawing wider or higher than the field, or an option out of
/// its range.
Result<Film> esu_scan(const Bitmap& drawing, const EsuOptions& options = {});

/// Exposes film at every ink point. A spot darkens what it lights; full
/// exposure is opaque. Errors as above; 5 bytes a point.
Result<Film> esu_write(const Bitmap& drawing, const EsuOptions& options = {});

/// How far the beam is from the points of the ink.
struct BeamError {
  double worst_um = 0;
  double rms_um = 0;
};

/// Of a scan or a writing with these options; 0 without ink. Errors as above.
Result<BeamError> esu_beam_error(const Bitmap& drawing,
                                 const EsuOptions& options = {});

/// Ink where the transmission is below `threshold`, 1..127; out_of_range for
/// another or an empty film. The usual one keeps a line of one point wherever
/// it falls between two points, where it is half as dark.
Result<Bitmap> film_ink(const Film& film, int threshold = 80);

}  // namespace unstep::machine
