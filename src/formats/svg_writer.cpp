#include <memory>
#include <optional>
#include <string>

#include "formats/decimal.h"
#include "formats/outline_writer.h"
#include "formats/resolution.h"
#include "formats/svg_path_data.h"
#include "formats/xml_text.h"

/// SVG 1.1, docs/vectors.md.
namespace unstep {
namespace {

/// libxml2, and so librsvg, refuses a longer attribute unless told otherwise.
constexpr std::uint64_t kLongAttribute = 10'000'000;

const char* unit_of(Resolution::Unit unit) {
  switch (unit) {
    case Resolution::Unit::inch: return "in";
    case Resolution::Unit::centimetre: return "cm";
    case Resolution::Unit::metre: return "mm";
    case Resolution::Unit::none: break;
  }
  return "";
}

double value(const Rational& rational) {
  return static_cast<double>(rational.numerator) / rational.denominator;
}

class SvgWriter : public OutlineWriter {
 public:
  explicit SvgWriter(VectorOutput& output)
      : OutlineWriter(YAxis::down), output_(output) {}

  Status begin(const PageHead& head) override;
  Status draw(const Outline& outline) override;
  Status end_page() override;
  Status finish() override;

 private:
  void write_size(const PageHead& head);
  void write_names(const PageInfo& info);
  void append_transform(std::string& text) const;
  void append_fill_tag(std::string& text) const;
  void append_stroke_tag(std::string& text, std::int64_t width) const;
  void close_path();
  void add_open_path(const Outline& outline);

  VectorOutput& output_;
  int decimals_ = 0;
  std::int32_t scale_ = 1;
  bool transformed_ = false;  ///< path units are not user units
  Paint paint_ = Paint::fill;
  bool had_page_ = false;
  std::optional<SvgPathData> data_;
  bool open_ = false;       ///< a path element is
  std::int64_t width_ = 0;  ///< of its pen
  std::uint64_t opened_at_ = 0;
  /// Open paths of a filled page wait here: the fill is one element.
  std::string strokes_;
  std::optional<SvgPathData> stroke_data_;
  std::int64_t stroke_width_ = 0;
};

Status SvgWriter::begin(const PageHead& head) {
  if (had_page_) {
    return Error{ErrorCode::invalid_argument,
                 "SVG has one page; write a file for each"};
  }
  had_page_ = true;
  scale_ = head.scale;
  paint_ = head.paint;
  const int power = power_of_ten(head.scale);
  decimals_ = power < 0 ? 0 : power;
  transformed_ = power < 0;
  data_.emplace(decimals_, kArcLimit * head.scale);
  stroke_data_.emplace(decimals_, kArcLimit * head.scale);
  output_.text += "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  write_size(head);
  output_.text += '>';
  write_names(head.info);
  return {};
}

void SvgWriter::write_size(const PageHead& head) {
  std::string& text = output_.text;
  if (!head.box) {
    output_.note("the canvas has no size: neither has the SVG");
    return;
  }
  const WidePoint size = head.box->high - head.box->low;
  const double width = static_cast<double>(size.x) / head.scale;
  const double height = static_cast<double>(size.y) / head.scale;
  const Resolution& resolution = head.info.resolution;
  if (is_usable(resolution)) {
    const double x = value(resolution.x);
    const double y = value(resolution.y);
    const bool square = x == y;
    // Millimetres stand for the metre.
    const double per = resolution.unit == Resolution::Unit::metre ? 1000 : 1;
    const bool physical = resolution.unit != Resolution::Unit::none;
    if (physical || !square) {
      const char* unit = unit_of(resolution.unit);
      text += " width=\"";
      append_real(text, physical ? width * per / x : width, 9);
      text += unit;
      text += "\" height=\"";
      append_real(text, physical ? height * per / y : height * x / y, 9);
      text += unit;
      text += '"';
    }
    if (!square) text += " preserveAspectRatio=\"none\"";
  }
  text += " viewBox=\"";
  append_ratio(text, head.box->low.x, head.scale);
  text += ' ';
  append_ratio(text, head.box->low.y, head.scale);
  text += ' ';
  append_ratio(text, size.x, head.scale);
  text += ' ';
  append_ratio(text, size.y, head.scale);
  text += '"';
}

void SvgWriter::write_names(const PageInfo& info) {
  std::string& text = output_.text;
  bool complete = true;
  if (!info.name.empty()) {
    text += "<title>";
    complete = append_xml(text, info.name);
    text += "</title>";
  }
  if (!info.metadata.empty()) {
    text += "<metadata xmlns:u=\"urn:unstep\">";
    for (const auto& [key, words] : info.metadata) {
      text += "<u:entry key=\"";
      complete = append_xml(text, key) && complete;
      text += "\">";
      complete = append_xml(text, words) && complete;
      text += "</u:entry>";
    }
    text += "</metadata>";
  }
  if (!complete) {
    output_.note("control characters of names and metadata are left out");
  }
}

void SvgWriter::append_transform(std::string& text) const {
  if (!transformed_) return;
  text += " transform=\"scale(";
  append_shortest(text, 1.0 / scale_);
  text += ")\"";
}

void SvgWriter::append_fill_tag(std::string& text) const {
  text += "<path fill-rule=\"evenodd\"";
  append_transform(text);
  text += " d=\"";
}

void SvgWriter::append_stroke_tag(std::string& text, std::int64_t width) const {
  text +=
      "<path fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\"";
  if (width == 0) {
    text += " vector-effect=\"non-scaling-stroke\"";
  } else {
    text += " stroke-width=\"";
    append_decimal(text, width, decimals_, true);
    text += '"';
  }
  append_transform(text);
  text += " d=\"";
}

void SvgWriter::close_path() {
  if (!open_) return;
  if (output_.size() - opened_at_ > kLongAttribute) {
    output_.note(
        "a path of more than 10 MB: programs that use libxml2 need their "
        "option for huge files (rsvg-convert --unlimited)");
  }
  output_.text += "\"/>";
  open_ = false;
}

void SvgWriter::add_open_path(const Outline& outline) {
  output_.note("open paths of a filled drawing are written as strokes");
  if (strokes_.empty() || outline.width != stroke_width_) {
    if (!strokes_.empty()) strokes_ += "\"/>";
    append_stroke_tag(strokes_, outline.width);
    stroke_width_ = outline.width;
    stroke_data_->restart();
  }
  stroke_data_->add(outline, strokes_);
}

Status SvgWriter::draw(const Outline& outline) {
  const bool fill = paint_ == Paint::fill;
  if (fill && !outline.closed) {
    add_open_path(outline);
    return {};
  }
  if (!open_ || (!fill && width_ != outline.width)) {
    close_path();
    if (fill) {
      append_fill_tag(output_.text);
    } else {
      append_stroke_tag(output_.text, outline.width);
    }
    opened_at_ = output_.size();
    open_ = true;
    width_ = outline.width;
    data_->restart();
  }
  data_->add(outline, output_.text);
  return {};
}

Status SvgWriter::end_page() {
  close_path();
  if (!strokes_.empty()) output_.text += strokes_ + "\"/>";
  strokes_.clear();
  output_.text += "</svg>\n";
  return {};
}

Status SvgWriter::finish() {
  if (!had_page_) {
    return Error{ErrorCode::invalid_argument, "an SVG file has a page"};
  }
  return {};
}

}  // namespace

std::unique_ptr<FormatWriter> make_svg_writer(VectorOutput& output) {
  return std::make_unique<SvgWriter>(output);
}

}  // namespace unstep
