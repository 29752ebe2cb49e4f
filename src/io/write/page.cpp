#include "phrame/io/write/page.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/io/write/check.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/page_template.hpp"
#include "phrame/io/write/passage.hpp"
#include "phrame/io/write/pole_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/version.hpp"

namespace phrame {
namespace {

/// What of a formula is still for reading.
constexpr std::size_t longest_formula = 20'000;

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
    case TabulatedFrame::mtf:
    case TabulatedFrame::exact_mtf:
      break;
  }
  return json(is_closed ? "minimal twist, closed" : "minimal twist", "exact_mtf2", "exact_mtf3",
              "m₂", "m₃");
}

/// The columns that are drawn over t, where the table has them.
JsonOutput plots_of(const FrameTable& table) {
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
    for (const std::string& column : table.columns)
      if (column == plot[0])
        plots.push_back({{"column", column}, {"label", plot[1]}, {"what", plot[2]}});
  return plots;
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

void add_angle(JsonOutput& page, const AngleAnswer& angle) {
  const auto& [name, path, near, notes] = angle.path;
  page["heading"] = heading("", path.segments().front());
  if (!path.is_curve()) page["heading"] = heading(NamedPath{"", path, near});
  std::string said = "θ is the angle from e₂ of the Euler–Rodrigues frame to f₂. ";
  if (angle.formulas.empty())
    said += fmt::format("It has a closed form on each of the {} segments.", path.segments().size());
  else if (const std::string latex = to_latex(angle); latex.size() <= longest_formula)
    page["latex"].push_back(latex);
  else
    said += "Its closed form is too long for a page: phrame angle prints it. ";
  said += "That the derivative of the formula is θ′ = −2h/σ was checked exactly, for this curve.";
  page["said"] = {said};
  if (path.is_curve() && !angle.formulas.empty() && angle.formulas.front().poles)
    page["poles"] = json_of_poles(*angle.formulas.front().poles, 1);
  add_holonomy(page, angle.holonomy);
}

void add_angle(JsonOutput& page, const SmoothAngleAnswer& angle) {
  page["heading"] = heading(NamedSmoothPath{"", angle.path.path});
  page["said"] = {fmt::format(
      "The curve is not Pythagorean-hodograph, and θ has no closed form: it is the integral of "
      "−e₂′·e₃ of the frame e₂ = v × e₁/|v × e₁| of the vector v = {}, enclosed by Taylor "
      "polynomials whose errors are proved.",
      shown(angle.up))};
  add_holonomy(page, angle.holonomy);
}

JsonOutput download(const std::string& name, const char* type, const std::string& text) {
  return {{"name", name}, {"type", type}, {"text", text}};
}

JsonOutput downloads_of(const PageAnswer& page, const std::string& name) {
  const std::string stem = prefix_from(name);
  JsonOutput list = JsonOutput::array();
  list.push_back(
      download(stem + "-angle.json", "application/json",
               std::visit([](const auto& angle) { return to_json(angle); }, page.angle)));
  if (page.certificate)
    list.push_back(download(stem + ".cert", "application/json",
                            write_certificate(*page.certificate, name, page.table.near)));
  if (page.compiled)
    list.push_back(download(stem + ".h", "text/x-c", to_c_header(*page.compiled, stem)));
  return list;
}

void add_fact(JsonOutput& facts, const char* title, const std::string& text) {
  facts.push_back({{"title", title}, {"text", abridged(text)}});
}

JsonOutput json_of(const PageAnswer& answer) {
  const std::string& name = std::visit(
      [](const auto& angle) -> const std::string& { return angle.path.name; }, answer.angle);
  JsonOutput page{{"phrame", "page/1"}, {"version", version}, {"name", name}};
  page["latex"] = JsonOutput::array();
  std::visit([&](const auto& angle) { add_angle(page, angle); }, answer.angle);
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
    add_fact(facts, "The given frames", to_text(*answer.check, TableReading{}));
  }
  page["plots"] = plots_of(answer.table);
  if (answer.totals)
    add_fact(facts, "Length, twist, curvature and energies", to_text(*answer.totals));
  if (answer.classification)
    add_fact(facts, "Decisions, by algebra", to_text(*answer.classification));
  add_fact(facts, "Polynomials and special points",
           std::visit([](const auto& info) { return to_text(info); }, answer.info));
  page["facts"] = std::move(facts);
  page["downloads"] = downloads_of(answer, name);
  page["csv_name"] = prefix_from(name) + "-frames.csv";
  page["csv"] = to_csv(answer.table);
  return page;
}

/// Text of an element.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
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
               escaped(name.empty() ? page["heading"].get<std::string>() : name));
  return html;
}

}  // namespace phrame
