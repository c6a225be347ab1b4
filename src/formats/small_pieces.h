#pragma once

#include <cstdint>

#include "formats/imaging_module.h"

/// Part of the module that holds OpenCV.
namespace unstep::imaging {

struct PiecesRemoved {
  std::uint64_t pieces = 0;
  std::uint64_t pixels = 0;
};

/// Turns pieces of at most `area` pixels over: ink (8-connected), or paper
/// (4-connected) that does not reach the edge of the page. Works on bands of
/// rows, so that memory grows with the width times `area` at most.
PiecesRemoved remove_small_pieces(unstep_bits& ink, std::uint64_t area,
                                  bool of_paper);

}  // namespace unstep::imaging
