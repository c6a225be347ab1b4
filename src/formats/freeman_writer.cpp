#include <memory>
#include <string>

#include "formats/format_writer.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

constexpr std::size_t kStepsPerLine = 72;

void write_chain(const Chain& chain, std::string& text) {
  text += chain.closed ? "closed" : "open";
  text += chain.connectivity == Connectivity::four ? "4 " : "8 ";
  text += std::to_string(chain.origin.x) + " " +
          std::to_string(chain.origin.y) + ":";
  const bool one_line = chain.steps.size() <= kStepsPerLine - 24;
  if (one_line && !chain.steps.empty()) text += ' ';
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    if (!one_line && i % kStepsPerLine == 0) text += "\n  ";
    text += static_cast<char>('0' + chain.steps[i]);
  }
  text += '\n';
}

void write_canvas(const Canvas& canvas, std::string& text) {
  text += "canvas " + std::to_string(canvas.width) + " " +
          std::to_string(canvas.height) +
          (canvas.y_axis == YAxis::up ? " up\n" : " down\n");
}

class FreemanWriter : public FormatWriter {
 public:
  explicit FreemanWriter(VectorOutput& output) : output_(output) {}

  Status begin_page(const PageHead& head) override {
    if (had_page_) {
      return Error{ErrorCode::invalid_argument,
                   "chain text has one page; write a file for each"};
    }
    had_page_ = true;
    if (!head.info.name.empty() || head.info.resolution.known() ||
        !head.info.metadata.empty()) {
      output_.note("chain text has no name, resolution or metadata");
    }
    write_canvas(head.canvas, output_.text);
    return {};
  }
  Status add(const Path& /*path*/) override {
    return Error{ErrorCode::invalid_argument,
                 "chain text holds unit steps only; interpolate the lines and "
                 "arcs first, or write JSON"};
  }
  Status add(const Chain& chain) override {
    write_chain(chain, output_.text);
    return {};
  }
  Status end_page() override { return {}; }
  Status finish() override { return {}; }

 private:
  VectorOutput& output_;
  bool had_page_ = false;
};

}  // namespace

std::unique_ptr<FormatWriter> make_freeman_writer(VectorOutput& output) {
  return std::make_unique<FreemanWriter>(output);
}

std::string write_freeman(const Drawing& drawing) {
  std::string text;
  write_canvas(drawing.canvas, text);
  for (const Chain& chain : drawing.chains) write_chain(chain, text);
  return text;
}

}  // namespace unstep
