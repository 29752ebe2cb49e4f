#include "phrame/answer/angle.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/path_angle.hpp"

namespace phrame {
namespace {

AngleFormula formula(const RmfAngle& angle, const AngleQuery& query) {
  AngleFormula formula{
      angle.rate(), angle.angle_to_erf(), angle.bend(), angle.antiderivative(), {}, {}};
  formula.other = other_form(formula.antiderivative, query.style);
  if (query.most_poles) formula.poles = pole_table(formula.angle_to_erf, *query.most_poles);
  return formula;
}

}  // namespace

AngleValue rounded_angle(const Rational& t, const Real& theta, long digits) {
  return {t, rounded(theta, "theta at t = " + as_written(t), digits)};
}

AngleAnswer answer(NamedPhPath named, const AngleQuery& query) {
  PathAngle angle(named.path, query.reference, query.form);
  if (query.route != Route::automatic) angle.take(query.route);
  const PhPath& path = named.path;
  const FrameAngle start = start_angle(query.start, path, query.reference);
  AngleAnswer answer{named, query.reference, query.start, start, {}, {}, query.digits, {}, {}};
  if (query.wants_formula)
    for (std::size_t k = 0; k < path.segments().size(); ++k)
      answer.formulas.push_back(formula(*angle.closed_form(k), query));
  for (const Rational& t : query.at)
    answer.values.push_back(rounded_angle(t, angle.value(t, start), query.digits));
  if (path.is_curve()) return answer;
  answer.total = rounded(angle.value(path.end()), "the total angle", query.digits);
  if (query.reference == Reference::frenet) return answer;
  if (const auto holonomy = angle.holonomy())
    answer.holonomy = rounded(*holonomy, "holonomy", query.digits);
  return answer;
}

}  // namespace phrame
