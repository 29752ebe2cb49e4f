#include "phrame/io/read/svg_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"
#include "phrame/io/read/svg_path.hpp"

namespace phrame {
namespace {

PlaneVector mapped_vector(const PlaneMap& map, const PlaneVector& v) {
  return {v[0] * map.a[0] + v[1] * map.b[0], v[0] * map.a[1] + v[1] * map.b[1]};
}

/// First the inner one.
PlaneMap composed(const PlaneMap& outer, const PlaneMap& inner) {
  const PlaneVector moved = mapped_vector(outer, inner.offset);
  return {mapped_vector(outer, inner.a),
          mapped_vector(outer, inner.b),
          {moved[0] + outer.offset[0], moved[1] + outer.offset[1]}};
}

PlaneMap translation(const Rational& x, const Rational& y) { return {{1, 0}, {0, 1}, {x, y}}; }

/// A piece of the text, in quotation marks there.
struct SvgAttribute {
  std::size_t begin;
  std::size_t end;
};

/// One of matrix, translate, scale and rotate.
PlaneMap read_transform_function(SvgNumbers& in) {
  const std::string place = in.place();
  const std::string_view name = in.take_word();
  if (name.empty()) in.fail("a transformation is expected");
  if (!in.take('(')) in.fail("\"(\" is expected");
  std::vector<Rational> x;
  while (in.is_at_number() && x.size() < 7) x.push_back(in.number());
  if (!in.take(')')) in.fail("a number or \")\" is expected");
  const std::size_t n = x.size();
  if (name == "matrix" && n == 6) return {{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}};
  if (name == "translate" && (n == 1 || n == 2)) return translation(x[0], n == 2 ? x[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return {{x[0], 0}, {0, n == 2 ? x[1] : x[0]}, {0, 0}};
  if (name == "rotate" && (n == 1 || n == 3)) {
    const auto [c, s] = rotation_by_degrees(x[0]);
    const PlaneMap turn{{c, s}, {-s, c}, {0, 0}};
    if (n == 1) return turn;
    return composed(translation(x[1], x[2]), composed(turn, translation(-x[1], -x[2])));
  }
  throw InputError(
      place, fmt::format("the transformation {} of {} is not applied; matrix, translate, scale and "
                         "rotate are",
                         abbreviated(name), n == 1 ? "1 number" : fmt::format("{} numbers", n)));
}

/// The outer map after those that the attribute names. With each turn its numbers get longer.
PlaneMap read_transform(PlaneMap map, std::string_view text, const SvgAttribute& attribute) {
  SvgNumbers in(text.substr(0, attribute.end), attribute.begin);
  while (!in.at_end()) {
    const std::string place = in.place();
    map = composed(map, read_transform_function(in));
    for (const PlaneVector& v : {map.a, map.b, map.offset})
      if (std::max(bits_of(v[0]), bits_of(v[1])) > most_number_bits)
        throw InputError(place, fmt::format("with this transformation, what all of them make has "
                                            "numbers of more than {} bits",
                                            most_number_bits));
  }
  return map;
}

/// An element that is open.
struct SvgElement {
  std::string_view name;
  PlaneMap map;
  bool is_drawn;
};

struct SvgPath {
  SvgAttribute data;
  PlaneMap map;
};

/// Reads tags, and nothing of the text between them.
class SvgReader {
 public:
  SvgReader(std::string_view text, bool wants_one) : text_(text), wants_one_(wants_one) {}

  /// The paths, at least one.
  const std::vector<SvgPath>& read() {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) read_tag();
    if (!has_svg_) fail(0, "this is no SVG file");
    if (!open_.empty())
      fail(text_.size(), fmt::format("<{}> is not closed", abbreviated(open_.back().name)));
    if (paths_.empty()) fail(text_.size(), "the file draws no <path>");
    return paths_;
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(line_and_column(text_, at + 1), reason);
  }
  bool skip(std::string_view begin, std::string_view end) {
    if (!text_.substr(at_).starts_with(begin)) return false;
    const auto found = text_.find(end, at_ + begin.size());
    if (found == std::string_view::npos)
      fail(at_, fmt::format("\"{}\" is without its \"{}\"", begin, end));
    at_ = found + end.size();
    return true;
  }
  void read_tag();
  void read_element();
  std::string_view take_name();
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  std::optional<SvgAttribute> take_value();
  void add_path(const SvgAttribute& data, const SvgElement& element, std::size_t at);

  std::string_view text_;
  std::size_t at_ = 0;
  bool has_svg_ = false;
  std::vector<SvgElement> open_;
  bool wants_one_;
  std::vector<SvgPath> paths_;
};

void SvgReader::read_tag() {
  if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) return;
  if (text_.substr(at_).starts_with("<!")) {  // a document type, perhaps with declarations inside
    const auto bracket = text_.find_first_of("[>", at_);
    const bool has_declarations = bracket != std::string_view::npos && text_[bracket] == '[';
    skip("<!", has_declarations ? "]>" : ">");
    return;
  }
  if (text_.substr(at_).starts_with("</")) {
    const std::size_t first = at_;
    at_ += 2;
    const std::string_view name = take_name();
    if (open_.empty() || open_.back().name != name)
      fail(first, fmt::format("</{}> closes nothing that is open", abbreviated(name)));
    open_.pop_back();
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != '>') fail(first, "the tag is without its \">\"");
    return;
  }
  read_element();
}

std::string_view SvgReader::take_name() {
  const auto end = std::min(text_.find_first_of(" \t\r\n/>=\"'<", at_), text_.size());
  const std::string_view name = text_.substr(at_, end - at_);
  at_ = end;
  return name;
}

/// ="value" or ='value'.
std::optional<SvgAttribute> SvgReader::take_value() {
  skip_blanks();
  if (at_ == text_.size() || text_[at_] != '=') return std::nullopt;
  ++at_;
  skip_blanks();
  if (at_ == text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return std::nullopt;
  const std::size_t begin = at_ + 1;
  const auto end = text_.find(text_[at_], begin);
  if (end == std::string_view::npos) return std::nullopt;
  at_ = end + 1;
  return SvgAttribute{begin, end};
}

void SvgReader::read_element() {
  constexpr std::array not_drawn{"defs", "symbol", "clipPath", "mask", "marker", "pattern"};
  constexpr std::size_t deepest = 256;
  const std::size_t first = at_++;
  SvgElement element{take_name(), {}, true};
  if (element.name.empty()) fail(first, "\"<\" without a name");
  has_svg_ = has_svg_ || element.name == "svg" || element.name.ends_with(":svg");
  if (!open_.empty()) {
    element.map = open_.back().map;
    element.is_drawn = open_.back().is_drawn;
  }
  if (std::find(not_drawn.begin(), not_drawn.end(), element.name) != not_drawn.end())
    element.is_drawn = false;
  const bool is_path = element.name == "path" || element.name.ends_with(":path");
  std::optional<SvgAttribute> data;
  for (;;) {
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    const bool is_empty = rest.starts_with("/>");
    if (is_empty || rest.starts_with(">")) {
      at_ += is_empty ? 2 : 1;
      if (is_path && element.is_drawn && data) add_path(*data, element, first);
      if (!is_empty && open_.size() == deepest)
        fail(first, fmt::format("the elements are nested deeper than {}", deepest));
      if (!is_empty) open_.push_back(std::move(element));
      return;
    }
    const std::size_t at_name = at_;
    const std::string_view name = take_name();
    const auto value = name.empty() ? std::nullopt : take_value();
    if (!value)
      fail(at_name, fmt::format("an attribute of <{}> is expected, name=\"value\"",
                                abbreviated(element.name)));
    if (name == "transform" && element.is_drawn)
      element.map = read_transform(element.map, text_, *value);
    if (name == "d") data = *value;
  }
}

void SvgReader::add_path(const SvgAttribute& data, const SvgElement& element, std::size_t at) {
  if (wants_one_ && !paths_.empty())
    fail(at, "a second <path>; one curve is wanted (its \"d\" alone is read, too)");
  paths_.push_back({data, element.map});
}

}  // namespace

std::vector<GivenSegment> read_svg(std::string_view text) {
  SvgReader reader(text, true);
  const auto& [data, map] = reader.read().front();
  return read_path_data(text, data.begin, data.end, map);
}

std::vector<std::vector<GivenSegment>> read_svg_subpaths(std::string_view text) {
  SvgReader reader(text, false);
  std::vector<std::vector<GivenSegment>> all;
  for (const auto& [data, map] : reader.read())
    for (auto& subpath : read_subpaths(text, data.begin, data.end, map))
      all.push_back(std::move(subpath));
  return all;
}

}  // namespace phrame
