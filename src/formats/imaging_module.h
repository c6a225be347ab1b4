#pragma once

#include <cstddef>
#include <cstdint>

/// The C interface of the module that holds what OpenCV does to pixels. It
/// loads core and imgproc only (2.5 ms; imgcodecs would be 57). No exception
/// crosses the interface. Functions return 0, or 1 with a reason (one line, cut
/// to its buffer).
extern "C" {

/// Luminance, 8 bits a pixel, 0 is black. Both sides are 1 to 2^30 - 1.
struct unstep_plane {
  std::int32_t width;
  std::int32_t height;
  std::size_t stride;  ///< bytes from row to row
  std::uint8_t* pixels;
};

/// The words of a Bitmap (unstep/bitmap.h), rows one after the other.
struct unstep_bits {
  std::int32_t width;
  std::int32_t height;
  std::size_t words_per_row;
  std::uint64_t* words;
};

struct unstep_reason {
  char* text;
  std::size_t size;
};

enum unstep_method : std::int32_t {
  UNSTEP_METHOD_SAUVOLA = 0,
  UNSTEP_METHOD_LOCAL = 1,
  /// Local, unless the page has no contrast or too much noise to go by: then
  /// nothing is written.
  UNSTEP_METHOD_LOCAL_IF_FIT = 2
};

/// What the page told.
struct unstep_page_light {
  double noise;     ///< sigma of flat places, levels
  double contrast;  ///< of edges, levels: three quarters have less; 0: none
  double darkest;   ///< paper, level that 2 % are below
  double lightest;  ///< paper, level that 2 % are above
  std::int32_t fits;
};

/// The revision of this interface that the module was built with.
int unstep_imaging_revision();

/// Ink where the luminance is below a threshold of its surroundings.
int unstep_imaging_threshold(const unstep_plane* grey, std::int32_t method,
                             unstep_page_light* light, unstep_bits* ink,
                             unstep_reason reason);

/// How far the page is turned counter-clockwise as seen, in degrees within -10
/// to 10: the angle at which rows and columns of dark pixels stand out most.
/// `level`: luminance below it is dark.
int unstep_imaging_skew(const unstep_plane* grey, std::int32_t level,
                        double* degrees, unstep_reason reason);

/// Turns the page clockwise about its middle, to the middle of `out`; what
/// comes from outside is `paper`.
int unstep_imaging_turn(const unstep_plane* grey, double degrees,
                        std::uint8_t paper, unstep_plane* out,
                        unstep_reason reason);

/// Turns pieces of at most `area` pixels over: ink (8-connected), or paper
/// (4-connected) that does not reach the edge of the page.
int unstep_imaging_remove(unstep_bits* ink, std::uint64_t area,
                          std::int32_t of_paper, std::uint64_t* pieces,
                          std::uint64_t* pixels, unstep_reason reason);

}  // extern "C"

namespace unstep {
inline constexpr int kImagingModuleRevision = 1;
inline constexpr double kMostSkew = 10;  ///< degrees
}  // namespace unstep
