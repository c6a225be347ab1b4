#include "cli/pack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "cli/centreline.h"
#include "cli/message.h"
#include "cli/program.h"
#include "cli/reshape.h"
#include "cli/stored_size.h"

namespace unstep::cli {
namespace {

void count_lines(const Drawing& drawing, Packed& packed) {
  packed.paths += drawing.paths.size();
  for (const Path& path : drawing.paths) {
    for (const Path::Element& element : path.elements) {
      ++(element.kind == Path::Kind::arc ? packed.arcs : packed.lines);
    }
  }
}

void count_drawing(const Page& page, Packed& packed) {
  packed.chains += page.drawing.chains.size();
  for (const Chain& chain : page.drawing.chains) {
    packed.steps += chain.steps.size();
  }
  if (page.kind != PageKind::paths) return;
  count_lines(page.drawing, packed);
  packed.fidelity = page.fidelity;
  packed.strokes = is_strokes(page);
}

/// Of a page as it was read.
void count_ink(const Page& page, Packed& packed) {
  const Bitmap& ink = page.ink;
  packed.pixels += ink.pixels();
  packed.packed_bytes += (static_cast<std::uint64_t>(ink.width()) + 7) / 8 *
                         static_cast<std::uint64_t>(ink.height());
  packed.width = ink.width();
  packed.height = ink.height();
}

/// A program in the form that takes the least room, shortened if the lines say
/// so.
Result<Page> to_stored_program(Page page, const LineOptions& lines,
                               Packed& packed,
                               std::vector<std::string>& notes) {
  Result<Program> program = read_gcode(page.program, {});
  if (!program) return program.error();
  notes.insert(notes.end(), program->notes.begin(), program->notes.end());
  packed.program_bytes += page.program.size();
  ProgramOptions options;
  options.write.add_end = false;
  Result<WrittenProgram> written = write_program(*program, options, {});
  if (!written) return written.error();
  page.program = std::move(written->text);
  if (lines.method == LineOptions::Method::tolerance) {
    // Fewer motions with other numbers can take more room.
    Page shorter;
    shorter.kind = PageKind::program;
    shorter.info = page.info;
    written = write_program(*std::move(program), options, lines);
    if (!written) return written.error();
    shorter.program = std::move(written->text);
    const Result<std::size_t> whole = stored_size(page, Effort::standard);
    const Result<std::size_t> less = stored_size(shorter, Effort::standard);
    if (!whole) return whole.error();
    if (!less) return less.error();
    if (*less < *whole) page.program = std::move(shorter.program);
  }
  packed.program_lines += static_cast<std::uint64_t>(
      std::count(page.program.begin(), page.program.end(), '\n'));
  if (lines.method == LineOptions::Method::tolerance) {
    const Result<Rational> tolerance = program_tolerance(lines);
    if (!tolerance) return tolerance.error();
    page.fidelity = {Fidelity::Kind::tolerance, *tolerance};
  }
  packed.fidelity = page.fidelity;
  return page;
}

double share(std::uint64_t done, std::uint64_t total) {
  return total == 0 ? 0.0
                    : static_cast<double>(done) / static_cast<double>(total);
}

}  // namespace

std::string on_page(std::size_t index, std::size_t count,
                    std::string_view message) {
  const std::string place = fmt::format("page {}: ", index + 1);
  if (count == 1 || message.starts_with(place)) return std::string(message);
  return place + std::string(message);
}

std::string describe_bound(const Fidelity& fidelity, std::string_view unit,
                           bool strokes) {
  if (fidelity.kind == Fidelity::Kind::device) {
    return " within 1 px on each axis";
  }
  if (fidelity.kind == Fidelity::Kind::exact) return "";
  if (strokes && fidelity.tolerance.numerator == 0) return " on centrelines";
  return fmt::format(" within {:.6g} {}{}",
                     static_cast<double>(fidelity.tolerance.numerator) /
                         fidelity.tolerance.denominator,
                     unit, strokes ? " of centrelines" : "");
}

Result<Packed> pack(Source& source, const PackOptions& options, int jobs,
                    const Listener& listener) {
  const std::size_t count = source.page_count();
  Packed packed;
  std::size_t index = 0;
  std::uint64_t page_pixels = 0;
  const auto progress = [&](std::uint64_t done, std::uint64_t total) {
    const double part = share(done, total);
    const auto pixels =
        static_cast<std::uint64_t>(part * static_cast<double>(page_pixels));
    return listener(
        (static_cast<double>(index) + part) / static_cast<double>(count),
        packed.pixels + pixels);
  };
  UstpWriter writer({options.verify, options.bands, jobs, options.metadata,
                     progress, options.effort});
  for (; index < count; ++index) {
    Result<SourcePage> page = source.read(index);
    if (!page) {
      return Error{page.error().code,
                   on_page(index, count, page.error().message)};
    }
    if (index + 1 == count) source.release();  // room for the coder
    const Page& read = page->page;
    page_pixels = read.ink.pixels();
    ++packed.pages;
    if (read.kind == PageKind::ink) count_ink(read, packed);
    Bitmap traced;
    if (read.kind == PageKind::ink &&
        options.lines.trace == LineOptions::Trace::centreline) {
      traced = read.ink;
    }
    Result<Page> stored =
        read.kind == PageKind::program
            ? to_stored_program(std::move(page->page), options.lines, packed,
                                page->notes)
            : to_lines(std::move(page->page), options.lines, options.effort,
                       LineAim::few_bytes);
    if (!stored) {
      return Error{stored.error().code,
                   on_page(index, count, stored.error().message)};
    }
    if (traced.width() > 0) {
      const Status warned = warn_of_strokes(traced, *stored, page->notes);
      if (!warned) {
        return Error{warned.error().code,
                     on_page(index, count, warned.error().message)};
      }
    }
    if (options.lines.travel) {
      const Status ordered = order_page(*stored, page->notes);
      if (!ordered) return ordered.error();
    }
    if (const Status added = store_page(writer, *stored); !added) {
      return Error{added.error().code,
                   on_page(index, count, added.error().message)};
    }
    count_drawing(*stored, packed);
    const bool exact = stored->fidelity.kind == Fidelity::Kind::exact;
    packed.lossless = packed.lossless && page->lossless && exact;
    packed.exact = packed.exact && exact;
    if (!page->work.empty()) {
      packed.pixel_work.push_back(on_page(
          index, count, fmt::format("{}", fmt::join(page->work, "; "))));
    }
    for (const std::string& note : page->notes) {
      packed.notes.push_back(on_page(index, count, note));
    }
    if (!progress(0, 1)) return Error{ErrorCode::cancelled, "interrupted"};
  }
  Result<std::vector<std::uint8_t>> bytes = writer.finish();
  if (!bytes) return bytes.error();
  packed.bytes = std::move(*bytes);
  return packed;
}

std::string describe(const Packed& packed, bool verified) {
  std::string text = counted(packed.pages, "page");
  if (packed.pixels > 0 && packed.pages == 1) {
    text += fmt::format(", {} x {} px", packed.width, packed.height);
  } else if (packed.pixels > 0) {
    text += fmt::format(", {} px", grouped(packed.pixels));
  }
  if (packed.program_lines > 0) {
    text += ", " + counted(packed.program_lines, "line");
  } else if (packed.chains > 0 || (packed.pixels == 0 && packed.paths == 0)) {
    text += fmt::format(", {}, {}", counted(packed.chains, "chain"),
                        counted(packed.steps, "step"));
  }
  if (packed.paths > 0) {
    text += fmt::format(", {}, {}", counted(packed.paths, "path"),
                        counted(packed.lines, "line"));
    if (packed.arcs > 0) text += ", " + counted(packed.arcs, "arc");
  }
  if (packed.fidelity) {
    text +=
        describe_bound(*packed.fidelity, packed.program_lines > 0 ? "mm" : "px",
                       packed.strokes);
  }
  text += ", " + counted(packed.bytes.size(), "byte");
  if (packed.packed_bytes > 0) {
    text += fmt::format(", {} of {} packed",
                        per_cent(packed.bytes.size(), packed.packed_bytes),
                        grouped(packed.packed_bytes));
  }
  if (packed.program_bytes > 0) {
    text += fmt::format(", {} of {}",
                        per_cent(packed.bytes.size(), packed.program_bytes),
                        grouped(packed.program_bytes));
  }
  text += verified ? ", verified" : ", not verified";
  if (packed.pixel_work.empty()) return text;
  text += packed.pages == 1
              ? fmt::format("; pixels: {}", packed.pixel_work[0])
              : fmt::format("; pixels of {} changed",
                            counted(packed.pixel_work.size(), "page"));
  return text + (packed.exact ? "; lossless from there on" : "");
}

}  // namespace unstep::cli
