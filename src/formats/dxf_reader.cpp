#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "formats/dxf_entities.h"
#include "formats/format_reader.h"
#include "formats/grid_fit.h"

/// ASCII DXF, docs/vectors.md.
namespace unstep {
namespace {

class DxfReader {
 public:
  DxfReader(std::string_view bytes, const VectorReadOptions& options)
      : options_(options),
        records_(bytes),
        drawing_(options.limits),
        entities_(records_, drawing_) {}

  Result<VectorPage> read();

 private:
  Status read_section(const DxfRecord& record);
  void read_header(const DxfRecord& record);
  Status read_blocks();
  [[nodiscard]] Resolution resolution();
  [[nodiscard]] Canvas canvas_for(const Drawing& drawing) const;

  const VectorReadOptions& options_;
  DxfRecords records_;
  RealDrawing drawing_;
  DxfEntities entities_;
  VectorPage page_;
  int unit_ = 0;
  RealPoint limits_low_;
  RealPoint limits_high_;
};

/// Variables are groups of one long record: a name, then values.
void DxfReader::read_header(const DxfRecord& record) {
  std::string_view name;
  for (const DxfPair& pair : record.pairs) {
    const double value = dxf_number(pair.value).value_or(0);
    if (pair.code == 9) name = pair.value;
    if (name == "$INSUNITS" && pair.code == 70 && std::fabs(value) < 1000) {
      unit_ = static_cast<int>(value);
    }
    RealPoint* limits = name == "$LIMMIN"   ? &limits_low_
                        : name == "$LIMMAX" ? &limits_high_
                                            : nullptr;
    if (limits != nullptr && pair.code == 10) limits->x = value;
    if (limits != nullptr && pair.code == 20) limits->y = value;
  }
}

Status DxfReader::read_blocks() {
  DxfRecord record;
  for (;;) {
    if (Status read = records_.next(record); !read) return read;
    if (record.kind == "ENDSEC") return {};
    if (record.kind != "BLOCK") continue;
    entities_.add_block(
        std::string(record.text(2).value_or("")),
        {records_.place(), {record.real(10, 0), record.real(20, 0)}});
    drawing_.use_memory(256);
    Status skipped = entities_.draw_until("ENDBLK", nullptr, 0);
    if (!skipped) return skipped;
  }
}

Status DxfReader::read_section(const DxfRecord& record) {
  const std::string_view name = record.text(2).value_or("");
  if (name == "HEADER") read_header(record);
  if (name == "BLOCKS") return read_blocks();
  if (name == "ENTITIES") {
    const Affine none;
    return entities_.draw_until("ENDSEC", &none, 0);
  }
  DxfRecord skipped;
  do {
    if (Status read = records_.next(skipped); !read) return read;
  } while (skipped.kind != "ENDSEC" && skipped.kind != "EOF");
  if (skipped.kind == "EOF") {
    return Error{ErrorCode::corrupt,
                 "line " + std::to_string(skipped.line) + ": expected ENDSEC"};
  }
  return {};
}

Resolution DxfReader::resolution() {
  using Unit = Resolution::Unit;
  const auto of = [](std::uint32_t n, std::uint32_t d, Unit unit) {
    return Resolution{{n, d}, {n, d}, unit};
  };
  switch (unit_) {
    case 0: return {};
    case 1: return of(1, 1, Unit::inch);
    case 2: return of(1, 12, Unit::inch);
    case 4: return of(1000, 1, Unit::metre);
    case 5: return of(1, 1, Unit::centimetre);
    case 6: return of(1, 1, Unit::metre);
    default: break;
  }
  page_.notes.push_back("unit " + std::to_string(unit_) +
                        " of $INSUNITS is not kept");
  return {};
}

/// The limits of the drawing, if they begin at 0 and all is inside; programs
/// write limits that mean nothing.
Canvas DxfReader::canvas_for(const Drawing& drawing) const {
  const Canvas none{0, 0, YAxis::up};
  const bool usable = limits_low_ == RealPoint{} && limits_high_.x >= 1 &&
                      limits_high_.y >= 1 && limits_high_.x < kMaxCoord &&
                      limits_high_.y < kMaxCoord;
  if (!usable) return none;
  const double right = limits_high_.x * drawing.scale;
  const double top = limits_high_.y * drawing.scale;
  const auto inside = [right, top](Point p) {
    return p.x >= 0 && p.y >= 0 && p.x <= right && p.y <= top;
  };
  for (const Path& path : drawing.paths) {
    Point at = path.origin;
    if (!inside(at)) return none;
    for (const Path::Element& element : path.elements) {
      const bool is_arc = element.kind == Path::Kind::arc;
      at.x += is_arc ? element.arc.end.x : element.segment.dx;
      at.y += is_arc ? element.arc.end.y : element.segment.dy;
      if (!inside(at)) return none;
    }
  }
  return {static_cast<std::int32_t>(std::ceil(limits_high_.x - 1e-6)),
          static_cast<std::int32_t>(std::ceil(limits_high_.y - 1e-6)),
          YAxis::up};
}

Result<VectorPage> DxfReader::read() {
  DxfRecord record;
  do {
    if (Status read = records_.next(record); !read) return read.error();
    if (record.kind == "SECTION") {
      Status section = read_section(record);
      if (!section) return section.error();
    } else if (record.kind != "EOF" && record.kind != "ENDSEC") {
      return Error{
          record.line == 2 ? ErrorCode::bad_magic : ErrorCode::corrupt,
          "line " + std::to_string(record.line) + ": expected SECTION or EOF"};
    }
  } while (record.kind != "EOF");
  Result<Drawing> drawing =
      fit_to_grid(drawing_, {0, 0, YAxis::up}, Paint::stroke,
                  options_.curve_tolerance, page_.notes);
  if (!drawing) return drawing.error();
  page_.drawing = std::move(*drawing);
  page_.drawing.canvas = canvas_for(page_.drawing);
  page_.info.resolution = resolution();
  for (const std::string& line : entities_.notes()) {
    page_.notes.push_back(line);
  }
  return std::move(page_);
}

}  // namespace

Result<std::vector<VectorPage>> read_dxf(std::string_view bytes,
                                         const VectorReadOptions& options) {
  if (bytes.starts_with("AutoCAD Binary DXF")) {
    return Error{ErrorCode::unsupported, "binary DXF; save it as ASCII"};
  }
  DxfReader reader(bytes, options);
  Result<VectorPage> page = reader.read();
  if (!page) return page.error();
  std::vector<VectorPage> pages;
  pages.push_back(std::move(*page));
  return pages;
}

}  // namespace unstep
