#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "formats/decimal.h"
#include "formats/deflater.h"
#include "formats/outline_writer.h"
#include "formats/resolution.h"
#include "formats/text.h"

/// PDF 1.4, docs/vectors.md. Objects: 1 the catalogue, 2 the page tree, 3 the
/// document's information, then three for each page.
namespace unstep {
namespace {

constexpr double kPointsPerInch = 72;
constexpr double kLongestSide = 14400;  ///< points, of PDF 1.4 viewers

/// How far a cubic Bezier of the usual kind is from an arc of radius 1 and
/// `angle` at most (M. Goldapp, Approximation of circular arcs by cubic
/// polynomials, 1991: 2/27 sin^6(angle/4) / cos^2(angle/4)).
double bezier_error(double angle) {
  const double s = std::sin(angle / 4);
  const double c = std::cos(angle / 4);
  return 2.0 / 27 * s * s * s * s * s * s / (c * c);
}

class PdfWriter : public OutlineWriter {
 public:
  explicit PdfWriter(VectorOutput& output)
      : OutlineWriter(YAxis::up), output_(output) {}

  Status begin(const PageHead& head) override;
  Status draw(const Outline& outline) override;
  Status end_page() override;
  Status finish() override;

 private:
  void begin_object(std::size_t number);
  void write_page(const PageHead& head);
  void write_title();
  void write_table();
  void append_point(std::string& text, double x, double y) const;
  void append_path(std::string& text, const Outline& outline) const;
  void append_arc(std::string& text, WidePoint from, const Piece& arc) const;
  void set_pen(std::string& text, std::int64_t width) const;

  VectorOutput& output_;
  std::vector<std::uint64_t> offsets_;  ///< of the objects, from number 1
  std::size_t pages_ = 0;
  std::string title_;
  Paint paint_ = Paint::fill;
  std::int32_t scale_ = 1;
  std::uint64_t stream_begin_ = 0;
  Deflater deflater_;
  std::string plain_;    ///< of the stream, not compressed yet
  bool filled_ = false;  ///< a filled path has begun
  std::string strokes_;  ///< open paths of a filled page, after the fill
  std::int64_t pen_ = -1;
  std::int64_t strokes_pen_ = -1;
};

void PdfWriter::begin_object(std::size_t number) {
  if (offsets_.size() < number) offsets_.resize(number);
  offsets_[number - 1] = output_.size();
  append_integer(output_.text, static_cast<std::int64_t>(number));
  output_.text += " 0 obj\n";
}

Status PdfWriter::begin(const PageHead& head) {
  if (pages_ == 0) {
    // Four bytes above 127 tell programs that this is no text.
    output_.text += "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";
    begin_object(1);
    output_.text += "<</Type/Catalog/Pages 2 0 R>>\nendobj\n";
    offsets_.resize(3);
    title_ = head.info.name;
  } else if (!head.info.name.empty()) {
    output_.note("PDF has the name of the first page only");
  }
  if (!head.info.metadata.empty()) output_.note("metadata is not in the PDF");
  ++pages_;
  paint_ = head.paint;
  scale_ = head.scale;
  filled_ = false;
  pen_ = -1;
  strokes_pen_ = -1;
  strokes_.clear();
  plain_.clear();
  write_page(head);
  return {};
}

void PdfWriter::write_page(const PageHead& head) {
  GridUnit unit;
  if (is_usable(head.info.resolution)) {
    const auto known = grid_unit(head.info.resolution, kPointsPerInch);
    if (known) {
      unit = *known;
    } else {  // only the ratio is known
      unit.y = static_cast<double>(head.info.resolution.x.numerator) /
               head.info.resolution.x.denominator *
               head.info.resolution.y.denominator /
               head.info.resolution.y.numerator;
      output_.note("no resolution: 72 grid units per inch");
    }
  } else {
    output_.note("no resolution: 72 grid units per inch");
  }
  WideBox box;
  if (head.box) {
    box = *head.box;
  } else {
    box.high = {std::int64_t{612} * scale_, std::int64_t{792} * scale_};
    output_.note("the canvas has no size: the page is 612 x 792 units");
  }
  unit.x /= scale_;
  unit.y /= scale_;
  const WidePoint size = box.high - box.low;
  const double width = static_cast<double>(size.x) * unit.x;
  const double height = static_cast<double>(size.y) * unit.y;
  if (std::max(width, height) > kLongestSide) {
    output_.note("a page of more than 200 inches, too large for some viewers");
  }
  const auto number = static_cast<std::int64_t>(offsets_.size()) + 1;
  begin_object(static_cast<std::size_t>(number));
  std::string& text = output_.text;
  text += "<</Type/Page/Parent 2 0 R/Resources<<>>/MediaBox[0 0 ";
  append_real(text, width, 9);
  text += ' ';
  append_real(text, height, 9);
  text += "]/Contents ";
  append_integer(text, number + 1);
  text += " 0 R>>\nendobj\n";
  begin_object(static_cast<std::size_t>(number) + 1);
  text += "<</Filter/FlateDecode/Length ";
  append_integer(text, number + 2);
  text += " 0 R>>stream\n";
  stream_begin_ = output_.size();

  append_real(plain_, unit.x, 12);
  plain_ += " 0 0 ";
  append_real(plain_, unit.y, 12);
  plain_ += ' ';
  append_real(plain_, -static_cast<double>(box.low.x) * unit.x, 12);
  plain_ += ' ';
  append_real(plain_, -static_cast<double>(box.low.y) * unit.y, 12);
  plain_ += " cm 1 J 1 j\n";
}

void PdfWriter::append_point(std::string& text, double x, double y) const {
  for (const double value : {x, y}) {
    append_decimal(text, std::llround(value * 1e4), 4, true);
    text += ' ';
  }
}

/// `arc` as so many Beziers that they stay within the limit.
void PdfWriter::append_arc(std::string& text, WidePoint from,
                           const Piece& arc) const {
  const double sweep = sweep_of(arc);
  const RealCircle circle = circle_of(arc);
  const double limit = kArcLimit * scale_;
  int count = 1 + static_cast<int>(sweep / 1.6);
  while (count < 1000 && circle.radius * bezier_error(sweep / count) > limit) {
    ++count;
  }
  const double turn = (arc.ascending ? sweep : -sweep) / count;
  const double handle = 4.0 / 3 * std::tan(turn / 4);
  const double cx = static_cast<double>(from.x) + circle.x;
  const double cy = static_cast<double>(from.y) + circle.y;
  const double begin = std::atan2(-circle.y, -circle.x);
  const WidePoint end = from + arc.end;
  for (int i = 0; i < count; ++i) {
    const double a = begin + turn * i;
    const double b = begin + turn * (i + 1);
    const double ax = circle.radius * std::cos(a);
    const double ay = circle.radius * std::sin(a);
    const double bx = circle.radius * std::cos(b);
    const double by = circle.radius * std::sin(b);
    append_point(text, cx + ax - handle * ay, cy + ay + handle * ax);
    append_point(text, cx + bx + handle * by, cy + by - handle * bx);
    if (i + 1 < count) {
      append_point(text, cx + bx, cy + by);
    } else {
      append_point(text, static_cast<double>(end.x),
                   static_cast<double>(end.y));
    }
    text += "c\n";
  }
}

void PdfWriter::append_path(std::string& text, const Outline& outline) const {
  const auto point = [&text](WidePoint at, char operation) {
    append_integer(text, at.x);
    text += ' ';
    append_integer(text, at.y);
    text += ' ';
    text += operation;
    text += '\n';
  };
  WidePoint at = outline.origin;
  point(at, 'm');
  for (const Piece& piece : outline.pieces) {
    if (piece.is_arc) append_arc(text, at, piece);
    at = at + piece.end;
    if (!piece.is_arc) point(at, 'l');
  }
  // A point is drawn only as a line without length.
  if (outline.pieces.empty()) point(at, 'l');
  if (outline.closed) text += "h\n";
}

void PdfWriter::set_pen(std::string& text, std::int64_t width) const {
  append_integer(text, width);
  text += " w\n";
}

Status PdfWriter::draw(const Outline& outline) {
  if (paint_ == Paint::fill && outline.closed) {
    filled_ = true;
    append_path(plain_, outline);
  } else if (paint_ == Paint::fill) {
    output_.note("open paths of a filled drawing are written as strokes");
    if (strokes_pen_ != outline.width) set_pen(strokes_, outline.width);
    strokes_pen_ = outline.width;
    append_path(strokes_, outline);
    strokes_ += "S\n";
  } else {
    if (pen_ != outline.width) set_pen(plain_, outline.width);
    pen_ = outline.width;
    append_path(plain_, outline);
    plain_ += "S\n";
  }
  if (plain_.size() < (std::size_t{1} << 16)) return {};
  Status added = deflater_.add(plain_, output_.text);
  plain_.clear();
  return added;
}

Status PdfWriter::end_page() {
  if (filled_) plain_ += "f*\n";
  plain_ += strokes_;
  strokes_.clear();
  Status done = deflater_.add(plain_, output_.text);
  if (done) done = deflater_.finish(output_.text);
  if (!done) return done;
  const std::uint64_t length = output_.size() - stream_begin_;
  output_.text += "\nendstream\nendobj\n";
  begin_object(offsets_.size() + 1);
  append_integer(output_.text, static_cast<std::int64_t>(length));
  output_.text += "\nendobj\n";
  return {};
}

/// UTF-16 with its byte order mark, as hexadecimal digits.
void PdfWriter::write_title() {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string& text = output_.text;
  const auto unit = [&text](std::uint32_t value) {
    for (int shift = 12; shift >= 0; shift -= 4) {
      text += kHex[value >> shift & 15];
    }
  };
  text += "/Title<FEFF";
  for (const std::uint32_t c : code_points(to_utf8(title_))) {
    if (c < 0x10000) {
      unit(c);
    } else {
      unit(0xd800 + ((c - 0x10000) >> 10));
      unit(0xdc00 + ((c - 0x10000) & 0x3ff));
    }
  }
  text += '>';
}

void PdfWriter::write_table() {
  std::string& text = output_.text;
  const std::uint64_t table = output_.size();
  const auto count = static_cast<std::int64_t>(offsets_.size()) + 1;
  text += "xref\n0 ";
  append_integer(text, count);
  text += "\n0000000000 65535 f \n";
  for (const std::uint64_t offset : offsets_) {
    const std::string digits = std::to_string(offset);
    text.append(10 - std::min<std::size_t>(10, digits.size()), '0');
    text += digits + " 00000 n \n";
  }
  text += "trailer\n<</Size ";
  append_integer(text, count);
  text += "/Root 1 0 R/Info 3 0 R>>\nstartxref\n";
  append_integer(text, static_cast<std::int64_t>(table));
  text += "\n%%EOF\n";
}

Status PdfWriter::finish() {
  if (pages_ == 0) {
    return Error{ErrorCode::invalid_argument, "a PDF file has a page"};
  }
  begin_object(2);
  std::string& text = output_.text;
  text += "<</Type/Pages/Count ";
  append_integer(text, static_cast<std::int64_t>(pages_));
  text += "/Kids[";
  for (std::size_t page = 0; page < pages_; ++page) {
    if (page != 0) text += ' ';
    append_integer(text, static_cast<std::int64_t>(4 + 3 * page));
    text += " 0 R";
  }
  text += "]>>\nendobj\n";
  begin_object(3);
  text += "<<";
  if (!title_.empty()) write_title();
  text += ">>\nendobj\n";
  if (output_.size() >= 10'000'000'000) {
    return Error{ErrorCode::limit_exceeded, "a PDF of more than 10 GB"};
  }
  write_table();
  return {};
}

}  // namespace

std::unique_ptr<FormatWriter> make_pdf_writer(VectorOutput& output) {
  return std::make_unique<PdfWriter>(output);
}

}  // namespace unstep
