#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/source.h"
#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// The machines of `unstep simulate` at work on a page.
namespace unstep::cli {

struct SimulateOptions {
  std::string input;
  std::string machine = "zenit";
  bool write = false;  ///< esu: writes instead of scanning
  std::string plot;
  std::string exposure;
  std::uint64_t page = 1;
  double speed_mm = 1;
  double noise = 1;
  std::int32_t unit_um = 4;
  std::int32_t seed = 1;
  InputOptions read;
  bool json = false;
  bool quiet = false;
  bool force = false;
};

/// A machine's account of itself, and what it made.
struct Run {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text;
  std::optional<Drawing> commanded;
  std::optional<Drawing> followed;  ///< paths of zenit, contours of esu
  std::optional<Bitmap> exposure;
};

/// The page with its paths as steps, which Zenit takes.
Result<Page> as_steps(Page page, const SimulateOptions& options);

/// Draws the page with the laser. `notes` gets what an exposure leaves out.
Result<Run> run_zenit(const Page& page, const SimulateOptions& options,
                      std::vector<std::string>& notes);

/// Scans the page, or writes it on film.
Result<Run> run_esu(const Page& page, const SimulateOptions& options,
                    std::vector<std::string>& notes);

}  // namespace unstep::cli
