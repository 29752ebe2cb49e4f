#include "phrame/io/write/offset_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/boundary_fields.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/offset_page_source.hpp"
#include "phrame/io/write/passage.hpp"
#include "phrame/io/write/svg.hpp"

namespace phrame::inline v0 {
namespace {

constexpr Notation on_page = Notation::unicode;

/// Where a page draws a point: browsers draw with seven digits, so from the start of the path on,
/// and with all of it from 100 to 1 000 wide; y upwards. Of cubics it is exact.
class Canvas {
 public:
  explicit Canvas(const OffsetPicture& picture) : origin_(picture.path[0].cubics[0][0]) {
    add(picture.path);
    for (const auto& layer : picture.layers) {
      add(layer.paths);
      add(layer.whole);
    }
    const Rational size = std::max(width(0), width(1));
    if (size > 0) scale_ = power_of_ten(3 - digits(size));
  }

  std::array<Rational, 2> operator()(const std::array<Rational, 2>& point) const {
    return {(point[0] - origin_[0]) * scale_, (origin_[1] - point[1]) * scale_};
  }
  OffsetCubics operator()(OffsetCubics path) const {
    for (PlaneCubic& cubic : path.cubics)
      for (auto& point : cubic) point = (*this)(point);
    return path;
  }
  /// To nine digits, of which nobody sees the last ones.
  std::array<double, 2> near(const std::array<Rational, 2>& point) const {
    const auto at = (*this)(point);
    const auto rounded = [](const Rational& x) {
      return std::stod(fmt::format("{:.9g}", static_cast<double>(x)));
    };
    return {rounded(at[0]), rounded(at[1])};
  }
  std::array<double, 2> near(const std::array<Decimal, 2>& point) const {
    return near(std::array{parse_rational(point[0].value), parse_rational(point[1].value)});
  }

  /// All of it, with a margin.
  std::string view_box() const {
    const Rational margin = std::max(width(0), width(1)) / 20;
    const auto number = [&](const Rational& x) { return static_cast<double>(x * scale_); };
    return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}", number(least_[0] - margin),
                       -number(most_[1] + margin), number(width(0) + 2 * margin),
                       number(width(1) + 2 * margin));
  }

 private:
  void add(const std::vector<OffsetCubics>& paths) {
    for (const OffsetCubics& path : paths)
      for (const PlaneCubic& cubic : path.cubics)
        for (const auto& point : cubic)
          for (std::size_t k = 0; k < 2; ++k) {
            const Rational x = point[k] - origin_[k];
            least_[k] = std::min(least_[k], x);
            most_[k] = std::max(most_[k], x);
          }
  }
  Rational width(std::size_t k) const { return most_[k] - least_[k]; }
  /// So many that x > 0 has before the point; 0 or less for x < 1.
  static long digits(const Rational& x) {
    const auto count = [](const Rational& y) {
      return static_cast<long>(to_string(Rational(floor(y))).size());
    };
    return x < 1 ? 1 - count(1 / x) : count(x);
  }

  std::array<Rational, 2> origin_;
  std::array<Rational, 2> least_;  ///< of all, from the origin
  std::array<Rational, 2> most_;   ///< likewise
  Rational scale_ = 1;
};

/// A place that the page marks.
struct Mark {
  std::string kind;  ///< "cusp", "meets itself", "touches itself", "cut", or "joint" of an envelope
  std::size_t layer;
  std::string where;  ///< t of the path
  std::array<Decimal, 2> at;
};

/// What a page is made of.
struct PageParts {
  std::string name;
  std::string kind;  ///< of the path
  OffsetPicture picture;
  std::vector<std::string> labels;  ///< of the layers
  std::vector<Mark> marks;
  std::size_t undecided;  ///< how many places the report has that are no marks
  std::string measures;   ///< a section
  std::string report;
};

std::string shape_of(const Mark& mark) {
  if (mark.kind == "cusp") return R"(<circle r="5"/>)";
  if (mark.kind == "cut" || mark.kind == "joint")
    return R"(<rect x="-4.5" y="-4.5" width="9" height="9"/>)";
  return R"(<path d="M-5,-5L5,5M-5,5L5,-5"/>)";
}

std::string words_of(const OffsetAnswer::TrimmedPiece& piece, const BoundaryEnd& end) {
  return in_words(end, piece.is_join ? "the join at " : "", on_page);
}

/// Where parts of a branch meet at a cut, or it ends at one.
void add_cuts(std::vector<Mark>& marks, std::size_t layer, const OffsetAnswer::Branch& branch) {
  const auto& pieces = branch.pieces;
  const std::size_t count = pieces.size();
  if (!branch.is_closed && pieces[0].is_cut_from)
    marks.push_back({"cut", layer, words_of(pieces[0], pieces[0].from), pieces[0].from.at});
  for (std::size_t k = 0; k < count; ++k) {
    const auto& piece = pieces[k];
    const bool goes_on = k + 1 < count || branch.is_closed;
    const auto& next = pieces[(k + 1) % count];
    if (!piece.is_cut_to && !(goes_on && next.is_cut_from)) continue;
    std::string where = words_of(piece, piece.to);
    if (goes_on) where += " and " + words_of(next, next.from);
    marks.push_back({"cut", layer, where, piece.to.at});
  }
}

std::vector<Mark> marks_of(const OffsetAnswer& answer) {
  std::vector<Mark> marks;
  for (std::size_t k = 0; k < answer.offsets.size(); ++k) {
    for (const auto& [t, turns_back, at] : answer.offsets[k].cusps)
      marks.push_back({"cusp", k, at_place(t, on_page), at});
    for (const auto& [first, second, at, touches] : answer.offsets[k].meetings)
      marks.push_back({touches ? "touches itself" : "meets itself", k,
                       in_words(first, on_page) + " and " + in_words(second, on_page), at});
  }
  for (std::size_t k = 0; k < answer.trimmed.size(); ++k)
    for (const auto& branch : answer.trimmed[k].branches) add_cuts(marks, k, branch);
  return marks;
}

/// Where parts of the boundary end, and whole sides have cusps.
std::vector<Mark> marks_of(const EnvelopeAnswer& answer) {
  std::vector<Mark> marks;
  for (const auto& branch : answer.branches)
    for (const auto& piece : branch.pieces)
      marks.push_back({"joint", 0, in_words(piece.from, "", on_page), piece.from.at});
  return marks;
}

std::string text_of(const std::string& text) { return element_text(printable(abridged(text))); }

/// Of a table, all cells text.
std::string table_row(const std::vector<std::string>& cells) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += "<td>" + text_of(cell) + "</td>";
  return row + "</tr>\n";
}

std::string table(const std::string& heads, const std::string& rows) {
  return "<div class=\"wide\"><table><thead><tr>" + heads + "</tr></thead><tbody>\n" + rows +
         "</tbody></table></div>\n";
}

std::string paths_text(const std::string& kind, std::size_t layer, const Canvas& canvas,
                       const std::vector<OffsetCubics>& paths) {
  std::string text;
  for (const OffsetCubics& path : paths)
    text += fmt::format("<path class=\"{} layer-{}\" d=\"{}\"/>\n", kind, layer,
                        path_data(canvas(path)));
  return text;
}

/// Each layer with a colour of its own, as far as there are.
std::string colour(std::size_t layer) {
  constexpr std::array<const char*, 8> colours{"#0072b2", "#d55e00", "#009e73", "#b04a8a",
                                               "#b58900", "#3a9bdc", "#8c564b", "#7f7f7f"};
  return colours[layer % colours.size()];
}

std::string drawing_text(const PageParts& parts, const Canvas& canvas) {
  const OffsetPicture& picture = parts.picture;
  std::string text = fmt::format(
      "<svg id=\"drawing\" viewBox=\"{}\" tabindex=\"0\" role=\"img\" aria-label=\"The path and "
      "its "
      "offsets\">\n",
      canvas.view_box());
  for (const OffsetCubics& path : picture.path)
    text += fmt::format("<path class=\"curve\" d=\"{}\"/>\n", path_data(canvas(path)));
  for (std::size_t k = 0; k < picture.layers.size(); ++k)
    text += fmt::format("<g class=\"of-{}\" style=\"--colour: {}\">\n{}{}</g>\n", k, colour(k),
                        paths_text("whole", k, canvas, picture.layers[k].whole),
                        paths_text("offset", k, canvas, picture.layers[k].paths));
  for (const Mark& mark : parts.marks) {
    const auto at = canvas.near(mark.at);
    text += fmt::format(
        "<g class=\"of-{0}\" style=\"--colour: {1}\"><g class=\"mark\" data-layer=\"{0}\" "
        "data-x=\"{2}\" data-y=\"{3}\" transform=\"translate({2} {3})\">{4}<title>{5}</title></g>"
        "</g>\n",
        mark.layer, colour(mark.layer), at[0], at[1], shape_of(mark),
        text_of(fmt::format("{}, {}: {}, {}", parts.labels[mark.layer], mark.kind, mark.where,
                            point_in_words(mark.at, on_page))));
  }
  return text + "<path id=\"normal\" d=\"\"/><circle id=\"place\" r=\"1\"/>\n</svg>\n";
}

/// What is shown, and the keys for marks.
std::string tools_text(const PageParts& parts) {
  std::string text =
      "<div class=\"tools\"><span><button id=\"nearer\" aria-label=\"nearer\">+</button> <button "
      "id=\"farther\" aria-label=\"farther\">−</button> <button id=\"all\">all</button></span>\n";
  bool is_trimmed = false;
  for (std::size_t k = 0; k < parts.labels.size(); ++k) {
    is_trimmed = is_trimmed || !parts.picture.layers[k].whole.empty();
    text += fmt::format(
        "<label><input type=\"checkbox\" id=\"show-{0}\" data-shows=\".of-{0}\" checked "
        "autocomplete=\"off\"> <span class=\"swatch\" style=\"--colour: {1}\"></span> "
        "{2}</label>\n",
        k, colour(k), text_of(parts.labels[k]));
  }
  if (is_trimmed)
    text +=
        "<label><input type=\"checkbox\" id=\"show-whole\" data-shows=\".whole\" checked "
        "autocomplete=\"off\"> what is cut away, dashed</label>\n";
  return text + "</div>\n";
}

std::string measures_text(const OffsetAnswer& answer) {
  std::string rows;
  const auto add = [&](const Rational& d, const std::string& what, const auto& x) {
    rows += table_row({in_words(d, on_page), what, in_words(x.length, on_page),
                       x.area ? in_words(*x.area, on_page) : "open"});
  };
  for (const auto& part : answer.offsets) add(part.distance, "all of it", part);
  for (const auto& part : answer.trimmed) {
    if (part.branches.empty())
      rows += table_row({in_words(part.distance, on_page), "nothing is left", "0", ""});
    for (std::size_t k = 0; k < part.branches.size(); ++k)
      add(part.distance, fmt::format("branch {}", k + 1), part.branches[k]);
  }
  if (rows.empty()) return "";
  return "<section id=\"measures\"><h2>Lengths and signed areas</h2>\n" +
         table("<th>d</th><th></th><th>length</th><th>area</th>", rows) + "</section>\n";
}

std::string marks_text(const PageParts& parts) {
  std::string rows;
  for (const Mark& mark : parts.marks)
    rows += table_row(
        {parts.labels[mark.layer], mark.kind, mark.where, point_in_words(mark.at, on_page)});
  if (rows.empty()) return "";
  return "<section id=\"marks\"><h2>Marks: rings at cusps, crosses where an offset meets itself, "
         "squares where it is cut or parts join</h2>\n" +
         table("<th></th><th></th><th>t of the path</th><th>point</th>", rows) + "</section>\n";
}

std::size_t undecided(const OffsetAnswer& answer) {
  std::size_t count = 0;
  for (const auto& part : answer.offsets)
    count += part.undecided.size() + (part.is_cut_off ? 1 : 0);
  for (const auto& part : answer.trimmed) count += part.undecided.size();
  return count;
}

/// For each layer its label and, as lists, t, the point, where this is drawn, where that of the
/// path is, and 1 on joins.
std::string data_text(const PageParts& parts, const Canvas& canvas) {
  JsonOutput data = JsonOutput::array();
  for (std::size_t k = 0; k < parts.labels.size(); ++k) {
    const auto json = [&](const OffsetSample& sample) -> JsonOutput {
      const auto at = canvas.near(sample.at);
      const auto of = canvas.near(sample.of);
      JsonOutput row{shown(sample.t),
                     with_minus_sign(sample.at[0].value),
                     with_minus_sign(sample.at[1].value),
                     at[0],
                     at[1],
                     of[0],
                     of[1]};
      if (sample.is_join) row.push_back(1);
      return row;
    };
    data.push_back({{"label", abridged(parts.labels[k])},
                    {"samples", array_of(parts.picture.layers[k].samples, json)}});
  }
  return data.dump();
}

std::string tolerance_text(const OffsetPicture& picture) {
  ToleranceRange within;
  within.add(picture.path);
  for (const auto& layer : picture.layers) {
    within.add(layer.paths);
    within.add(layer.whole);
  }
  return in_words(within);
}

std::string page_of(const PageParts& parts) {
  const Canvas canvas(parts.picture);
  const std::string name = text_of(parts.name);
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
      "'unsafe-inline'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      name + "</title>\n<style>";
  page += offset_page_style;
  page += "</style>\n</head>\n<body>\n<header><h1>" + name + "</h1>\n<p>" + text_of(parts.kind) +
          "</p></header>\n<section>\n" + drawing_text(parts, canvas) + tools_text(parts) +
          "<output id=\"at\">Move over the drawing, or click: t of the path and the point, in "
          "certain digits. Drag to move, turn the wheel to zoom; arrows, +, − and 0 do so, too."
          "</output>\n";
  page +=
      fmt::format("<p class=\"soft\">Drawn by cubics within {} of the exact curves, proved.</p>\n",
                  tolerance_text(parts.picture));
  if (parts.undecided > 0)
    page += fmt::format("<p id=\"undecided\">Undecided, and not marked: {}, in the report.</p>\n",
                        counted(parts.undecided, "place"));
  page += "</section>\n" + parts.measures + marks_text(parts) +
          "<section><h2>Report</h2>\n<pre id=\"report\">" + element_text(abridged(parts.report)) +
          "</pre></section>\n<script type=\"application/json\" id=\"data\">" +
          data_text(parts, canvas) + "</script>\n<script>";
  page += offset_page_script;
  return page + "</script>\n</body>\n</html>\n";
}

}  // namespace

std::string to_page(const OffsetAnswer& answer) {
  PageParts parts{answer.path.name.empty() ? "Offsets" : answer.path.name,
                  heading(NamedPath("", answer.path.path)),
                  picture(answer),
                  {},
                  marks_of(answer),
                  undecided(answer),
                  measures_text(answer),
                  to_text(answer)};
  const auto add = [&](const Rational& d) {
    parts.labels.push_back("d = " + in_words(d, on_page));
  };
  for (const auto& part : answer.offsets) add(part.distance);
  for (const auto& part : answer.trimmed) add(part.distance);
  for (const auto& part : answer.both) add(part.distance);
  return page_of(parts);
}

std::string to_page(const EnvelopeAnswer& answer) {
  return page_of(
      {answer.name.empty() ? "Envelope" : answer.name,
       fmt::format("envelope of discs along {}", counted(answer.segments.size(), "curve")),
       picture(answer),
       {"envelope"},
       marks_of(answer),
       answer.undecided.size(),
       "",
       to_text(answer)});
}

}  // namespace phrame
