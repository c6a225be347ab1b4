#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "unstep/grid.h"

/// What the tests of paths share.
namespace unstep::testing {

inline Path::Element line(std::int32_t dx, std::int32_t dy) {
  return {Path::Kind::segment, {dx, dy}, {}};
}
inline Path::Element arc(Point centre, Point end, bool clockwise = true) {
  return {Path::Kind::arc, {}, {centre, end, clockwise}};
}
inline Point move_of(const Path::Element& element) {
  return element.kind == Path::Kind::arc
             ? element.arc.end
             : Point{element.segment.dx, element.segment.dy};
}

/// A path of lines and some arcs that bends little more often than much; a
/// closed one comes home by a line.
inline Path random_path(std::mt19937& random, std::size_t elements,
                        std::int32_t size, bool arcs) {
  const auto any = [&](std::int32_t limit) {
    return static_cast<std::int32_t>(random() %
                                     (2U * static_cast<unsigned>(limit) + 1)) -
           limit;
  };
  Path path;
  path.origin = {any(3000), any(3000)};
  path.closed = random() % 2 == 0;
  path.width = random() % 4 == 0 ? any(9) + 9 : 0;
  Point at;
  Point move{size, 0};
  for (std::size_t i = 0; i + 1 < elements; ++i) {
    move = random() % 3 == 0 ? Point{any(size), any(size)}
                             : Point{move.x + any(2), move.y + any(2)};
    at = {at.x + move.x, at.y + move.y};
    path.elements.push_back(line(move.x, move.y));
    if (!arcs || random() % 3 != 0) continue;
    const Point centre{any(size), 1 + any(size) / 2};
    path.elements.back() =
        arc(centre == Point{} ? Point{1, 1} : centre, move, random() % 2 == 0);
  }
  if (elements > 0) path.elements.push_back(line(-at.x, -at.y));
  return path;
}

inline std::vector<Path> random_paths(unsigned seed, std::size_t count,
                                      std::size_t longest, bool arcs = true) {
  std::mt19937 random(seed);
  std::vector<Path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t elements = random() % (longest + 1);
    const auto size = static_cast<std::int32_t>(1U << random() % 10);
    paths.push_back(random_path(random, elements, size, arcs));
  }
  return paths;
}

inline std::uint64_t elements_of(const std::vector<Path>& paths) {
  std::uint64_t elements = 0;
  for (const Path& path : paths) elements += path.elements.size();
  return elements;
}

}  // namespace unstep::testing
