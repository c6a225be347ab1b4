#include <array>
#include <memory>
#include <string>

#include "formats/decimal.h"
#include "formats/format_writer.h"
#include "formats/text.h"

/// unstep's own JSON, docs/vectors.md.
namespace unstep {
namespace {

void append_string(std::string& out, std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '"';
  for (const char c : to_utf8(text)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

void append_numbers(std::string& out,
                    std::initializer_list<std::int64_t> numbers) {
  bool first = true;
  for (const std::int64_t number : numbers) {
    if (!first) out += ',';
    first = false;
    append_integer(out, number);
  }
}

const char* name_of(Resolution::Unit unit) {
  constexpr std::array kNames{"none", "inch", "centimetre", "metre"};
  return kNames[static_cast<std::size_t>(unit)];
}

class JsonWriter : public FormatWriter {
 public:
  explicit JsonWriter(VectorOutput& output) : output_(output) {}

  Status begin_page(const PageHead& head) override;
  Status add(const Path& path) override;
  Status add(const Chain& chain) override;
  Status end_page() override {
    output_.text += "]}";
    return {};
  }
  Status finish() override {
    output_.text += pages_ == 0 ? "{\"unstep\":1,\"pages\":[]}\n" : "\n]}\n";
    return {};
  }

 private:
  void write_info(const PageInfo& info);
  void begin_shape(bool closed);

  VectorOutput& output_;
  std::uint64_t pages_ = 0;
  bool first_shape_ = true;
};

Status JsonWriter::begin_page(const PageHead& head) {
  std::string& text = output_.text;
  text += pages_++ == 0 ? "{\"unstep\":1,\"pages\":[\n" : ",\n";
  text += "{\"canvas\":[";
  append_numbers(text, {head.canvas.width, head.canvas.height});
  text +=
      head.canvas.y_axis == YAxis::up ? "],\"y\":\"up\"" : "],\"y\":\"down\"";
  text += ",\"scale\":";
  append_integer(text, head.scale);
  text += head.paint == Paint::fill ? ",\"paint\":\"fill\""
                                    : ",\"paint\":\"stroke\"";
  write_info(head.info);
  text += ",\"shapes\":[";
  first_shape_ = true;
  return {};
}

void JsonWriter::write_info(const PageInfo& info) {
  std::string& text = output_.text;
  if (!info.name.empty()) {
    text += ",\"name\":";
    append_string(text, info.name);
  }
  const Resolution& resolution = info.resolution;
  if (resolution.known()) {
    text += ",\"resolution\":{\"x\":[";
    append_numbers(text, {resolution.x.numerator, resolution.x.denominator});
    text += "],\"y\":[";
    append_numbers(text, {resolution.y.numerator, resolution.y.denominator});
    text += "],\"unit\":\"";
    text += name_of(resolution.unit);
    text += "\"}";
  }
  if (info.metadata.empty()) return;
  text += ",\"metadata\":[";
  bool first = true;
  for (const auto& [key, words] : info.metadata) {
    text += first ? "[" : ",[";
    first = false;
    append_string(text, key);
    text += ',';
    append_string(text, words);
    text += ']';
  }
  text += ']';
}

void JsonWriter::begin_shape(bool closed) {
  output_.text += first_shape_ ? "\n{" : ",\n{";
  first_shape_ = false;
  if (closed) output_.text += "\"closed\":true,";
}

Status JsonWriter::add(const Path& path) {
  begin_shape(path.closed);
  std::string& text = output_.text;
  if (path.width != 0) {
    text += "\"width\":";
    append_integer(text, path.width);
    text += ',';
  }
  text += "\"at\":[";
  append_numbers(text, {path.origin.x, path.origin.y});
  text += "],\"path\":[";
  bool first = true;
  for (const Path::Element& element : path.elements) {
    text += first ? "[" : ",[";
    first = false;
    if (element.kind == Path::Kind::segment) {
      append_numbers(text, {element.segment.dx, element.segment.dy});
    } else {
      const Arc& arc = element.arc;
      append_numbers(text, {arc.end.x, arc.end.y, arc.centre.x, arc.centre.y});
      text += arc.clockwise ? ",\"cw\"" : ",\"ccw\"";
    }
    text += ']';
  }
  text += "]}";
  return {};
}

Status JsonWriter::add(const Chain& chain) {
  begin_shape(chain.closed);
  std::string& text = output_.text;
  text += "\"at\":[";
  append_numbers(text, {chain.origin.x, chain.origin.y});
  text += chain.connectivity == Connectivity::four
              ? "],\"connectivity\":4,\"steps\":\""
              : "],\"connectivity\":8,\"steps\":\"";
  for (const Step step : chain.steps) text += static_cast<char>('0' + step);
  text += "\"}";
  return {};
}

}  // namespace

std::unique_ptr<FormatWriter> make_json_writer(VectorOutput& output) {
  return std::make_unique<JsonWriter>(output);
}

}  // namespace unstep
