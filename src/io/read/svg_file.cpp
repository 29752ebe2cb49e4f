#include "phrame/io/read/svg_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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

/// First the inner map, then the outer one.
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

/// `map` after the maps that the attribute lists. With each rotation the numbers get longer.
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

using SvgAttributeList = std::vector<std::pair<std::string_view, SvgAttribute>>;

/// An element with its attributes. The elements behind it in the list, up to number `end`, are
/// inside it.
struct SvgElement {
  std::string_view name;
  SvgAttributeList attributes;
  std::size_t at;  ///< where it begins
  std::size_t end = 0;

  std::optional<SvgAttribute> attribute(std::string_view asked) const {
    for (const auto& [known, value] : attributes)
      if (known == asked) return value;
    return std::nullopt;
  }
};

/// The name without its prefix: path of svg:path.
std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(':') == std::string_view::npos ? 0 : name.rfind(':') + 1);
}

/// Reads the tags of a file; the text between them is skipped.
class SvgReader {
 public:
  explicit SvgReader(std::string_view text) : text_(text) {}

  /// All elements, in their order.
  std::vector<SvgElement> read() {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) read_tag();
    if (!has_svg_) fail(0, "this is no SVG file");
    if (!open_.empty())
      fail(text_.size(),
           fmt::format("<{}> is not closed", abbreviated(elements_[open_.back()].name)));
    return std::move(elements_);
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
  std::vector<SvgElement> elements_;
  std::vector<std::size_t> open_;
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
    if (open_.empty() || elements_[open_.back()].name != name)
      fail(first, fmt::format("</{}> closes nothing that is open", abbreviated(name)));
    elements_[open_.back()].end = elements_.size();
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
  constexpr std::size_t deepest = 256;
  const std::size_t first = at_++;
  SvgElement element{take_name(), {}, first};
  if (element.name.empty()) fail(first, "\"<\" without a name");
  has_svg_ = has_svg_ || local_name(element.name) == "svg";
  for (;;) {
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    const bool is_empty = rest.starts_with("/>");
    if (is_empty || rest.starts_with(">")) {
      at_ += is_empty ? 2 : 1;
      element.end = elements_.size() + 1;
      if (!is_empty && open_.size() == deepest)
        fail(first, fmt::format("the elements are nested deeper than {}", deepest));
      if (!is_empty) open_.push_back(elements_.size());
      elements_.push_back(std::move(element));
      return;
    }
    const std::size_t at_name = at_;
    const std::string_view name = take_name();
    const auto value = name.empty() ? std::nullopt : take_value();
    if (!value)
      fail(at_name, fmt::format("an attribute of <{}> is expected, name=\"value\"",
                                abbreviated(element.name)));
    element.attributes.emplace_back(name, *value);
  }
}

/// A path or a shape that is drawn.
struct SvgDrawn {
  const SvgElement* element;
  PlaneMap map;
  std::vector<const SvgElement*> uses = {};  ///< the <use> elements around it, outermost first
  bool is_target = false;  ///< does the last of these refer to it, not to a group around it?
};

/// The paths and shapes of a file with the maps that place them; <use> is followed [SVG 2, 5.5, 7.8
/// and 8.2].
class SvgDrawing {
 public:
  explicit SvgDrawing(std::string_view text) : text_(text), elements_(SvgReader(text).read()) {
    for (const SvgElement& element : elements_)
      if (const auto id = said(element, "id"); !id.empty()) by_id_.emplace(id, &element);
    for (std::size_t k = 0; k < elements_.size(); k = elements_[k].end)
      draw(elements_[k], {}, std::nullopt);
    if (!drawn_.empty()) return;
    fail(text_.size(),
         fmt::format("the file draws no path and no shape{}",
                     lost_ ? fmt::format("; <use> refers to \"{}\", which is no id of this file",
                                         abbreviated(*lost_))
                           : ""));
  }

  std::vector<SvgDrawn>& drawn() { return drawn_; }  ///< at least one
  std::string_view text() const { return text_; }
  /// The value of an attribute; empty where there is none.
  std::string_view said(const SvgElement& element, std::string_view name) const {
    const auto found = element.attribute(name);
    return found ? text_.substr(found->begin, found->end - found->begin) : std::string_view();
  }

 private:
  /// The width and height that percentages refer to.
  using Size = std::optional<PlaneVector>;

  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(line_and_column(text_, at + 1), reason);
  }
  Size outer_size(const SvgElement& root) const;
  /// `use` is the <use> that refers to the element, if one does.
  void draw(const SvgElement& element, PlaneMap map, Size size, const SvgElement* use = nullptr);
  void draw_used(const SvgElement& use, const PlaneMap& map, const Size& size);
  /// `whole` is 100 %.
  std::optional<Rational> length(const SvgElement& element, std::string_view name,
                                 const std::optional<Rational>& whole) const;
  /// The map behind a shift by the x and y of the element.
  PlaneMap placed(const SvgElement& element, const PlaneMap& map, const Size& size) const;
  /// The numbers of its viewBox, where it has one.
  std::optional<std::array<Rational, 4>> view_box(const SvgElement& element) const;
  PlaneMap viewport(const SvgElement& element, const SvgElement* use, const PlaneMap& map,
                    Size& size) const;

  std::string_view text_;
  std::vector<SvgElement> elements_;
  std::map<std::string_view, const SvgElement*> by_id_;
  std::vector<const SvgElement*> uses_;     ///< the <use> elements that are being followed
  std::optional<std::string_view> lost_{};  ///< an id that a <use> refers to and no element has
  const SvgElement* root_ = nullptr;        ///< the outermost <svg>
  std::size_t visited_ = 0;                 ///< elements drawn by <use>
  std::vector<SvgDrawn> drawn_;
};

/// The size of its viewBox, which is not applied, or else its width and height in px.
SvgDrawing::Size SvgDrawing::outer_size(const SvgElement& root) const {
  try {
    if (const auto view = view_box(root)) return PlaneVector{(*view)[2], (*view)[3]};
    const auto width = length(root, "width", {}), height = length(root, "height", {});
    if (width && height) return PlaneVector{*width, *height};
  } catch (const InputError&) {
    // A length in percent of this will be refused.
  }
  return std::nullopt;
}

std::optional<Rational> SvgDrawing::length(const SvgElement& element, std::string_view name,
                                           const std::optional<Rational>& whole) const {
  const auto found = element.attribute(name);
  if (!found) return std::nullopt;
  const auto percent = said(element, name).find('%');
  if (percent == std::string_view::npos) return svg_length(text_, *found, name);
  if (!whole) fail(found->begin, "percent of what has no size that is known");
  const auto hundredths = svg_length(text_, {found->begin, found->begin + percent}, name);
  if (!hundredths) fail(found->begin, "a number is expected before %");
  return *whole / 100 * *hundredths;
}

PlaneMap SvgDrawing::placed(const SvgElement& element, const PlaneMap& map,
                            const Size& size) const {
  const auto place = [&](std::size_t k, std::string_view name) {
    return length(element, name, size ? std::optional((*size)[k]) : std::nullopt)
        .value_or(Rational(0));
  };
  return composed(map, translation(place(0, "x"), place(1, "y")));
}

std::optional<std::array<Rational, 4>> SvgDrawing::view_box(const SvgElement& element) const {
  const auto box = element.attribute("viewBox");
  if (!box) return std::nullopt;
  SvgNumbers in(text_.substr(0, box->end), box->begin);
  std::array<Rational, 4> view;
  for (Rational& x : view) x = in.number();
  return view;
}

/// x, y, width and height are those of the element, the latter two those of the <use> where it has
/// them; its viewBox fills that as preserveAspectRatio says. `size` becomes that of the viewBox.
PlaneMap SvgDrawing::viewport(const SvgElement& element, const SvgElement* use, const PlaneMap& map,
                              Size& size) const {
  const auto side = [&](std::size_t k, std::string_view name) -> std::optional<Rational> {
    const auto whole = size ? std::optional((*size)[k]) : std::nullopt;
    std::optional<Rational> found;
    if (use != nullptr) found = length(*use, name, whole);
    if (!found) found = length(element, name, whole);
    return found ? found : whole;
  };
  const PlaneMap moved = placed(element, map, size);
  const auto width = side(0, "width");
  const auto height = side(1, "height");
  size = width && height ? Size(PlaneVector{*width, *height}) : std::nullopt;
  const auto box = view_box(element);
  if (!box) return moved;
  const auto& view = *box;
  if (view[2] <= 0 || view[3] <= 0)
    fail(element.attribute("viewBox")->begin, "a viewBox without a size");
  if (!size)
    fail(element.at, "the size of what a viewBox fills is not known: width and height are wanted");
  PlaneVector scale{(*size)[0] / view[2], (*size)[1] / view[3]};
  const std::string_view fit = said(element, "preserveAspectRatio");
  const bool is_stretched = fit.find("none") != std::string_view::npos;
  if (!is_stretched)
    scale[0] = scale[1] = fit.find("slice") != std::string_view::npos
                              ? std::max(scale[0], scale[1])
                              : std::min(scale[0], scale[1]);
  const auto share = [&](std::string_view least, std::string_view most) {
    if (is_stretched || fit.find(least) != std::string_view::npos) return Rational(0);
    return fit.find(most) != std::string_view::npos ? Rational(1) : Rational(1, 2);
  };
  const PlaneVector offset{
      share("xMin", "xMax") * ((*size)[0] - view[2] * scale[0]) - view[0] * scale[0],
      share("YMin", "YMax") * ((*size)[1] - view[3] * scale[1]) - view[1] * scale[1]};
  size = PlaneVector{view[2], view[3]};
  return composed(moved, {{scale[0], 0}, {0, scale[1]}, offset});
}

void SvgDrawing::draw_used(const SvgElement& use, const PlaneMap& map, const Size& size) {
  const std::string_view href =
      trimmed(use.attribute("href") ? said(use, "href") : said(use, "xlink:href"));
  const auto target = href.starts_with('#') ? by_id_.find(href.substr(1)) : by_id_.end();
  if (target == by_id_.end()) {  // nothing is drawn, then
    lost_ = href;
    return;
  }
  constexpr std::size_t deepest = 64;
  if (std::ranges::find(uses_, &use) != uses_.end() || uses_.size() == deepest)
    fail(use.at, "<use> refers to itself, or too deeply");
  uses_.push_back(&use);
  draw(*target->second, placed(use, map, size), size, &use);
  uses_.pop_back();
}

void SvgDrawing::draw(const SvgElement& element, PlaneMap map, Size size, const SvgElement* use) {
  constexpr std::size_t most = 200'000;
  constexpr std::array not_drawn{"defs", "clipPath", "mask", "marker", "pattern"};
  if (!uses_.empty() && ++visited_ > most)
    fail(element.at, fmt::format("<use> draws more than {} elements", most));
  const std::string_view local = local_name(element.name);
  if (std::ranges::find(not_drawn, local) != not_drawn.end()) return;
  if (local == "symbol" && use == nullptr) return;
  if (said(element, "display") == "none" ||
      said(element, "style").find("display:none") != std::string_view::npos)
    return;
  if (const auto transform = element.attribute("transform"))
    map = read_transform(map, text_, *transform);
  if (local == "svg" && root_ == nullptr) root_ = &element;
  if (&element == root_)
    size = outer_size(element);
  else if (local == "svg" || local == "symbol")
    map = viewport(element, use, map, size);
  if (local == "use") return draw_used(element, map, size);
  const bool is_path = local == "path" && element.attribute("d");
  if (is_path || is_svg_shape(local)) drawn_.push_back({&element, map, uses_, use != nullptr});
  const auto first = static_cast<std::size_t>(&element - elements_.data()) + 1;
  for (std::size_t k = first; k < element.end; k = elements_[k].end) draw(elements_[k], map, size);
}

/// The outlines of a shape or of a path: all its subpaths, or the only one if `wants_one`.
std::vector<std::vector<GivenSegment>> svg_outlines(std::string_view text, const SvgDrawn& drawn,
                                                    bool wants_one) {
  const SvgElement& element = *drawn.element;
  const std::string_view local = local_name(element.name);
  if (local != "path") {
    auto outline = read_svg_shape(
        local, text, [&](std::string_view name) { return element.attribute(name); }, drawn.map,
        line_and_column(text, element.at + 1));
    if (outline.empty()) return {};
    return {std::move(outline)};
  }
  const auto [begin, end] = element.attribute("d").value();
  if (wants_one) return {read_path_data(text, begin, end, drawn.map)};
  return read_subpaths(text, begin, end, drawn.map);
}

/// Is it a shape without a size? One that cannot be read is not.
bool is_nothing(std::string_view text, const SvgDrawn& drawn) {
  if (local_name(drawn.element->name) == "path") return false;
  try {
    return svg_outlines(text, drawn, true).empty();
  } catch (const InputError&) {
    return false;
  }
}

/// The label of the element, or of the <use> that draws it; of an element inside what a <use> draws
/// both, that of the <use> first.
CurveLabel svg_label(const SvgDrawing& drawing, const SvgDrawn& drawn) {
  const auto label_of = [&](const SvgElement& element) {
    CurveLabel label{std::string(drawing.said(element, "inkscape:label")),
                     std::string(drawing.said(element, "id"))};
    if (label.shown().empty()) label.id = line_and_column(drawing.text(), element.at + 1);
    return label;
  };
  if (drawn.uses.empty()) return label_of(*drawn.element);
  std::string name;
  for (const SvgElement* use : drawn.uses)
    name += (name.empty() ? "" : "/") + label_of(*use).shown();
  if (!drawn.is_target) name += "/" + label_of(*drawn.element).shown();
  return {std::move(name), ""};
}

}  // namespace

PointCurve read_svg(std::string_view text, const FileReading& reading) {
  SvgDrawing drawing(text);
  std::vector<SvgDrawn>& drawn = drawing.drawn();
  std::erase_if(drawn, [&](const SvgDrawn& one) { return is_nothing(text, one); });
  if (drawn.empty())
    throw InputError(line_and_column(text, text.size() + 1), "the file draws no path and no shape");
  std::vector<CurveLabel> labels;
  for (const SvgDrawn& one : drawn) labels.push_back(svg_label(drawing, one));
  const std::size_t second = drawn[std::min<std::size_t>(1, drawn.size() - 1)].element->at;
  const std::size_t at = chosen_curve(labels, reading.pick, line_and_column(text, second + 1));
  return {labels[at].name, svg_outlines(text, drawn[at], true).front()};
}

std::vector<std::vector<GivenSegment>> read_svg_subpaths(std::string_view text) {
  SvgDrawing drawing(text);
  std::vector<std::vector<GivenSegment>> all;
  for (const SvgDrawn& one : drawing.drawn())
    for (auto& subpath : svg_outlines(text, one, false)) all.push_back(std::move(subpath));
  return all;
}

}  // namespace phrame
