#include <algorithm>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>
#include <utility>

#include "formats/format_reader.h"
#include "formats/grid_fit.h"
#include "formats/svg_shapes.h"
#include "formats/svg_size.h"
#include "formats/svg_style.h"
#include "formats/svg_transform.h"
#include "formats/text.h"
#include "formats/text_scanner.h"

/// SVG 1.1 as far as it draws outlines, docs/vectors.md.
namespace unstep {
namespace {

/// Elements inside elements, and uses of uses: the walk is recursive.
constexpr int kMaxDepth = 256;

/// What an element costs at least; uses of uses cannot be free.
constexpr std::uint64_t kElementMemory = 256;

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view prefix_of(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? "" : name.substr(0, colon);
}

bool is_one_of(std::string_view name,
               std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class SvgReader {
 public:
  explicit SvgReader(const VectorReadOptions& options)
      : options_(options), drawing_(options.limits) {}

  Result<VectorPage> read(std::string_view bytes);

 private:
  Status parse(std::string_view bytes);
  void collect(const pugi::xml_node& root);
  void read_metadata(const pugi::xml_node& node);
  Status walk(const pugi::xml_node& node, const Affine& outer, SvgStyle style,
              int depth);
  Status walk_children(const pugi::xml_node& node, const Affine& transform,
                       const SvgStyle& style, int depth);
  Status use(const pugi::xml_node& node, const Affine& transform,
             const SvgStyle& style, int depth);
  Affine viewport_of(const pugi::xml_node& node, const pugi::xml_node& size);
  Status draw(const pugi::xml_node& node, std::string_view name,
              const Affine& transform, const SvgStyle& style);
  void leave_out(std::string_view name);
  Paint choose_paint();
  void add_notes();
  [[nodiscard]] static Error at(const pugi::xml_node& node, Error error);

  const VectorReadOptions& options_;
  RealDrawing drawing_;
  VectorPage page_;
  SvgViewport viewport_;
  pugi::xml_document document_;
  std::string_view prefix_;  ///< of the elements of SVG
  std::unordered_map<std::string, pugi::xml_node> by_id_;
  SvgStyles styles_;
  std::map<std::string, std::uint64_t, std::less<>> left_out_;
  std::uint64_t filled_ = 0;
  std::uint64_t stroked_ = 0;
  std::uint64_t paper_ = 0;
  bool lost_stroke_ = false;
  bool clipped_ = false;
  bool bent_pen_ = false;
  bool non_zero_ = false;
  bool missing_use_ = false;
};

Error SvgReader::at(const pugi::xml_node& node, Error error) {
  error.message = "byte " + std::to_string(node.offset_debug()) + ", <" +
                  node.name() + ">: " + error.message;
  // What the file calls its elements may be anything.
  for (char& c : error.message) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return error;
}

Status SvgReader::parse(std::string_view bytes) {
  // pugixml: a node takes 56 to 80 bytes, an attribute 40 to 48, and a copy of
  // the text.
  const auto marks =
      static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '<'));
  const auto values =
      static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '='));
  drawing_.use_memory(2 * bytes.size() + 160 * marks + 48 * values);
  if (!drawing_.status()) return drawing_.status();
  const pugi::xml_parse_result parsed =
      document_.load_buffer(bytes.data(), bytes.size(),
                            pugi::parse_default | pugi::parse_ws_pcdata_single);
  if (!parsed) {
    return Error{
        parsed.status == pugi::status_out_of_memory ? ErrorCode::limit_exceeded
                                                    : ErrorCode::corrupt,
        "byte " + std::to_string(parsed.offset) + ": " + parsed.description()};
  }
  const pugi::xml_node root = document_.document_element();
  if (local_name(root) != "svg") {
    return Error{ErrorCode::bad_magic, "the root element is not svg"};
  }
  prefix_ = prefix_of(root);
  return {};
}

/// Identifiers and style sheets, wherever they are.
void SvgReader::collect(const pugi::xml_node& root) {
  pugi::xml_node node = root;
  while (node) {
    if (const pugi::xml_attribute id = node.attribute("id")) {
      by_id_.emplace(id.value(), node);
    }
    if (local_name(node) == "style") {
      for (const pugi::xml_node& part : node.children()) {
        styles_.add_sheet(part.value());
      }
    }
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

/// What svg_writer.cpp writes; other metadata is only named.
void SvgReader::read_metadata(const pugi::xml_node& node) {
  for (const pugi::xml_node& entry : node.children()) {
    if (entry.type() != pugi::node_element) continue;
    if (local_name(entry) == "entry" && entry.attribute("key")) {
      add_metadata(page_.info.metadata, to_utf8(entry.attribute("key").value()),
                   to_utf8(entry.child_value()));
    } else {
      leave_out("metadata");
    }
  }
}

void SvgReader::leave_out(std::string_view name) {
  if (left_out_.size() >= kNamedKinds && !left_out_.contains(name)) {
    name = "other";
  }
  ++left_out_[std::string(name)];
}

/// What a nested svg or symbol makes of its viewBox, x, y and size. `size`
/// has the width and height, of a use if it gives them.
Affine SvgReader::viewport_of(const pugi::xml_node& node,
                              const pugi::xml_node& size) {
  const auto length = [&](const pugi::xml_node& from, const char* name,
                          double whole, double missing) {
    const auto value = svg_length(from.attribute(name).value(), whole);
    return value.value_or(missing);
  };
  Affine result{1,
                0,
                0,
                1,
                length(node, "x", viewport_.width, 0),
                length(node, "y", viewport_.height, 0)};
  const std::optional<SvgViewBox> box = svg_view_box(node);
  clipped_ = true;
  if (!box) return result;
  const pugi::xml_node& from = size.attribute("width") ? size : node;
  const double width = length(from, "width", viewport_.width, viewport_.width);
  const double height =
      length(from, "height", viewport_.height, viewport_.height);
  double sx = width / box->width;
  double sy = height / box->height;
  const std::string_view ratio = node.attribute("preserveAspectRatio").value();
  if (!ratio.starts_with("none")) {
    sx = sy =
        ratio.find("slice") != ratio.npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto align = [&](const char* least, const char* most, double left) {
      if (ratio.find(least) != ratio.npos) return 0.0;
      return ratio.find(most) != ratio.npos ? left : left / 2;
    };
    result.e += align("xMin", "xMax", width - sx * box->width);
    result.f += align("YMin", "YMax", height - sy * box->height);
  }
  return result * Affine{sx, 0, 0, sy, -sx * box->x, -sy * box->y};
}

Status SvgReader::use(const pugi::xml_node& node, const Affine& transform,
                      const SvgStyle& style, int depth) {
  std::string_view target = node.attribute("href").value();
  if (target.empty()) target = node.attribute("xlink:href").value();
  const auto found = target.starts_with('#')
                         ? by_id_.find(std::string(target.substr(1)))
                         : by_id_.end();
  if (found == by_id_.end()) {
    missing_use_ = true;
    return {};
  }
  const auto place = [&](const char* name, double whole) {
    return svg_length(node.attribute(name).value(), whole).value_or(0);
  };
  const Affine moved = transform * Affine{1,
                                          0,
                                          0,
                                          1,
                                          place("x", viewport_.width),
                                          place("y", viewport_.height)};
  const pugi::xml_node& shown = found->second;
  if (local_name(shown) == "symbol") {
    SvgStyle inner = style;
    styles_.apply(shown, "symbol", inner);
    return walk_children(shown, moved * viewport_of(shown, node), inner,
                         depth + 1);
  }
  return walk(shown, moved, style, depth + 1);
}

Status SvgReader::walk_children(const pugi::xml_node& node,
                                const Affine& transform, const SvgStyle& style,
                                int depth) {
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    Status walked = walk(child, transform, style, depth + 1);
    if (!walked) return walked;
  }
  return {};
}

Status SvgReader::walk(const pugi::xml_node& node, const Affine& outer,
                       SvgStyle style, int depth) {
  if (depth > kMaxDepth) {
    return at(node, {ErrorCode::limit_exceeded, "elements or uses more than " +
                                                    std::to_string(kMaxDepth) +
                                                    " deep"});
  }
  drawing_.use_memory(kElementMemory);
  if (!drawing_.status()) return at(node, drawing_.status().error());
  if (prefix_of(node) != prefix_) return {};  // of an editor, not of SVG
  const std::string_view name = local_name(node);
  if (is_one_of(name, {"defs", "symbol", "desc", "style", "title", "clipPath",
                       "mask", "marker", "pattern", "linearGradient",
                       "radialGradient", "filter"})) {
    return {};
  }
  if (name == "metadata") {
    read_metadata(node);
    return {};
  }
  styles_.apply(node, name, style);
  if (!style.displayed) return {};
  Affine transform = outer;
  if (const pugi::xml_attribute own = node.attribute("transform")) {
    const Result<Affine> parsed = parse_svg_transform(own.value());
    if (!parsed) return at(node, parsed.error());
    transform = transform * *parsed;
  }
  if (is_svg_shape(name)) return draw(node, name, transform, style);
  if (name == "svg") transform = transform * viewport_of(node, node);
  if (is_one_of(name, {"g", "a", "svg"})) {
    return walk_children(node, transform, style, depth);
  }
  if (name == "switch") {
    return walk_children(node, transform, style, depth);
  }
  if (name == "use") return use(node, transform, style, depth);
  leave_out(name);
  return {};
}

/// What is filled with ink becomes a filled path, else what is stroked with ink
/// one of a pen.
Status SvgReader::draw(const pugi::xml_node& node, std::string_view name,
                       const Affine& transform, const SvgStyle& style) {
  if (!style.visible) return {};
  using Colour = SvgStyle::Colour;
  const bool fills =
      style.fill == Colour::ink && !style.fill_is_clear && name != "line";
  const bool strokes = style.stroke == Colour::ink && !style.stroke_is_clear &&
                       style.stroke_width > 0;
  if (!fills && !strokes) {
    if (style.fill == Colour::paper || style.stroke == Colour::paper) ++paper_;
    return {};
  }
  if (fills) {
    ++filled_;
    lost_stroke_ = lost_stroke_ || strokes;
    non_zero_ = non_zero_ || !style.even_odd;
  } else {
    ++stroked_;
    if (style.fill == Colour::paper) ++paper_;
    bent_pen_ = bent_pen_ || (!transform.is_similarity() && !style.hairline);
  }
  const double width =
      fills || style.hairline ? 0 : style.stroke_width * transform.factor();
  drawing_.set_style(fills, width);
  FigurePen pen(drawing_, transform);
  Status drawn = draw_svg_shape(node, name, viewport_, pen);
  drawing_.end_path();
  if (drawn) drawn = drawing_.status();
  if (!drawn) return at(node, drawn.error());
  return {};
}

/// A drawing is filled or stroked. If a file is both, outlines are kept.
Paint SvgReader::choose_paint() {
  if (filled_ == 0 || stroked_ == 0) {
    return filled_ > 0 || stroked_ == 0 ? Paint::fill : Paint::stroke;
  }
  page_.notes.push_back(
      std::to_string(filled_) +
      " filled shapes are kept as outlines: others are stroked");
  return Paint::stroke;
}

void SvgReader::add_notes() {
  const auto note = [this](bool holds, const std::string& line) {
    if (holds) page_.notes.push_back(line);
  };
  for (const auto& [name, count] : left_out_) {
    note(true, std::to_string(count) + " <" + to_utf8(name) + "> left out");
  }
  note(paper_ > 0, std::to_string(paper_) +
                       " shapes in a light colour are left out as paper");
  note(lost_stroke_, "strokes of filled shapes are left out");
  note(filled_ > 1 && stroked_ == 0,
       std::to_string(filled_) +
           " filled shapes are one even-odd fill: where they overlap they "
           "cancel out");
  note(
      filled_ == 1 && stroked_ == 0 && non_zero_ && drawing_.paths().size() > 1,
      "the fill rule is even-odd, not nonzero");
  note(bent_pen_, "pens that a transformation makes oval are round");
  note(clipped_, "nested viewports do not clip");
  note(missing_use_, "<use> of something outside the file is left out");
  for (const std::string& line : styles_.notes()) note(true, line);
}

Result<VectorPage> SvgReader::read(std::string_view bytes) {
  if (Status parsed = parse(bytes); !parsed) return parsed.error();
  const pugi::xml_node root = document_.document_element();
  collect(root);
  SvgSize size = read_svg_size(root);
  viewport_ = size.viewport;
  page_.info.resolution = size.resolution;
  page_.notes = std::move(size.notes);
  for (const pugi::xml_node& child : root.children()) {
    if (local_name(child) == "title" && page_.info.name.empty()) {
      page_.info.name = to_utf8(child.child_value());
    }
  }
  SvgStyle style;
  styles_.apply(root, "svg", style);
  if (Status walked = walk_children(root, size.to_canvas, style, 0); !walked) {
    return walked.error();
  }
  const Paint paint = choose_paint();
  Result<Drawing> drawing = fit_to_grid(drawing_, size.canvas, paint,
                                        options_.curve_tolerance, page_.notes);
  if (!drawing) return drawing.error();
  add_notes();
  page_.drawing = std::move(*drawing);
  return std::move(page_);
}

}  // namespace

Result<std::vector<VectorPage>> read_svg(std::string_view bytes,
                                         const VectorReadOptions& options) {
  SvgReader reader(options);
  Result<VectorPage> page = reader.read(bytes);
  if (!page) return page.error();
  std::vector<VectorPage> pages;
  pages.push_back(std::move(*page));
  return pages;
}

}  // namespace unstep
