#include "codec/container_fields_decoder.h"

#include <limits>
#include <string>

#include "codec/checksum.h"
#include "codec/metadata_decoder.h"
#include "codec/path_checksum.h"
#include "codec/text_rules.h"

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

Resolution read_resolution(std::uint8_t details, ByteReader& in) {
  const std::uint64_t start = in.position() - 1;
  Resolution resolution;
  resolution.unit = static_cast<Resolution::Unit>(details & kUnitMask);
  resolution.x = read_rational(in);
  const bool same = (details & kSameBothWaysFlag) != 0;
  resolution.y = same ? resolution.x : read_rational(in);
  if (!same && resolution.x == resolution.y) {
    in.fail(ErrorCode::corrupt, start, "equal resolutions are given twice");
  }
  if (resolution == Resolution{}) {
    in.fail(ErrorCode::corrupt, start, "resolution that says nothing");
  }
  return resolution;
}

std::string read_name(ByteReader& in) {
  const std::uint64_t start = in.position();
  const std::uint64_t size =
      in.varint("the length of the page's name", kMaxNameBytes);
  const auto bytes = in.bytes("the page's name", size);
  std::string name(bytes.begin(), bytes.end());
  if (!is_text(name)) {
    in.fail(ErrorCode::corrupt, start, "page name is not UTF-8 text");
  }
  return name;
}

void read_details(ByteReader& in, MetadataSink metadata, PageEntry& page) {
  const std::uint64_t start = in.position();
  const std::uint8_t details = in.u8("the page's details");
  const bool resolution = (details & kResolutionFlag) != 0;
  const unsigned known = kResolutionFlag | kTextsFlag |
                         (resolution ? kUnitMask | kSameBothWaysFlag : 0U) |
                         (metadata.of_file != nullptr ? kFileMetadataFlag : 0U);
  if ((details & ~known) != 0 || details == 0) {
    in.fail(ErrorCode::corrupt, start, "unknown details of a page");
    return;
  }
  if (resolution) page.info.resolution = read_resolution(details, in);
  if ((details & kTextsFlag) != 0) {
    page.info.name = read_name(in);
    page.info.metadata = read_metadata(in, metadata.budget);
    if (page.info.name.empty() && page.info.metadata.empty()) {
      in.fail(ErrorCode::corrupt, start, "texts of a page that has none");
    }
  }
  if ((details & kFileMetadataFlag) != 0) {
    *metadata.of_file = read_metadata(in, metadata.budget);
    if (metadata.of_file->empty()) {
      in.fail(ErrorCode::corrupt, start, "metadata of a file that has none");
    }
  }
}

void read_canvas(std::uint8_t flags, ByteReader& in, PageEntry& page) {
  const std::uint64_t start = in.position();
  const bool square = (flags & kSquareFlag) != 0;
  Canvas& canvas = page.canvas;
  canvas.width = static_cast<std::int32_t>(in.varint("the width", kMaxCoord));
  canvas.height =
      square ? canvas.width
             : static_cast<std::int32_t>(in.varint("the height", kMaxCoord));
  if (!square && canvas.width == canvas.height) {
    in.fail(ErrorCode::corrupt, start, "equal sides are given twice");
  }
  const bool ink = page.kind == PageKind::ink;
  const bool empty = canvas.width == 0 || canvas.height == 0;
  if (empty && (ink || canvas.width != canvas.height)) {
    in.fail(ErrorCode::corrupt, start, "canvas with a side of 0");
  }
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

/// A whole head of strokes in one byte.
HeadCoder usual_strokes(PageEntry& page) {
  page.fidelity = kUsualFidelity;
  page.paint = Paint::stroke;
  page.scale = kUsualStrokeScale;
  return HeadCoder::strokes;
}

/// `may_be_usual`: it may say more of the coder than that it is named.
HeadCoder read_path_head(ByteReader& in, bool may_be_usual, PageEntry& page) {
  const std::uint64_t start = in.position();
  const std::uint8_t flags = in.u8("the head of the paths");
  if (may_be_usual && flags == kUsualStrokes) return usual_strokes(page);
  const unsigned kind = flags & kFidelityMask;
  if (kind > static_cast<unsigned>(Fidelity::Kind::device)) {
    in.fail(ErrorCode::unsupported_version, start, "unknown fidelity");
    return HeadCoder::named;
  }
  page.fidelity.kind = static_cast<Fidelity::Kind>(kind);
  const bool tolerance = page.fidelity.kind == Fidelity::Kind::tolerance;
  const bool whole = (flags & kDenominatorFlag) == 0;
  const bool program = (flags & kProgramFlag) != 0;
  if (program) page.kind = PageKind::program;
  const HeadCoder coder =
      (flags & kUsualPathCoderFlag) != 0 ? HeadCoder::usual : HeadCoder::named;
  const unsigned known = (program ? kProgramHeadMask : kPathHeadMask) |
                         (may_be_usual ? kUsualPathCoderFlag : 0U);
  if ((flags & ~known) != 0 ||
      (program &&
       (kind == static_cast<unsigned>(Fidelity::Kind::device) ||
        page.canvas.width != 0 || page.info.resolution != Resolution{})) ||
      (!tolerance && !whole)) {
    in.fail(ErrorCode::corrupt, start, "unknown flags of paths");
  }
  if ((flags & kPathsUpFlag) != 0) page.canvas.y_axis = YAxis::up;
  if ((flags & kStrokeFlag) != 0) page.paint = Paint::stroke;
  if (tolerance) page.fidelity.tolerance = read_tolerance(in, whole);
  if (flags == (kUsualPathHead | kUsualPathCoderFlag) &&
      page.fidelity == kUsualFidelity) {
    in.fail(ErrorCode::corrupt, start, "the usual head of paths is given");
  }
  if ((flags & kScaleFlag) == 0) return coder;
  const std::uint64_t scale_start = in.position();
  page.scale =
      static_cast<std::int32_t>(in.varint("the scale", Drawing::kMaxScale));
  if (page.scale < 2) {
    in.fail(ErrorCode::corrupt, scale_start, "scale below 2");
  }
  return coder;
}

/// Whether the one byte of usual_strokes() says all of a page.
bool has_usual_strokes(const PageEntry& page) {
  return page.kind == PageKind::paths && page.fidelity == kUsualFidelity &&
         page.paint == Paint::stroke && page.scale == kUsualStrokeScale &&
         page.canvas.y_axis == YAxis::down;
}

}  // namespace

HeadCoder read_page_head(std::uint8_t flags, ByteReader& in,
                         MetadataSink metadata, PageEntry& page) {
  const unsigned kind = flags & kKindMask;
  page.kind = kind == kInkKind     ? PageKind::ink
              : kind == kPathsKind ? PageKind::paths
                                   : PageKind::chains;
  if (kind == kChainsUpKind) page.canvas.y_axis = YAxis::up;
  read_canvas(flags, in, page);
  if ((flags & kDetailsFlag) != 0) read_details(in, metadata, page);
  const bool usual = (flags & kUsualFlag) != 0;
  if (page.kind != PageKind::paths) {
    return usual ? HeadCoder::usual : HeadCoder::named;
  }
  if (!usual) return read_path_head(in, metadata.of_file != nullptr, page);
  page.fidelity = kUsualFidelity;
  return HeadCoder::usual;
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

void read_short_coder_name(HeadCoder said, ByteReader& in,
                           const PageEntry& page, PageEntry::Block& block) {
  const CoderName usual = usual_coder(page.kind);
  if (said != HeadCoder::named) {
    const CoderName& name =
        said == HeadCoder::usual ? usual : kUsualStrokeCoder;
    block.coder = name.coder;
    block.revision = name.revision;
    block.table = name.table;
    return;
  }
  const std::uint64_t start = in.position();
  read_coder_name(in, block);
  const CoderName name{block.coder, block.revision, block.table};
  if (name == usual || (name == kUsualStrokeCoder && has_usual_strokes(page))) {
    in.fail(ErrorCode::corrupt, start, "the usual coder is named");
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
