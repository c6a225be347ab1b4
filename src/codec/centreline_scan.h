#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/block_coder.h"
#include "codec/centreline_coder.h"
#include "codec/centreline_model.h"
#include "codec/centreline_start_model.h"
#include "codec/centreline_warm_start.h"
#include "codec/deep_centreline_model.h"
#include "codec/pixel_planes.h"
#include "codec/vertex_rulers.h"

namespace unstep::codec {

/// Coder 3, both sides: pieces of ink are found in raster order and their lines
/// followed pixel by pixel; at each it is coded which of the pixels around it,
/// of those not yet known, are ink. Encoder and decoder run this same code;
/// `Side` is what differs:
///
///     coder()              an arithmetic encoder or decoder
///     ink(x, y)            the true pixel
///     ink_word(y, word)    the true pixels of a word
///     row(y, planes)       a row of pixels is complete
///     damaged()            the payload cannot be right; give up
///
/// The decoder's answers to the questions are never looked at.
///
/// `Lines` and `Starts` are the models.
template <class Side, class Lines, class Starts>
class CentrelineScan {
 public:
  CentrelineScan(Side& side, std::int32_t width, std::int32_t height,
                 int table_bits,
                 const centreline_warm::Table& start = centreline_warm::kTable)
      : side_(side),
        planes_(width, height),
        rulers_(width, height),
        lines_(planes_, rulers_, table_bits, start),
        starts_(planes_, rulers_) {}

  Status run(const BlockProgress& progress) {
    for (std::int32_t y = 0; y < planes_.height(); ++y) {
      starts_.begin_row(y);
      for (std::int32_t word = 0; word * 64 < planes_.width(); ++word) {
        if (Status scanned = scan_word(y, word); !scanned) return scanned;
      }
      side_.row(y, planes_);
      if (progress && y % 64 == 63 &&
          !progress(static_cast<std::uint64_t>(y) + 1)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
    }
    return {};
  }

  [[nodiscard]] const Lines& lines() const { return lines_; }
  [[nodiscard]] const Starts& starts() const { return starts_; }

 private:
  /// A pixel of ink whose neighbours are still to be looked at.
  struct Waiting {
    Point at;
    Step direction;  ///< of the step that leads to it
    std::uint8_t turn;
  };

  Status scan_word(std::int32_t y, std::int32_t word) {
    for (;;) {
      const std::uint64_t unknown = ~planes_.known_word(y, word);
      if (unknown == 0) return {};
      const std::uint64_t bit =
          starts_.code(side_.coder(), unknown, word, side_.ink_word(y, word));
      // All before it are paper, or all of them.
      planes_.mark_paper(y, word,
                         bit == 0 ? unknown : unknown & ~(bit | (bit - 1)));
      if (bit == 0) return {};
      const Point start{word * 64 + std::countl_zero(bit), y};
      planes_.mark(planes_.at(start.x, start.y), true);
      rulers_.add(start.x, start.y);
      if (Status followed = follow_piece(start); !followed) return followed;
    }
  }

  /// All of a piece of 8-connected ink.
  Status follow_piece(Point start) {
    lines_.begin_piece(start);
    lines_.begin_line(start, 0, -1);
    waiting_.clear();
    for (;;) {
      if (Status followed = follow_line(); !followed) return followed;
      // The last one that no line has come by.
      while (!waiting_.empty() && passed(waiting_.back().at)) {
        waiting_.pop_back();
      }
      if (waiting_.empty()) return {};
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      lines_.begin_line(next.at, next.direction, next.turn);
    }
  }

  /// From the head of a line to its end.
  Status follow_line() {
    for (;;) {
      if (side_.damaged()) return damage("ends too early");
      const Point at = lines_.position();
      const Step heading = lines_.direction();
      const PixelPlanes::Address pixel = planes_.at(at.x, at.y);
      const PixelPlanes::Ring ring = planes_.around(pixel);
      unsigned found = 0;
      if (ring.unknown != 0) {
        const unsigned unknown = turned(ring.unknown, heading);
        found =
            lines_.code(side_.coder(), unknown, truth(at, heading, unknown));
        learn_pixels(at, heading, unknown, found);
      }
      planes_.pass(pixel);
      const unsigned ways = found != 0 ? found : turned(ring.open, heading);
      if (ways == 0) return {};
      const unsigned turn = first_of(ways);
      if (!let_wait(at, heading, found & ~(1U << turn))) {
        return damage("has too many branches");
      }
      if (lines_.steps() > 0 && (found == 0 || (turn >= 2 && turn <= 6))) {
        rulers_.add(at.x, at.y);
      }
      lines_.advance(turn);
    }
  }

  /// A set of directions as one of turns.
  static unsigned turned(unsigned directions, Step heading) {
    return (directions >> heading | directions << (8 - heading)) & 255U;
  }
  /// The turn of a set, not empty, that is asked about first.
  static unsigned first_of(unsigned turns) {
    for (const std::uint8_t turn : Lines::kOrder) {
      if ((turns >> turn & 1) != 0) return turn;
    }
    return 0;
  }
  static Point neighbour(Point at, Step heading, unsigned turn) {
    const Point move =
        step_delta(static_cast<Step>((heading + turn) & 7U), YAxis::down);
    return {at.x + move.x, at.y + move.y};
  }

  [[nodiscard]] unsigned truth(Point at, Step heading, unsigned turns) const {
    unsigned ink = 0;
    for (; turns != 0; turns &= turns - 1) {
      const auto turn = static_cast<unsigned>(std::countr_zero(turns));
      const Point pixel = neighbour(at, heading, turn);
      ink |= side_.ink(pixel.x, pixel.y) ? 1U << turn : 0U;
    }
    return ink;
  }

  void learn_pixels(Point at, Step heading, unsigned turns, unsigned ink) {
    for (; turns != 0; turns &= turns - 1) {
      const auto turn = static_cast<unsigned>(std::countr_zero(turns));
      const Point pixel = neighbour(at, heading, turn);
      planes_.mark(planes_.at(pixel.x, pixel.y), (ink >> turn & 1) != 0);
    }
  }

  /// The other pixels found, those asked about last first. False if too many
  /// wait.
  bool let_wait(Point at, Step heading, unsigned turns) {
    if (turns == 0) return true;
    for (std::size_t i = Lines::kOrder.size(); i-- > 0;) {
      const unsigned turn = Lines::kOrder[i];
      if ((turns >> turn & 1) == 0) continue;
      if (waiting_.size() == kMostWaiting) return false;
      waiting_.push_back({neighbour(at, heading, turn),
                          static_cast<Step>((heading + turn) & 7U),
                          static_cast<std::uint8_t>(turn)});
    }
    return true;
  }

  [[nodiscard]] bool passed(Point at) const {
    return planes_.passed(planes_.at(at.x, at.y));
  }
  [[nodiscard]] Error damage(const char* what) const {
    return {ErrorCode::corrupt, "centreline payload " + std::string(what) +
                                    " at row " +
                                    std::to_string(lines_.position().y)};
  }

  Side& side_;
  PixelPlanes planes_;
  VertexRulers rulers_;
  Lines lines_;
  Starts starts_;
  std::vector<Waiting> waiting_;  ///< the last one goes first
};

}  // namespace unstep::codec
