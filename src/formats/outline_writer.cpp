#include "formats/outline_writer.h"

namespace unstep {

Status OutlineWriter::begin_page(const PageHead& head) {
  drawing_axis_ = head.canvas.y_axis;
  scale_ = head.scale;
  frame_ = {};
  PageHead turned = head;
  if (drawing_axis_ != axis_) {
    frame_ = {true, std::int64_t{head.canvas.height} * head.scale};
    if (head.box) {
      turned.box->low.y = frame_.height - head.box->high.y;
      turned.box->high.y = frame_.height - head.box->low.y;
    }
  }
  return begin(turned);
}

Status OutlineWriter::add(const Path& path) {
  to_outline(path, frame_, outline_);
  return draw(outline_);
}

Status OutlineWriter::add(const Chain& chain) {
  to_outline(chain, drawing_axis_, scale_, frame_, outline_);
  return draw(outline_);
}

}  // namespace unstep
