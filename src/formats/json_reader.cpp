#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "formats/format_reader.h"
#include "formats/outline.h"
#include "formats/resolution.h"

/// unstep's own JSON, docs/vectors.md. Errors name the value by its path.
namespace unstep {
namespace {

using nlohmann::json;

/// nlohmann's tree for the densest text, "[0,0,0,...": 16 bytes a value in a
/// vector that may be twice as long, for two characters; and an array of its
/// own for every "[],".
constexpr std::uint64_t kMemoryPerByte = 40;

class JsonReader {
 public:
  explicit JsonReader(const VectorReadOptions& options)
      : limits_(options.limits) {}

  Result<std::vector<VectorPage>> read(std::string_view bytes);

 private:
  bool fail(const std::string& reason, ErrorCode code = ErrorCode::corrupt);
  /// The member, or null; a type that does not fit is a fault.
  const json* member(const json& object, const char* key, json::value_t type);
  bool integer(const json& value, std::int64_t low, std::int64_t high,
               std::int64_t& out);
  bool integers(const json& array, std::size_t count, std::int64_t low,
                std::int64_t high, std::int64_t* out);
  bool page(const json& value, VectorPage& page);
  bool canvas(const json& value, Canvas& canvas);
  bool words(const json& value, VectorPage& page);
  bool resolution(const json& value, Resolution& resolution);
  bool info(const json& value, PageInfo& info);
  bool shape(const json& value, Drawing& drawing);
  bool path(const json& value, const json& elements, Path& path);
  bool element(const json& value, Path::Element& element);
  bool chain(const json& value, const std::string& steps, YAxis axis,
             Chain& chain);
  bool origin(const json& value, Point& origin);

  DecodeLimits limits_;
  Error error_;
  std::string place_;
  std::uint64_t steps_ = 0;
};

bool JsonReader::fail(const std::string& reason, ErrorCode code) {
  error_ = {code, (place_.empty() ? "" : place_ + ": ") + reason};
  return false;
}

const json* JsonReader::member(const json& object, const char* key,
                               json::value_t type) {
  const auto found = object.find(key);
  if (found == object.end()) return nullptr;
  return found->type() == type ? &*found : nullptr;
}

bool JsonReader::integer(const json& value, std::int64_t low, std::int64_t high,
                         std::int64_t& out) {
  if (!value.is_number_integer()) return fail("expected whole numbers");
  const bool huge = value.is_number_unsigned() &&
                    value.get<std::uint64_t>() > std::uint64_t{INT64_MAX};
  out = huge ? INT64_MAX : value.get<std::int64_t>();
  if (out < low || out > high) {
    return fail("a number outside " + std::to_string(low) + " to " +
                    std::to_string(high),
                ErrorCode::out_of_range);
  }
  return true;
}

bool JsonReader::integers(const json& array, std::size_t count,
                          std::int64_t low, std::int64_t high,
                          std::int64_t* out) {
  if (!array.is_array() || array.size() < count) {
    return fail("expected " + std::to_string(count) + " numbers");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!integer(array[i], low, high, out[i])) return false;
  }
  return true;
}

bool JsonReader::canvas(const json& value, Canvas& canvas) {
  std::array<std::int64_t, 2> sides{};
  const json* size = member(value, "canvas", json::value_t::array);
  if (size == nullptr) return fail("expected \"canvas\": [width, height]");
  if (!integers(*size, 2, 0, kMaxCoord, sides.data())) return false;
  canvas.width = static_cast<std::int32_t>(sides[0]);
  canvas.height = static_cast<std::int32_t>(sides[1]);
  return true;
}

/// "y", "scale" and "paint".
bool JsonReader::words(const json& value, VectorPage& page) {
  Drawing& drawing = page.drawing;
  const std::string axis = value.value("y", "down");
  if (axis != "up" && axis != "down") return fail("\"y\" is up or down");
  drawing.canvas.y_axis = axis == "up" ? YAxis::up : YAxis::down;
  std::int64_t scale = 1;
  if (value.contains("scale") &&
      !integer(value["scale"], 1, Drawing::kMaxScale, scale)) {
    return false;
  }
  drawing.scale = static_cast<std::int32_t>(scale);
  const std::string paint = value.value("paint", "fill");
  if (paint != "fill" && paint != "stroke") {
    return fail("\"paint\" is fill or stroke");
  }
  drawing.paint = paint == "fill" ? Paint::fill : Paint::stroke;
  return true;
}

bool JsonReader::resolution(const json& value, Resolution& resolution) {
  constexpr std::array<const char*, 4> kUnits{"none", "inch", "centimetre",
                                              "metre"};
  std::array<std::int64_t, 2> x{};
  std::array<std::int64_t, 2> y{};
  const json* along_x = member(value, "x", json::value_t::array);
  const json* along_y = member(value, "y", json::value_t::array);
  if (along_x == nullptr || along_y == nullptr) {
    return fail("expected \"resolution\": {\"x\": [n, d], \"y\": [n, d]}");
  }
  if (!integers(*along_x, 2, 1, UINT32_MAX, x.data()) ||
      !integers(*along_y, 2, 1, UINT32_MAX, y.data())) {
    return false;
  }
  const auto rational = [](const std::array<std::int64_t, 2>& parts) {
    return Rational{static_cast<std::uint32_t>(parts[0]),
                    static_cast<std::uint32_t>(parts[1])};
  };
  resolution = {rational(x), rational(y), Resolution::Unit::none};
  const std::string unit = value.value("unit", "none");
  const auto found = std::find(kUnits.begin(), kUnits.end(), unit);
  if (found == kUnits.end()) return fail("unknown unit");
  resolution.unit =
      static_cast<Resolution::Unit>(std::distance(kUnits.begin(), found));
  return true;
}

bool JsonReader::info(const json& value, PageInfo& info) {
  info.name = value.value("name", "");
  if (const json* size = member(value, "resolution", json::value_t::object)) {
    if (!resolution(*size, info.resolution)) return false;
  }
  const json* pairs = member(value, "metadata", json::value_t::array);
  if (pairs == nullptr) return true;
  for (const json& pair : *pairs) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() ||
        !pair[1].is_string()) {
      return fail("\"metadata\" is pairs of strings");
    }
    info.metadata.emplace_back(pair[0].get<std::string>(),
                               pair[1].get<std::string>());
  }
  return true;
}

bool JsonReader::origin(const json& value, Point& origin) {
  std::array<std::int64_t, 2> at{};
  const json* point = member(value, "at", json::value_t::array);
  if (point == nullptr) return fail("expected \"at\": [x, y]");
  if (!integers(*point, 2, -kMaxCoord, kMaxCoord, at.data())) return false;
  origin = {static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1])};
  return true;
}

bool JsonReader::element(const json& value, Path::Element& element) {
  constexpr std::int64_t kFar = 2 * std::int64_t{kMaxCoord};
  std::array<std::int64_t, 4> v{};
  const std::size_t size = value.is_array() ? value.size() : 0;
  if (size != 2 && size != 5) {
    return fail("expected [dx, dy] or [dx, dy, centre x, centre y, \"cw\"]");
  }
  if (!integers(value, size == 2 ? 2 : 4, -kFar, kFar, v.data())) return false;
  const Point move{static_cast<std::int32_t>(v[0]),
                   static_cast<std::int32_t>(v[1])};
  if (size == 2) {
    element.segment = {move.x, move.y};
    return true;
  }
  if (value[4] != "cw" && value[4] != "ccw") return fail("expected cw or ccw");
  element.kind = Path::Kind::arc;
  element.arc = {
      {static_cast<std::int32_t>(v[2]), static_cast<std::int32_t>(v[3])},
      move,
      value[4] == "cw"};
  return true;
}

bool JsonReader::path(const json& value, const json& elements, Path& path) {
  std::int64_t width = 0;
  if (value.contains("width") &&
      !integer(value["width"], 0, kMaxCoord, width)) {
    return false;
  }
  path.width = static_cast<std::int32_t>(width);
  path.elements.reserve(elements.size());
  for (const json& part : elements) {
    if (!element(part, path.elements.emplace_back())) return false;
  }
  const Status valid = check_path(path);
  if (!valid) return fail(valid.error().message, valid.error().code);
  return true;
}

bool JsonReader::chain(const json& value, const std::string& steps, YAxis axis,
                       Chain& chain) {
  std::int64_t connectivity = 8;
  if (value.contains("connectivity") &&
      !integer(value["connectivity"], 4, 8, connectivity)) {
    return false;
  }
  if (connectivity != 4 && connectivity != 8) {
    return fail("\"connectivity\" is 4 or 8");
  }
  chain.connectivity = static_cast<Connectivity>(connectivity);
  steps_ += steps.size();
  if (steps_ > limits_.max_steps) {
    return fail("more than the limit of " + std::to_string(limits_.max_steps) +
                    " steps",
                ErrorCode::limit_exceeded);
  }
  chain.steps.reserve(steps.size());
  for (const char c : steps) {
    if (c < '0' || c > '7' || (connectivity == 4 && (c - '0') % 2 != 0)) {
      return fail("expected steps of 0 to 7, even if 4-connected");
    }
    chain.steps.push_back(static_cast<Step>(c - '0'));
  }
  const Status valid = check_chain(chain, axis);
  if (!valid) return fail(valid.error().message, valid.error().code);
  return true;
}

bool JsonReader::shape(const json& value, Drawing& drawing) {
  if (!value.is_object()) return fail("expected an object");
  Point start;
  if (!origin(value, start)) return false;
  const bool closed = value.value("closed", false);
  if (const json* elements = member(value, "path", json::value_t::array)) {
    Path& made = drawing.paths.emplace_back();
    made.origin = start;
    made.closed = closed;
    return path(value, *elements, made);
  }
  const json* steps = member(value, "steps", json::value_t::string);
  if (steps == nullptr) return fail("expected \"path\" or \"steps\"");
  Chain& made = drawing.chains.emplace_back();
  made.origin = start;
  made.closed = closed;
  return chain(value, steps->get_ref<const std::string&>(),
               drawing.canvas.y_axis, made);
}

bool JsonReader::page(const json& value, VectorPage& page) {
  if (!value.is_object()) return fail("expected an object");
  if (!canvas(value, page.drawing.canvas) || !words(value, page) ||
      !info(value, page.info)) {
    return false;
  }
  const json* shapes = member(value, "shapes", json::value_t::array);
  if (shapes == nullptr) return fail("expected \"shapes\": []");
  const std::string page_place = place_;
  std::size_t index = 0;
  for (const json& one : *shapes) {
    place_ = page_place + ", shape " + std::to_string(++index);
    if (!shape(one, page.drawing)) return false;
  }
  return true;
}

Result<std::vector<VectorPage>> JsonReader::read(std::string_view bytes) {
  if (bytes.size() > limits_.max_memory / kMemoryPerByte) {
    return Error{ErrorCode::limit_exceeded,
                 "the JSON may need more than the memory limit of " +
                     std::to_string(limits_.max_memory) + " bytes"};
  }
  const json root = json::parse(bytes.begin(), bytes.end());
  if (!root.is_object() || !root.contains("unstep")) {
    return Error{ErrorCode::bad_magic, "no object with \"unstep\": 1"};
  }
  if (root["unstep"] != 1) {
    return Error{ErrorCode::unsupported_version,
                 "an unknown version of the schema"};
  }
  std::vector<VectorPage> pages;
  const json* list = member(root, "pages", json::value_t::array);
  if (list == nullptr) {
    return Error{ErrorCode::corrupt, "expected \"pages\": []"};
  }
  for (const json& value : *list) {
    place_ = "page " + std::to_string(pages.size() + 1);
    if (!page(value, pages.emplace_back())) return error_;
  }
  return pages;
}

}  // namespace

Result<std::vector<VectorPage>> read_json(std::string_view bytes,
                                          const VectorReadOptions& options) {
  try {
    return JsonReader(options).read(bytes);
  } catch (const json::parse_error& fault) {
    return Error{ErrorCode::corrupt,
                 "byte " + std::to_string(fault.byte) + ": no JSON"};
  } catch (const json::exception&) {
    return Error{ErrorCode::corrupt, "a value of the wrong type"};
  }
}

}  // namespace unstep
