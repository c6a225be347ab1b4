#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reverse/chain_walk.h"
#include "reverse/crossing.h"
#include "reverse/vertex_map.h"

namespace unstep::reverse {

/// Finds lines that cross, as find_crossings() does, where all vertices are
/// points of the chains and no line is farther than a unit from its chain: the
/// usual case. Pairs whose chains cross or run through a common edge may be
/// missing.
///
/// A chain that becomes a line sweeps the points between the two. If neither of
/// two lines sweeps an end of the other, they cross as often as their chains
/// do, but for an even number of times: not at all if those do not, for two
/// lines cross once at most (docs/algorithms.md). So each line looks for
/// vertices among the points that it sweeps, mostly those of its chain alone.
///
/// Memory: about 50 bytes for each vertex, 16 for each path.
class SweptPoints {
 public:
  /// `chains`, `paths` and `closed` stay where they are. No paths: none is ever
  /// found. REQUIRES: path units are steps.
  SweptPoints(std::span<const ChainWalk> chains,
              std::span<const LineVertices> paths,
              const std::vector<bool>& closed);

  /// Says that a path has got another vertex, which starts this line of it.
  void add(const LineVertex& vertex, std::uint32_t path, std::size_t line);

  /// The pairs of lines that cross; a pair may come more than once.
  std::vector<CrossingPair> find_all();

  /// Those where a line or a vertex is new in one of `places`, perhaps others.
  /// REQUIRES: there is a place.
  std::vector<CrossingPair> find(std::span<const Box> places);

 private:
  using Vertex = VertexMap::Vertex;

  struct Move {
    Point by;
    std::size_t place = 0;  ///< of that in the map
  };

  template <class Visit>
  void for_swept(LineId id, const Visit& visit) const;
  template <class Visit>
  void for_lines_at(std::uint32_t path, std::uint32_t vertex,
                    const Visit& visit) const;
  [[nodiscard]] std::uint32_t line_of(const Vertex& vertex) const;
  void sweep(LineId id);
  void compare_at(Point at, LineId id);
  void compare_ends(const Vertex& vertex);

  std::span<const ChainWalk> chains_;
  std::span<const LineVertices> paths_;
  const std::vector<bool>& closed_;
  LineMeeting meeting_;
  VertexMap map_;
  std::array<Move, 8> moves_;
  std::vector<Box> boxes_;              ///< around each path
  std::vector<Vertex> perhaps_shared_;  ///< one may be at the same point
  std::vector<CrossingPair> found_;
};

}  // namespace unstep::reverse
