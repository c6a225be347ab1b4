#include "codec/path_checksum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "codec/checksum.h"

namespace unstep::codec {
namespace {

/// Coordinates are within 2^30, centres of arcs too; what an arc draws is
/// within 2^30 + 2^32.
struct Place {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

Place operator+(const Place& a, const Point& b) {
  return {a.x + b.x, a.y + b.y};
}

bool in_range(const Place& p) {
  return p.x >= -kMaxCoord && p.x <= kMaxCoord && p.y >= -kMaxCoord &&
         p.y <= kMaxCoord;
}

struct Bounds {
  Place low{std::int64_t{1} << 40, std::int64_t{1} << 40};
  Place high{-(std::int64_t{1} << 40), -(std::int64_t{1} << 40)};

  void add(const Place& p, std::int64_t margin = 0) {
    low = {std::min(low.x, p.x - margin), std::min(low.y, p.y - margin)};
    high = {std::max(high.x, p.x + margin), std::max(high.y, p.y + margin)};
  }
};

/// The smallest r with r * r >= square, square < 2^63.
std::int64_t root_up(std::int64_t square) {
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (r > 0 && (r - 1) * (r - 1) >= square) --r;
  while (r * r < square) ++r;
  return r;
}

/// Whether d is met when a turns counter-clockwise (x towards y) to b, ends
/// included; all the way round if a and b have the same direction.
bool sweeps(const Place& a, const Place& b, const Place& d) {
  const auto cross = [](const Place& p, const Place& q) {
    return p.x * q.y - p.y * q.x;  // differences < 2^31: below 2^63
  };
  const std::int64_t ab = cross(a, b);
  const bool from_a = cross(a, d) >= 0;
  const bool to_b = cross(d, b) >= 0;
  if (ab > 0) return from_a && to_b;
  if (ab < 0) return from_a || to_b;
  const bool opposite = a.x * b.x + a.y * b.y < 0;
  return !opposite || from_a;
}

/// The extreme points of the circle that the arc passes.
void add_arc(const Place& from, const Arc& arc, std::int64_t margin,
             Bounds& bounds) {
  const Place centre = from + arc.centre;
  Place a{-arc.centre.x, -arc.centre.y};
  Place b{std::int64_t{arc.end.x} - arc.centre.x,
          std::int64_t{arc.end.y} - arc.centre.y};
  const std::int64_t r =
      root_up(std::max(a.x * a.x + a.y * a.y, b.x * b.x + b.y * b.y));
  const bool x_to_y = !arc.clockwise;
  if (!x_to_y) std::swap(a, b);
  constexpr std::array<Point, 4> kAxes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (const Point& d : kAxes) {
    if (!sweeps(a, b, {d.x, d.y})) continue;
    bounds.add({centre.x + d.x * r, centre.y + d.y * r}, margin);
  }
}

class PathWalk {
 public:
  PathWalk(const Path& path, std::size_t number, const PathSpace& space)
      : path_(path),
        number_(number),
        space_(space),
        margin_(space.paint == Paint::stroke ? (path.width + 1) / 2 : 0) {}

  Status run(Bounds& bounds) {
    at_ = {path_.origin.x, path_.origin.y};
    if (!in_range(at_)) return bad("origin is out of range");
    if (path_.width < 0 || path_.width > kMaxCoord) {
      return bad("width is out of range");
    }
    bounds.add(at_, margin_);
    for (std::size_t i = 0; i < path_.elements.size(); ++i) {
      if (Status valid = step(path_.elements[i], i, bounds); !valid) {
        return valid;
      }
      bounds.add(at_, margin_);
    }
    if (path_.closed && at_ != Place{path_.origin.x, path_.origin.y}) {
      return bad("closed path does not return to its origin");
    }
    return {};
  }

 private:
  Status step(const Path::Element& element, std::size_t i, Bounds& bounds) {
    const std::string where = "element " + std::to_string(i + 1);
    if (element.kind == Path::Kind::segment) {
      at_ = at_ + Point{element.segment.dx, element.segment.dy};
      if (!in_range(at_)) return bad(where + " leaves the range");
      return {};
    }
    if (element.kind != Path::Kind::arc) return bad(where + " has no kind");
    const Arc& arc = element.arc;
    if (arc.centre == Point{}) return bad(where + " is an arc without radius");
    const Place to = at_ + arc.end;
    if (!in_range(to) || !in_range(at_ + arc.centre)) {
      return bad(where + " leaves the range");
    }
    add_arc(at_, arc, margin_, bounds);
    at_ = to;
    return {};
  }

  [[nodiscard]] Error bad(const std::string& reason) const {
    return Error{ErrorCode::invalid_argument,
                 "path " + std::to_string(number_ + 1) + ": " + reason};
  }

  const Path& path_;
  std::size_t number_;
  const PathSpace& space_;
  std::int64_t margin_;
  Place at_;
};

/// In grid units, rounded outwards; never beyond the range.
Box box_of(const Bounds& bounds, std::int64_t scale) {
  const auto down = [&](std::int64_t v) {
    const std::int64_t q = v >= 0 ? v / scale : -((-v + scale - 1) / scale);
    return std::clamp<std::int64_t>(q, -kMaxCoord, kMaxCoord);
  };
  const auto up = [&](std::int64_t v) { return -down(-v); };
  const std::int64_t x = down(bounds.low.x);
  const std::int64_t y = down(bounds.low.y);
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
          static_cast<std::uint32_t>(up(bounds.high.x) - x),
          static_cast<std::uint32_t>(up(bounds.high.y) - y)};
}

void put_le(std::uint8_t*& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    *out++ = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

void put_point(std::uint8_t*& out, const Point& p) {
  put_le(out, static_cast<std::uint32_t>(p.x), 4);
  put_le(out, static_cast<std::uint32_t>(p.y), 4);
}

}  // namespace

std::uint32_t crc_paths(std::span<const Path> paths) {
  std::uint32_t crc = 0;
  for (const Path& path : paths) {
    std::array<std::uint8_t, 21> head{};
    std::uint8_t* out = head.data();
    put_point(out, path.origin);
    put_le(out, path.closed ? 1 : 0, 1);
    put_le(out, static_cast<std::uint32_t>(path.width), 4);
    put_le(out, path.elements.size(), 8);
    crc = crc_bytes(head, crc);
    for (const Path::Element& element : path.elements) {
      std::array<std::uint8_t, 17> bytes{};
      out = bytes.data();
      const bool arc = element.kind == Path::Kind::arc;
      put_le(out, !arc ? 0 : element.arc.clockwise ? 2 : 1, 1);
      put_point(out, arc ? element.arc.end
                         : Point{element.segment.dx, element.segment.dy});
      if (arc) put_point(out, element.arc.centre);
      crc = crc_bytes(bytes, crc);
    }
  }
  return crc;
}

Result<PathSurvey> survey_paths(std::span<const Path> paths,
                                const PathSpace& space) {
  PathSurvey survey;
  Bounds bounds;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (Status valid = PathWalk(paths[i], i, space).run(bounds); !valid) {
      return valid.error();
    }
    survey.elements += paths[i].elements.size();
  }
  if (!paths.empty()) survey.box = box_of(bounds, space.scale);
  return survey;
}

bool same_paths(std::span<const Path> a, std::span<const Path> b) {
  const auto same_element = [](const Path::Element& p, const Path::Element& q) {
    if (p.kind != q.kind) return false;
    return p.kind == Path::Kind::arc ? p.arc == q.arc : p.segment == q.segment;
  };
  return std::ranges::equal(a, b, [&](const Path& p, const Path& q) {
    return p.origin == q.origin && p.closed == q.closed && p.width == q.width &&
           std::ranges::equal(p.elements, q.elements, same_element);
  });
}

}  // namespace unstep::codec
