#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "formats/affine.h"
#include "formats/dxf_pairs.h"

namespace unstep {

/// Draws the entities of a DXF file, those of blocks where they are inserted.
class DxfEntities {
 public:
  DxfEntities(DxfRecords& records, RealDrawing& drawing)
      : records_(records), drawing_(drawing) {}

  /// Where the entities of a block begin, and its base point.
  struct Block {
    DxfRecords::Place place;
    RealPoint base;
  };
  void add_block(const std::string& name, const Block& block) {
    blocks_.emplace(name, block);
  }

  /// Draws records up to the one of kind `end`, or skips them if `transform`
  /// is null. corrupt or truncated for what cannot be read.
  Status draw_until(std::string_view end, const Affine* transform, int depth);

  /// One line each.
  [[nodiscard]] std::set<std::string> notes() const;

 private:
  Status draw(const DxfRecord& record, const Affine& transform, int depth);
  Status insert(const DxfRecord& record, const Affine& transform, int depth);
  Status polyline(const DxfRecord& head, const Affine& transform);
  void light_polyline(const DxfRecord& record, const Affine& transform);
  void spline(const DxfRecord& record, const Affine& transform);
  void leave_out(std::string_view kind);
  Affine placed(const DxfRecord& record, const Affine& transform);
  Error at(const DxfRecord& record, Error error) const;

  struct Vertex {
    RealPoint at;
    double bulge = 0;
    double begin_width = 0;
    double end_width = 0;
  };
  void draw_vertices(const std::vector<Vertex>& vertices, bool closed,
                     const Affine& transform);

  DxfRecords& records_;
  RealDrawing& drawing_;
  std::unordered_map<std::string, Block> blocks_;
  std::map<std::string, std::uint64_t, std::less<>> left_out_;
  std::set<std::string> layers_;
  std::set<std::string> notes_;
};

}  // namespace unstep
