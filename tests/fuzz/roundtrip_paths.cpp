#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/path_checksum.h"
#include "fuzz/target.h"

/// Any paths come back: 1 byte of options, then paths: kind, origin (2 bytes),
/// number of elements, elements: kind, end and, of an arc, centre (2 bytes
/// each).
namespace unstep::fuzz {
namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool left() const { return at_ < bytes_.size(); }
  std::uint8_t next() { return left() ? bytes_[at_++] : std::uint8_t{0}; }

  /// Mostly small, some large.
  std::int32_t number() {
    const auto v = static_cast<std::int8_t>(next());
    return v == -128 ? -8'000'000 : v > 120 ? v * 60'000 : v;
  }
  Point point() {
    const std::int32_t x = number();
    return {x, number()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Path path_of(Bytes& in) {
  Path path;
  const std::uint8_t kind = in.next();
  path.closed = (kind & 1) != 0;
  path.width = kind / 16;
  path.origin = in.point();
  Point at;
  for (int left = in.next() % 64; left > 0 && in.left(); --left) {
    const std::uint8_t element = in.next();
    Point end = in.point();
    if (path.closed && (left == 1 || !in.left())) end = {-at.x, -at.y};
    at = {at.x + end.x, at.y + end.y};
    if (element % 4 == 0) {
      Point centre = in.point();
      if (centre == Point{}) centre.x = 1;
      path.elements.push_back(
          {Path::Kind::arc, {}, {centre, end, element % 8 == 0}});
    } else {
      path.elements.push_back({Path::Kind::segment, {end.x, end.y}, {}});
    }
  }
  // Whatever ended the loop, a closed path comes home.
  if (path.closed && at != Point{}) {
    path.elements.push_back({Path::Kind::segment, {-at.x, -at.y}, {}});
  }
  return path;
}

void round_trip(std::uint8_t choice, Bytes in) {
  Drawing drawing;
  drawing.canvas.y_axis = (choice & 1) != 0 ? YAxis::up : YAxis::down;
  drawing.scale = 1 + choice / 16;
  drawing.paint = (choice & 2) != 0 ? Paint::stroke : Paint::fill;
  const Fidelity fidelity{Fidelity::Kind::tolerance, {choice, 4}};
  while (in.left()) drawing.paths.push_back(path_of(in));
  const bool valid = bool{codec::survey_paths(drawing.paths, {})};

  UstpWriter writer{EncodeOptions{}};
  const Status added = writer.add_page(drawing, {}, fidelity);
  require(bool{added} == valid, "valid paths, and only they, can be encoded");
  if (!added) return require_sound(added.error());
  const auto file = writer.finish();
  require(bool{file}, "any page makes a file");
  const auto reader = UstpReader::open(*file, {});
  require(bool{reader}, "an encoded file can be opened");
  const auto page = reader->read_page(0);
  require(bool{page}, "an encoded page can be decoded");
  require(page->drawing == drawing, "decoded paths are the encoded ones");
  require(page->fidelity == fidelity, "the fidelity is kept");
}

}  // namespace
}  // namespace unstep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size < 2 || size > 2048) return 0;
  const std::span<const std::uint8_t> input(data, size);
  unstep::fuzz::round_trip(input[0], unstep::fuzz::Bytes(input.subspan(1)));
  return 0;
}
