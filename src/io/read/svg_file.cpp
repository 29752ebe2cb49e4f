#include "phrame/io/read/svg_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"
#include "phrame/io/read/svg_path.hpp"
#include "phrame/io/read/svg_shape.hpp"

namespace phrame::inline v0 {
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

/// One of matrix, translate, scale, rotate, skewX and skewY.
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
  if ((name == "skewX" || name == "skewY") && n == 1) {
    // Of fractions of degrees only those of 45° have a rational tangent.
    const Rational eighths = x[0] / 45;
    const auto [c, s] = rotation_by_degrees(x[0]);
    if (c == 0) in.fail("an angle with a tangent");
    Rational slope = s / c;
    if (denominator(eighths) == 1) slope = floor(slope + Rational(1, 2));
    return name == "skewX" ? PlaneMap{{1, 0}, {slope, 1}, {0, 0}}
                           : PlaneMap{{1, slope}, {0, 1}, {0, 0}};
  }
  throw InputError(
      place, fmt::format("the transformation {} of {} is not applied; matrix, translate, scale, "
                         "rotate, skewX and skewY are",
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

/// A path or a shape.
struct SvgDrawn {
  std::string_view element;  ///< "path", "rect", …
  std::vector<std::pair<std::string_view, SvgAttribute>> attributes;
  PlaneMap map;
  std::size_t at;  ///< where it begins

  std::optional<SvgAttribute> attribute(std::string_view name) const {
    for (const auto& [known, value] : attributes)
      if (known == name) return value;
    return std::nullopt;
  }
};

/// Without a prefix, as that of svg:path.
std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(':') == std::string_view::npos ? 0 : name.rfind(':') + 1);
}

/// Reads tags, and nothing of the text between them.
class SvgReader {
 public:
  explicit SvgReader(std::string_view text) : text_(text) {}

  /// The paths and shapes, at least one.
  const std::vector<SvgDrawn>& read() {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) read_tag();
    if (!has_svg_) fail(0, "this is no SVG file");
    if (!open_.empty())
      fail(text_.size(), fmt::format("<{}> is not closed", abbreviated(open_.back().name)));
    if (drawn_.empty())
      fail(text_.size(),
           fmt::format("the file draws no path and no shape{}",
                       has_use_ ? "; what <use> draws is not followed: unlink the clones" : ""));
    return drawn_;
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
  std::string_view text_;
  std::size_t at_ = 0;
  bool has_svg_ = false;
  std::vector<SvgElement> open_;
  bool has_use_ = false;
  std::vector<SvgDrawn> drawn_;
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
  const std::string_view local = local_name(element.name);
  has_use_ = has_use_ || local == "use";
  SvgDrawn drawn{local, {}, {}, first};
  for (;;) {
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    const bool is_empty = rest.starts_with("/>");
    if (is_empty || rest.starts_with(">")) {
      at_ += is_empty ? 2 : 1;
      drawn.map = element.map;
      const bool is_path = local == "path" && drawn.attribute("d");
      if ((is_path || is_svg_shape(local)) && element.is_drawn) drawn_.push_back(drawn);
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
    const std::string_view said = text_.substr(value->begin, value->end - value->begin);
    if ((name == "display" && said == "none") ||
        (name == "style" && said.find("display:none") != std::string_view::npos))
      element.is_drawn = false;
    drawn.attributes.emplace_back(name, *value);
  }
}

/// Of a path all subpaths, or the only one.
std::vector<std::vector<GivenSegment>> svg_outlines(std::string_view text, const SvgDrawn& drawn,
                                                    bool wants_one) {
  if (drawn.element != "path") {
    auto outline = read_svg_shape(
        drawn.element, text, [&](std::string_view name) { return drawn.attribute(name); },
        drawn.map, line_and_column(text, drawn.at + 1));
    if (outline.empty()) return {};
    return {std::move(outline)};
  }
  const auto [begin, end] = drawn.attribute("d").value();
  if (wants_one) return {read_path_data(text, begin, end, drawn.map)};
  return read_subpaths(text, begin, end, drawn.map);
}

/// A shape without a size. What cannot be read is something.
bool is_nothing(std::string_view text, const SvgDrawn& drawn) {
  if (drawn.element == "path") return false;
  try {
    return svg_outlines(text, drawn, true).empty();
  } catch (const InputError&) {
    return false;
  }
}

CurveLabel svg_label(std::string_view text, const SvgDrawn& drawn) {
  const auto said = [&](std::string_view name) {
    const auto found = drawn.attribute(name);
    return found ? std::string(text.substr(found->begin, found->end - found->begin)) : "";
  };
  CurveLabel label{said("inkscape:label"), said("id")};
  if (label.shown().empty()) label.id = line_and_column(text, drawn.at + 1);
  return label;
}

}  // namespace

PointCurve read_svg(std::string_view text, const FileReading& reading) {
  SvgReader reader(text);
  std::vector<SvgDrawn> drawn = reader.read();
  std::erase_if(drawn, [&](const SvgDrawn& one) { return is_nothing(text, one); });
  if (drawn.empty())
    throw InputError(line_and_column(text, text.size() + 1), "the file draws no path and no shape");
  std::vector<CurveLabel> labels;
  for (const SvgDrawn& one : drawn) labels.push_back(svg_label(text, one));
  const std::size_t at = [&] {
    try {
      return chosen_curve(labels, reading.pick);
    } catch (const InputError& error) {
      const std::size_t second = drawn[std::min<std::size_t>(1, drawn.size() - 1)].at;
      throw InputError(line_and_column(text, second + 1), error.reason());
    }
  }();
  return {labels[at].name, svg_outlines(text, drawn[at], true).front()};
}

std::vector<std::vector<GivenSegment>> read_svg_subpaths(std::string_view text) {
  SvgReader reader(text);
  std::vector<std::vector<GivenSegment>> all;
  for (const SvgDrawn& one : reader.read())
    for (auto& subpath : svg_outlines(text, one, false)) all.push_back(std::move(subpath));
  return all;
}

}  // namespace phrame
