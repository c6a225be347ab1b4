#include <string>

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

}  // namespace

std::string write_freeman(const Drawing& drawing) {
  const Canvas& canvas = drawing.canvas;
  std::string text = "canvas " + std::to_string(canvas.width) + " " +
                     std::to_string(canvas.height) +
                     (canvas.y_axis == YAxis::up ? " up\n" : " down\n");
  for (const Chain& chain : drawing.chains) write_chain(chain, text);
  return text;
}

}  // namespace unstep
