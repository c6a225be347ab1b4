#include "codec/container_fields_decoder.h"

#include <limits>

#include "codec/checksum.h"
#include "codec/path_checksum.h"

namespace unstep::codec {
namespace {

constexpr std::uint64_t kMaxU32 = std::numeric_limits<std::uint32_t>::max();

/// chain_bytes and path_bytes of two such counts stay below 2^54, and their
/// sums over the blocks of any file that fits memory below 2^63.
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 48;

Rational read_rational(ByteReader& in) {
  Rational value;
  value.numerator =
      static_cast<std::uint32_t>(in.varint("a resolution", kMaxU32));
  const std::uint64_t start = in.position();
  value.denominator =
      static_cast<std::uint32_t>(in.varint("a resolution", kMaxU32));
  if (value.denominator == 0) {
    in.fail(ErrorCode::corrupt, start, "resolution with denominator 0");
  }
  return value;
}

Resolution read_resolution(ByteReader& in) {
  const std::uint64_t start = in.position();
  const std::uint8_t head = in.u8("the resolution's unit");
  if (head > 7) {
    in.fail(ErrorCode::corrupt, start, "unknown unit of resolution");
  }
  Resolution resolution;
  resolution.unit = static_cast<Resolution::Unit>(head & 3);
  resolution.x = read_rational(in);
  const bool square = (head & 4) != 0;
  resolution.y = square ? resolution.x : read_rational(in);
  if (!square && resolution.x == resolution.y) {
    in.fail(ErrorCode::corrupt, start, "equal resolutions are given twice");
  }
  if (resolution == Resolution{}) {
    in.fail(ErrorCode::corrupt, start, "resolution that says nothing");
  }
  return resolution;
}

Rational read_tolerance(ByteReader& in, bool whole) {
  Rational value;
  value.numerator =
      static_cast<std::uint32_t>(in.varint("the tolerance", kMaxU32));
  if (whole) return value;
  const std::uint64_t start = in.position();
  value.denominator =
      static_cast<std::uint32_t>(in.varint("the tolerance", kMaxU32));
  if (value.denominator < 2) {
    in.fail(ErrorCode::corrupt, start, "tolerance with denominator 0 or 1");
  }
  return value;
}

void read_path_head(ByteReader& in, PageEntry& page) {
  const std::uint64_t start = in.position();
  const std::uint8_t flags = in.u8("the head of the paths");
  const unsigned kind = flags & kFidelityMask;
  if (kind > static_cast<unsigned>(Fidelity::Kind::device)) {
    in.fail(ErrorCode::unsupported_version, start, "unknown fidelity");
    return;
  }
  page.fidelity.kind = static_cast<Fidelity::Kind>(kind);
  const bool tolerance = page.fidelity.kind == Fidelity::Kind::tolerance;
  const bool whole = (flags & kDenominatorFlag) == 0;
  const bool program = (flags & kProgramFlag) != 0;
  if (program) page.kind = PageKind::program;
  if ((flags & ~(program ? kProgramHeadMask : kPathHeadMask)) != 0 ||
      (program &&
       (kind == static_cast<unsigned>(Fidelity::Kind::device) ||
        page.canvas.width != 0 || page.info.resolution != Resolution{})) ||
      (!tolerance && !whole)) {
    in.fail(ErrorCode::corrupt, start, "unknown flags of paths");
  }
  if ((flags & kPathsUpFlag) != 0) page.canvas.y_axis = YAxis::up;
  if ((flags & kStrokeFlag) != 0) page.paint = Paint::stroke;
  if (tolerance) page.fidelity.tolerance = read_tolerance(in, whole);
  if ((flags & kScaleFlag) == 0) return;
  const std::uint64_t scale_start = in.position();
  page.scale =
      static_cast<std::int32_t>(in.varint("the scale", Drawing::kMaxScale));
  if (page.scale < 2) {
    in.fail(ErrorCode::corrupt, scale_start, "scale below 2");
  }
}

}  // namespace

void read_page_head(std::uint8_t flags, ByteReader& in, PageEntry& page) {
  const std::uint64_t start = in.position();
  const unsigned kind = flags & kKindMask;
  page.kind = kind == kInkKind     ? PageKind::ink
              : kind == kPathsKind ? PageKind::paths
                                   : PageKind::chains;
  if (kind == kChainsUpKind) page.canvas.y_axis = YAxis::up;
  page.canvas.width =
      static_cast<std::int32_t>(in.varint("the width", kMaxCoord));
  page.canvas.height =
      static_cast<std::int32_t>(in.varint("the height", kMaxCoord));
  const bool ink = page.kind == PageKind::ink;
  const bool empty = page.canvas.width == 0 || page.canvas.height == 0;
  const bool unbounded = page.canvas.width == 0 && page.canvas.height == 0;
  if (ink ? empty : empty && !unbounded) {
    in.fail(ErrorCode::corrupt, start, "canvas with a side of 0");
  }
  if ((flags & kResolutionFlag) != 0) {
    page.info.resolution = read_resolution(in);
  }
  if (page.kind == PageKind::paths) read_path_head(in, page);
}

void read_coder_name(ByteReader& in, PageEntry::Block& block) {
  const std::uint64_t start = in.position();
  const std::uint8_t packed = in.u8("the coder's name");
  block.coder = packed & 31;
  block.revision = packed >> 5 & 3;
  block.table = packed >> 7;
  if (block.revision != 3) return;
  if (block.table != 0) {
    in.fail(ErrorCode::corrupt, start, "long coder name with bit 7 set");
  }
  block.revision = in.u8("the coder's revision");
  block.table = in.u8("the coder's table");
  if (block.revision <= 2 && block.table <= 1) {
    in.fail(ErrorCode::corrupt, start, "long coder name for a short one");
  }
}

std::uint64_t read_counts(ByteReader& in, PageKind kind,
                          PageEntry::Block& block) {
  if (kind == PageKind::chains) {
    block.chains = in.varint("the number of chains", kMaxCount);
    block.steps = in.varint("the number of steps", kMaxCount);
    return chain_bytes(block.chains, block.steps);
  }
  if (kind == PageKind::paths) {
    block.paths = in.varint("the number of paths", kMaxCount);
    block.elements = in.varint("the number of elements", kMaxCount);
    return path_bytes(block.paths, block.elements);
  }
  if (kind == PageKind::program) {
    block.lines = in.varint("the number of lines", kMaxCount);
    block.text_bytes = in.varint("the number of bytes", kMaxCount);
    return block.text_bytes;
  }
  return 0;
}

Box read_box(ByteReader& in) {
  Box box;
  box.x = in.coordinate("a bounding box");
  box.y = in.coordinate("a bounding box");
  box.width = static_cast<std::uint32_t>(in.varint("a bounding box", kMaxU32));
  box.height = static_cast<std::uint32_t>(in.varint("a bounding box", kMaxU32));
  return box;
}

}  // namespace unstep::codec
