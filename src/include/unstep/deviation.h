#pragma once

#include <array>
#include <cstdint>

#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/program.h"
#include "unstep/result.h"

/// How far a path is from the chain that it stands for. Written apart from
/// reverse interpolation, so that one proves the other.
///
///     Result<Deviation> found = measure_deviation(traced, decoded);
///     if (found && found->distance > 1.0) complain(found->where);
namespace unstep {

/// The largest Frechet distance between a chain and its path, and where.
struct Deviation {
  double distance = 0;   ///< grid units, rounded up: the true one is not larger
  std::size_t path = 0;  ///< index of the chain and of its path
  std::size_t step = 0;  ///< the chain has made this many steps there
  double x = 0;          ///< the place, grid units
  double y = 0;
};

/// Measures every path of `paths` against the chain of the same index in
/// `chains`: the Euclidean Frechet distance between the polyline through the
/// chain's points and the path's lines and arcs, before rasterising. It is
/// found to 2^-11 of a grid unit (2^-20 of itself if that is more) and rounded
/// up. A closed chain may start anywhere: the places of it that are locally
/// nearest to the path's start are tried, the best 32 of them. Thorough, not
/// fast: a few million steps per second.
/// invalid_argument if the numbers of chains and paths differ, one of a pair
/// is closed and the other is not, a closed one does not return, a step is no
/// direction or an arc has no radius.
Result<Deviation> measure_deviation(const Drawing& chains,
                                    const Drawing& paths);

/// The fast form for every day: success only if every distance is at most
/// `tolerance`, grid units. Lines are decided in exact integers, in linear
/// time; so are arcs whose radius exceeds the tolerance by two units, walked
/// along their radii. What that cannot decide (other arcs, other starts of a
/// closed chain, parts of an arc beyond 2^27 path units, terms of the
/// tolerance beyond 2^30) falls to the thorough form, which refuses when in
/// doubt, by 2^-19 of a unit. `corrupt`, naming path and step, if a path is too
/// far from its chain. invalid_argument as above and for a denominator of 0.
Status check_deviation(const Drawing& chains, const Drawing& paths,
                       const Rational& tolerance);

/// How far two drawings are apart whatever belongs to what: paths of other
/// programs, say.
struct Distance {
  struct Worst {
    double distance = 0;  ///< grid units
    double x = 0;         ///< the place it is measured from, grid units
    double y = 0;
  };
  Worst of_chains;  ///< from the chains to the nearest of the paths
  Worst of_paths;   ///< from the paths to the nearest of the chains
};

/// The Hausdorff distance between the chains of one drawing and the paths of
/// another, both ways, at places `resolution` grid units apart: the true ones
/// are not less than these and not more than resolution / 2 above.
/// out_of_range for a resolution outside [2^-10, 2^10]; invalid_argument if
/// one has nothing and the other has not, or as above.
Result<Distance> measure_distance(const Drawing& chains, const Drawing& paths,
                                  double resolution = 0.125);

/// How far the ink of two rasters is apart, pixel centre to pixel centre.
struct InkDistance {
  struct Worst {
    std::int64_t square = 0;  ///< of the distance to the nearest ink there
    Point at;                 ///< the pixel it is measured from
    [[nodiscard]] double distance() const;  ///< pixels
  };
  Worst of_a;  ///< from the ink of the first to that of the second
  Worst of_b;
  std::uint64_t ink = 0;     ///< pixels of the first
  std::uint64_t only_a = 0;  ///< ink pixels that the second has not
  std::uint64_t only_b = 0;
  /// The Hausdorff distance: the larger of the two.
  [[nodiscard]] const Worst& worst() const {
    return of_a.square < of_b.square ? of_b : of_a;
  }
};

/// The Hausdorff distance between the ink of two rasters, exactly, in time of
/// their pixels. invalid_argument if their sizes differ, or one has ink and the
/// other none.
Result<InkDistance> measure_ink(const Bitmap& a, const Bitmap& b);

/// The guarantee of device mode (SU 1089551): draws the segments of `paths`
/// with Method::device and compares point by point. `distance` is the largest
/// difference on one axis at the same step index; at most 1 for what
/// DeviceReverse makes. invalid_argument if numbers, ends or lengths differ, or
/// a path has arcs.
Result<Deviation> measure_device_deviation(const Drawing& chains,
                                           const Drawing& paths);

/// The largest Frechet distance between what two programs cut, and where.
struct ProgramDeviation {
  double distance = 0;         ///< mm, rounded up: the true one is not larger
  double least = 0;            ///< nor smaller than this, 3e-6 mm below
  std::array<double, 3> at{};  ///< mm, machine coordinates, on the first
  std::uint32_t line = 0;      ///< of the first's source; 0: no place is off
};

/// Measures a program that stands for another, in x, y and z: the paths between
/// rapids and changes of feed or spindle are compared one by one, in the order
/// of travel, arcs as chords within 1e-6 mm, and the ends of rapids point by
/// point. Shares nothing with compact(). Text is not compared; what is not
/// understood is left out. Nothing is measured after a distance above
/// `limit_mm`, whose `distance` may be too small. `corrupt`, naming lines, if
/// the programs have other rapids, feeds, spindle speeds, or ends of other
/// axes; out_of_range for a limit that is not 1e-4 to 1000 mm.
Result<ProgramDeviation> measure_program_deviation(const Program& first,
                                                   const Program& second,
                                                   double limit_mm);

}  // namespace unstep
