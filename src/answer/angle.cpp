#include "phrame/answer/angle.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0 {
namespace {

AngleFormula formula(const RmfAngle& angle, const AngleQuery& query) {
  // What the antiderivative finds helps to reduce the rate.
  const Antiderivative& angle_to_erf = angle.angle_to_erf();
  AngleFormula formula{angle.rate(), angle_to_erf, angle.bend(), angle.antiderivative(), {}, {}};
  formula.other = other_form(formula.antiderivative, query.style);
  if (query.most_poles) formula.poles = pole_table(formula.angle_to_erf, *query.most_poles);
  return formula;
}

/// Is it known of every number whether it is rational, or 0?
bool is_in_closed_form(const PathAngle& angle) {
  return angle.reference() != Reference::up && angle.path().has_erf();
}

void add_formulas(AngleAnswer& answer, const PathAngle& angle, const AngleQuery& query) {
  answer.formulas.reserve(angle.path().segments().size());
  for (std::size_t k = 0; k < angle.path().segments().size(); ++k) {
    const RmfAngle* closed = angle.closed_form(k);
    answer.formulas.push_back(closed == nullptr
                                  ? nullptr
                                  : std::make_shared<const AngleFormula>(formula(*closed, query)));
  }
}

std::variant<Rational, Decimal> shown_parameter(const Real& x, const std::string& name,
                                                long digits) {
  if (x.exact()) return *x.exact();
  return rounded(x, name, digits);
}

}  // namespace

std::vector<AngleValue> angle_values(
    const NamedPath& path, const AngleValuesQuery& query,
    const std::function<Real(const Place& at)>& theta,
    const std::function<Decimal(const Real& x, const std::string& what)>& decimal) {
  const bool is_t = query.by == ParameterKind::t;
  std::vector<AngleValue> values;
  for (const auto& [asked, at] : Parametrization(path, query.by).points(query.at, query.samples)) {
    const std::string where =
        (is_t ? "t = " : "the parameter asked for, ") +
        (asked.exact() ? as_written(*asked.exact()) : to_string(asked.enclose(64), 9));
    AngleValue found{shown_parameter(parameter(at), "t at " + where, query.digits),
                     decimal(theta(at), "theta at " + where)};
    if (!is_t) found.asked = shown_parameter(asked, "the parameter asked for", query.digits);
    values.push_back(std::move(found));
  }
  return values;
}

AngleAnswer answer(const NamedPath& named, const AngleQuery& query) {
  PathAngle angle = angle_to(query.up, named.path, query.reference, query.form);
  if (query.route != Route::automatic) angle.set_route(query.route);
  const bool is_closed_form = is_in_closed_form(angle);
  const auto decimal = [&](const Real& x, const std::string& what) {
    return is_closed_form ? rounded(x, what, query.digits) : rounded_or_zero(x, what, query.digits);
  };
  const StartAngle start = phrame::start_angle(query.start, angle);
  AngleAnswer answer{.path = named,
                     .reference = angle.reference(),
                     .up = {},
                     .start = query.start,
                     .start_angle = FrameAngle(),
                     .is_zero = angle.is_zero(),
                     .is_straight = !is_closed_form && is_straight(named.path),
                     .formulas = {},
                     .values = {},
                     .by = query.by,
                     .digits = query.digits,
                     .total = {},
                     .holonomy = {},
                     .no_holonomy = {}};
  if (start.exact)
    answer.start_angle = *start.exact;
  else
    answer.start_angle = decimal(start.value, "theta at t = 0");
  if (answer.reference == Reference::up) answer.up = angle.up();
  if (query.wants_formula) add_formulas(answer, angle, query);
  answer.values = angle_values(
      named, {query.at, query.by, query.samples, query.digits},
      [&](const Place& at) { return angle.value(at, start); }, decimal);
  if (is_closed_form && goes_on(named.path)) return answer;
  answer.total = decimal(angle.value(named.path.end()), "the total angle");
  if (answer.reference == Reference::frenet) return answer;
  try {
    if (const auto holonomy = angle.holonomy()) answer.holonomy = decimal(*holonomy, "holonomy");
  } catch (const Undecided& undecided) {
    if (is_closed_form) throw;
    answer.no_holonomy = undecided.what();
  }
  return answer;
}

}  // namespace phrame
