#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/arc_model.h"
#include "codec/density_grid.h"
#include "codec/number_model.h"
#include "codec/path_coder.h"
#include "codec/start_position_model.h"
#include "codec/vector_model.h"
#include "codec/vertex_memory.h"
#include "entropy/counter.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// What the paths of a payload have in common.
struct PathFrame {
  bool arcs = false;  ///< there are some
  StartFrame starts;
};

/// Predicts where paths start and their elements. Encoder and decoder run the
/// same object in step; everything is integer.
class PathModel {
 public:
  PathModel();

  /// What holds for all paths of the payload, coded first.
  template <class Coder>
  void code_frame(Coder& coder, const PathFrame& frame) {
    code_arcs(coder, frame.arcs);
    starts_.code_frame(coder, frame.starts);
  }
  /// The same where starts are coded elsewhere.
  template <class Coder>
  void code_arcs(Coder& coder, bool arcs) {
    arcs_ = coder.code(arcs, 32768);
  }

  /// Where the next path starts; not checked.
  template <class Coder>
  Vec code_start(Coder& coder, Point start) {
    return starts_.code(coder, start, density_);
  }

  void begin(const PathHead& head);
  void end();

  /// Codes the next element and goes along it. False if it cannot be.
  template <class Coder>
  bool code(Coder& coder, Path::Element& element) {
    place_.arc = code_kind(coder, element.kind == Path::Kind::arc);
    Vec move = place_.arc ? Vec{element.arc.end.x, element.arc.end.y}
                          : Vec{element.segment.dx, element.segment.dy};
    if (head_.closed && place_.left == 1) {
      move = place_.home;
    } else if (!vectors_.code(coder, place_, move)) {
      return false;
    }
    Vec centre;
    bool clockwise = element.arc.clockwise;
    if (place_.arc) {
      centre = {element.arc.centre.x, element.arc.centre.y};
      if (!arc_.code(coder, move, last_, centre, clockwise) || centre.zero() ||
          !in_range(centre)) {
        return false;
      }
    }
    if (!in_range(move)) return false;
    element = made(place_.arc, move, centre, clockwise);
    advance(move, centre, clockwise);
    return true;
  }

  /// Goes along an element that is known already.
  void follow(const Path::Element& element);

  /// Forgets all vertices, but nothing that was learned.
  void restart();

  [[nodiscard]] const VertexMemory& vertices() const { return vertices_; }

  /// For a warm start and its training.
  [[nodiscard]] VectorModel& vectors() { return vectors_; }
  [[nodiscard]] StartPositionModel& starts() { return starts_; }

 private:
  template <class Coder>
  bool code_kind(Coder& coder, bool arc) {
    if (!arcs_) return false;
    const bool coded = NumberModel::decide(coder, kinds_[kinds_before_], arc);
    kinds_before_ = (kinds_before_ * 2 + (coded ? 1 : 0)) % kinds_.size();
    return coded;
  }

  /// Whether the point so far from here is within the range of coordinates.
  [[nodiscard]] bool in_range(const Vec& move) const;
  static Path::Element made(bool arc, const Vec& move, const Vec& centre,
                            bool clockwise);
  void advance(const Vec& move, const Vec& centre, bool clockwise);

  bool arcs_ = false;
  VertexMemory vertices_;
  DensityGrid density_;
  StartPositionModel starts_;
  VectorModel vectors_;
  ArcModel arc_;
  std::array<entropy::Counter, 16> kinds_;
  std::size_t kinds_before_ = 0;

  PathHead head_;
  std::int32_t first_vertex_ = 0;
  VectorPlace place_;
  Vec last_;  ///< direction at the end of the element before, may be zero
};

}  // namespace unstep::codec
