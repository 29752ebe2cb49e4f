#include "phrame/io/write/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/io/write/check.hpp"
#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/page_template.hpp"
#include "phrame/io/write/passage.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0 {
namespace {

/// What of a formula is still for reading,
constexpr std::size_t longest_formula = 20'000;
/// and of a text.
constexpr std::size_t most_lines = 60;
/// What a page is to weigh at most, and of that what is neither its program nor listed.
constexpr std::size_t most_bytes = 2'000'000;
constexpr std::size_t other_bytes = 40'000;

/// How the page shows a frame of the table.
JsonOutput shown_frame(TabulatedFrame frame, bool is_closed) {
  const auto json = [](const char* what, const char* second, const char* third, const char* e2,
                       const char* e3) {
    return JsonOutput{{"what", what}, {"second", second}, {"third", third}, {"names", {e2, e3}}};
  };
  switch (frame) {
    case TabulatedFrame::rmf:
      return json("rotation-minimizing", "f2", "f3", "f₂", "f₃");
    case TabulatedFrame::euler_rodrigues:
      return json("Euler–Rodrigues", "e2", "e3", "e₂", "e₃");
    case TabulatedFrame::frenet:
      return json("Frenet", "n", "b", "n", "b");
    case TabulatedFrame::up:
      return json("of the vector v", "up2", "up3", "e₂", "e₃");
    case TabulatedFrame::signed_frenet:
      return json("Frenet, signed", "sn", "sb", "n", "b");
    case TabulatedFrame::mtf:
    case TabulatedFrame::exact_mtf:
      break;
  }
  return json(is_closed ? "minimal twist, closed" : "minimal twist", "exact_mtf2", "exact_mtf3",
              "m₂", "m₃");
}

bool is_infinite(const PageAnswer& page, const std::string& column) {
  const auto& list = page.turns.infinite;
  const Plotted quantity = column == "torsion" ? Plotted::torsion : Plotted::curvature;
  return (column == "torsion" || column == "curvature") &&
         std::find(list.begin(), list.end(), quantity) != list.end();
}

/// The columns that are drawn over t, where the table has them.
JsonOutput plots_of(const PageAnswer& page) {
  static const std::vector<std::vector<std::string>> known{
      {"error", "error", "of the given frames, radians, to about nine digits"},
      {"theta", "θ", "the angle of the rotation-minimizing frame, radians"},
      {"theta_rate", "θ′", "its rate dθ/dt"},
      {"curvature", "κ", "curvature"},
      {"torsion", "τ", "torsion"},
      {"speed", "|r′|", "parametric speed"},
      {"s", "s", "arc length from the start"}};
  JsonOutput plots = JsonOutput::array();
  for (const auto& plot : known)
    for (const std::string& column : page.table.columns)
      if (column == plot[0])
        plots.push_back({{"column", column},
                         {"label", plot[1]},
                         {"what", plot[2]},
                         {"infinite", is_infinite(page, column)}});
  return plots;
}

bool is_to_erf(const AngleAnswer& angle) { return angle.reference == Reference::euler_rodrigues; }

bool is_ph_curve(const AngleAnswer& angle) {
  return is_to_erf(angle) && angle.path.path.segments().size() == 1;
}

/// What is known of the plots between the rows.
std::string said_of_plots(const PageAnswer& page) {
  const bool is_ph = is_to_erf(page.angle);
  const char* quantities = is_ph ? "θ, θ′, κ, τ and |r′|" : "κ and τ";
  if (!page.turns.are_all)
    return fmt::format("Between its rows, {} may go farther than is seen.", quantities);
  if (page.turns.slack > 0)
    return fmt::format("Between its rows, {} go no farther than by {} of the greatest: proved.",
                       quantities, page.turns.slack);
  return fmt::format(
      "Where {} are greatest and least there are rows: all zeros of their derivatives are known.",
      quantities);
}

/// At joints the limits from the left of what jumps there, for drawing.
JsonOutput json_of_jumps(const PageAnswer& page) {
  JsonOutput list = JsonOutput::array();
  for (const PageJump& jump : page.jumps) {
    JsonOutput before = JsonOutput::object();
    for (std::size_t k = 0; k < jump.before.size(); ++k) {
      const double x = jump.before[k];
      const double after = page.table.rows[jump.row][k];
      if (x == after || (std::isnan(x) && std::isnan(after))) continue;
      before[page.table.columns[k]] =
          std::isnan(x) ? JsonOutput() : JsonOutput(std::stod(fmt::format("{:.8g}", x)));
    }
    list.push_back({jump.row, before});
  }
  return list;
}

JsonOutput json_of_poles(const PoleTable& table, long segments) {
  JsonOutput rows = JsonOutput::array();
  const std::vector<PoleTexts> texts = texts_of(table);
  for (std::size_t k = 0; k < texts.size(); ++k)
    rows.push_back({{"pole", texts[k].pole},
                    {"residue", texts[k].residue},
                    {"re", to_string(table.rows[k].re.ball, 12)},
                    {"im", to_string(table.rows[k].im.ball, 12)}});
  return {{"count", table.poles}, {"end", segments}, {"rows", rows}};
}

/// Of a closed path.
void add_holonomy(JsonOutput& page, const std::optional<Decimal>& holonomy) {
  if (holonomy)
    page["said"].push_back(fmt::format(
        "The curve is closed, with holonomy {} {}: by this angle about the tangent the "
        "rotation-minimizing frame comes back turned. Arrows show how frames start and come back.",
        holonomy->radius == "0" ? "=" : "≈", holonomy->value));
}

std::string segments_said(std::size_t count) {
  return fmt::format("t goes from 0 to {}: segment k, from 1 on, is the part from k − 1 to k.",
                     count);
}

/// What t is of a path that is not PH.
std::string parameter_said(const Path& path) {
  if (path.segments().size() > 1) return segments_said(path.segments().size());
  const auto* curve = std::get_if<ExpressionCurve>(&path.segments().front());
  if (curve == nullptr) return "t goes from 0 to 1.";
  const std::string& s = curve->variable();
  return fmt::format("t goes from 0 to 1 while {} of the formulas goes from {} to {}, evenly.", s,
                     printable(to_string(curve->from(), s)), printable(to_string(curve->to(), s)));
}

/// Where frames start, if that is the rule.
void say_start(JsonOutput& page, const FrameStart& start) {
  if (const auto* least = std::get_if<LeastRotation>(&start))
    page["said"].push_back(fmt::format("At the start {}.", to_sentence(*least)));
}

/// What the angle is, of PH curves by their Euler–Rodrigues frame.
std::string closed_form_said(JsonOutput& page, const AngleAnswer& angle) {
  std::string said = "θ is the angle from e₂ of the Euler–Rodrigues frame to f₂. ";
  if (angle.formulas.empty())
    said += fmt::format("It has a closed form on each of the {} segments. ",
                        angle.path.path.segments().size());
  else if (const std::string latex = to_latex(angle); latex.size() <= longest_formula)
    page["latex"].push_back(latex);
  else
    said += "Its closed form is too long for a page: phrame angle prints it. ";
  return said +
         "That the derivative of the formula is θ′ = −2h/σ was checked exactly, for this curve.";
}

/// What it is by the frame of a vector.
std::string integral_said(JsonOutput& page, const AngleAnswer& angle) {
  std::string said = fmt::format(
      "θ is the angle to f₂ from e₂ = v × e₁/|v × e₁|, of the vector v = {}. ", shown(*angle.up));
  if (!angle.path.path.is_ph())
    return said +
           "The curve is not Pythagorean-hodograph, and θ has no closed form: it is the integral "
           "of −e₂′·e₃, enclosed by Taylor polynomials whose errors are proved.";
  if (const std::string latex = to_latex(angle);
      !angle.formulas.empty() && latex.size() <= longest_formula)
    page["latex"].push_back(latex);
  return said + "That the derivative of its closed form is θ′ was checked exactly, for this curve.";
}

void add_angle(JsonOutput& page, const AngleAnswer& angle) {
  const Path& path = angle.path.path;
  page["heading"] = heading(NamedPath{"", path});
  page["said"] = {is_to_erf(angle) ? closed_form_said(page, angle) : integral_said(page, angle)};
  say_start(page, angle.start);
  if (!is_to_erf(angle) || path.segments().size() > 1) page["said"].push_back(parameter_said(path));
  if (is_ph_curve(angle) && !angle.formulas.empty() && angle.formulas.front()->poles)
    page["poles"] = json_of_poles(*angle.formulas.front()->poles, 1);
  add_holonomy(page, angle.holonomy);
}

JsonOutput download(const std::string& name, const char* type, const std::string& text) {
  return {{"name", name}, {"type", type}, {"text", text}};
}

/// What can be taken along, as much of it as there is room for; the commands that write the rest
/// are said.
void add_downloads(JsonOutput& page, const PageAnswer& answer, const std::string& name) {
  const std::string stem = prefix_from(name);
  std::size_t room = most_bytes - other_bytes;
  for (const std::string_view piece : page_template()) room -= std::min(room, piece.size());
  room -= std::min(room, page["csv"].get<std::string>().size());
  page["downloads"] = JsonOutput::array();
  std::vector<std::string> missing;
  const auto add = [&](const std::string& file, const char* type, const char* command,
                       const std::string& text) {
    // Quotes and line breaks are two characters in JSON.
    const std::size_t size = JsonOutput(text).dump().size();
    if (size > room) {
      missing.emplace_back(command);
      return;
    }
    room -= size;
    page["downloads"].push_back(download(file, type, text));
  };
  add(stem + "-angle.json", "application/json", "phrame angle --print json", to_json(answer.angle));
  if (answer.certificate)
    add(stem + ".cert", "application/json", "phrame certify",
        write_certificate(*answer.certificate, name, answer.table.near));
  else if (is_ph_curve(answer.angle))
    missing.emplace_back("phrame certify");
  if (answer.compiled)
    add(stem + ".h", "text/x-c", "phrame compile", to_c_header(*answer.compiled, stem));
  else
    missing.emplace_back("phrame compile");
  if (!answer.totals) missing.emplace_back("phrame totals");
  if (missing.empty()) return;
  page["missing"] =
      fmt::format("Too long for a page is what these print: {}.", fmt::join(missing, ", "));
}

/// The first lines of a long text, and how many there are more.
std::string first_lines(const std::string& text, const char* command) {
  std::size_t end = 0;
  for (std::size_t line = 0; line < most_lines; ++line) {
    end = text.find('\n', end);
    if (end == std::string::npos) return text;
    ++end;
  }
  const auto more = std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), '\n');
  if (more < 5) return text;
  return text.substr(0, end) + fmt::format("… and {} lines more: {} prints them\n", more, command);
}

void add_fact(JsonOutput& facts, const char* title, const char* command, const std::string& text) {
  facts.push_back({{"title", title}, {"text", first_lines(abridged(text), command)}});
}

JsonOutput json_of(const PageAnswer& answer) {
  const std::string& name = answer.angle.path.name;
  JsonOutput page{{"phrame", "page/1"}, {"version", version}, {"name", name}};
  page["latex"] = JsonOutput::array();
  add_angle(page, answer.angle);
  page["closed"] = answer.is_closed;
  page["frames"] = JsonOutput::array();
  for (const TabulatedFrame frame : answer.frames)
    page["frames"].push_back(shown_frame(frame, answer.is_closed));
  JsonOutput facts = JsonOutput::array();
  if (answer.check) {
    page["frames"].push_back({{"what", "given"},
                              {"second", "g2"},
                              {"third", "g3"},
                              {"names", {"given f₂", "given f₃"}},
                              {"shown", true}});
    add_fact(facts, "The given frames", "phrame check", to_text(*answer.check, TableReading{}));
  }
  page["plots"] = plots_of(answer);
  page["said_of_plots"] = said_of_plots(answer);
  page["jumps"] = json_of_jumps(answer);
  if (answer.totals)
    add_fact(facts, "Length, twist, curvature and energies", "phrame totals",
             to_text(*answer.totals));
  if (answer.classification)
    add_fact(facts, "Decisions, by algebra", "phrame classify", to_text(*answer.classification));
  add_fact(facts, "Polynomials and special points", "phrame info", to_text(answer.info));
  page["facts"] = std::move(facts);
  page["csv_name"] = prefix_from(name) + "-frames.csv";
  page["csv"] = to_csv(answer.table);
  add_downloads(page, answer, name);
  return page;
}

/// JSON in a script element, which "</script" would end and "<!--" would change.
std::string inert(const std::string& json) {
  std::string result;
  for (const char c : json) {
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  }
  return result;
}

void replace_once(std::string& text, std::string_view mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

}  // namespace

bool has_pages() { return !page_template().empty(); }

std::string to_page(const PageAnswer& answer) {
  if (!has_pages())
    throw DomainError("page: this phrame was built without npm, which bundles what a page needs");
  const JsonOutput page = json_of(answer);
  std::string html;
  for (const std::string_view piece : page_template()) html += piece;
  // The data stand behind the title, and what is put in may contain either mark.
  replace_once(html, "<!--data-->", inert(page.dump()));
  const std::string name = page["name"].get<std::string>();
  replace_once(html, "<!--title-->",
               element_text(name.empty() ? page["heading"].get<std::string>() : name));
  return html;
}

}  // namespace phrame
