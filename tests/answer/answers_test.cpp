#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/check.hpp"
#include "phrame/answer/classification.hpp"
#include "phrame/answer/compiled.hpp"
#include "phrame/answer/coq.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/identification.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/integral.hpp"
#include "phrame/answer/minimal_twist.hpp"
#include "phrame/answer/totals.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

// One query of each kind, as numbers: on the quintic of [Farouki 2003], whose angles are known to
// 40 digits, and in halves of it, which must answer the same.

using namespace phrame;
using namespace phrame::test;

namespace {

NamedPhPath whole() { return {"quintic", PhPath(quintic)}; }
NamedPhPath halves() { return {"halves", cut(quintic, {Rational(1, 2)})}; }

std::string truth(const char* frame, const char* t) {
  return farouki_2003()["quintic"][frame][t].get<std::string>();
}

/// To so many digits the known number.
void check_angle(const AngleValue& value, const std::string& known, long digits) {
  check_rounded(value.theta.value, value.theta.radius, known, digits, 40);
}

}  // namespace

TEST_CASE("answers: the angle, of the curve and of its halves") {
  AngleQuery query;
  query.at = {Rational(1, 2), 1};
  query.digits = 30;
  const AngleAnswer answer = phrame::answer(whole(), query);
  check_angle(answer.values.at(0), truth("theta_RMF_rel_ERF", "1/2"), 30);
  check_angle(answer.values.at(1), truth("theta_RMF_rel_ERF", "1"), 30);
  CHECK(answer.formulas.size() == 1);
  CHECK(differentiate(answer.formulas[0]->antiderivative) == answer.formulas[0]->rate);
  CHECK_FALSE(answer.total.has_value());
  query.at = {1, 2};
  const AngleAnswer in_halves = phrame::answer(halves(), query);
  CHECK(in_halves.values.at(0).theta.value == answer.values.at(0).theta.value);
  CHECK(in_halves.values.at(1).theta.value == answer.values.at(1).theta.value);
  CHECK(in_halves.total->value == answer.values.at(1).theta.value);
  CHECK_FALSE(in_halves.holonomy.has_value());
  query.wants_formula = false;
  CHECK(phrame::answer(whole(), query).formulas.empty());
  query.reference = Reference::frenet;
  const AngleAnswer frenet = phrame::answer(halves(), query);
  query.at = {Rational(1, 2), 1};
  const AngleAnswer of_whole = phrame::answer(whole(), query);
  CHECK(frenet.values.at(0).theta.value == of_whole.values.at(0).theta.value);
  CHECK(frenet.total->value == of_whole.values.at(1).theta.value);
}

TEST_CASE("answers: lengths, twists and totals of the curve are those of its halves") {
  const InfoAnswer info = answer(whole(), InfoQuery{20});
  CHECK(info.length.exact == Rational(71, 15));
  const InfoAnswer in_halves = answer(halves(), InfoQuery{20});
  CHECK(in_halves.length.exact == Rational(71, 15));
  CHECK(in_halves.lengths.size() == 2);
  CHECK(in_halves.twist.value == info.twist.value);
  CHECK("-" + truth("theta_RMF_rel_ERF", "1").substr(0, 15) == info.twist.value.substr(0, 16));
  CHECK(in_halves.bending_energy->value == info.bending_energy->value);

  const TotalsAnswer totals = answer(whole(), TotalsQuery{20});
  const TotalsAnswer of_halves = answer(halves(), TotalsQuery{20});
  REQUIRE(totals.rows.size() == 7);
  for (std::size_t k = 0; k < totals.rows.size(); ++k) {
    CAPTURE(name_of(totals.rows[k].quantity));
    CHECK(totals.rows[k].quantity == static_cast<Quantity>(k));
    CHECK(totals.rows[k].value.has_value() == of_halves.rows[k].value.has_value());
    if (totals.rows[k].value) CHECK(totals.rows[k].value->value == of_halves.rows[k].value->value);
  }
  CHECK(totals.rows[0].value->value == info.length.rounded.value);
  CHECK(totals.rows[1].value->value == info.twist.value);
}

TEST_CASE("answers: what kind of curve, and its preimage from the hodograph") {
  const ClassificationAnswer kind = answer(whole(), ClassificationQuery{});
  CHECK(kind.classification.is_regular);
  CHECK_FALSE(kind.classification.normal.has_value());
  const IdentificationAnswer found = answer(NamedHodograph{"", hodograph(quintic), {}});
  REQUIRE(std::holds_alternative<Curve>(found.result));
  CHECK(hodograph(std::get<Curve>(found.result)) == hodograph(quintic));
  const IdentificationAnswer none = answer(NamedHodograph{"", {Polynomial{1}, {0, 1}, {}}, {}});
  CHECK(std::holds_alternative<NotPythagorean>(none.result));
}

TEST_CASE("answers: a table of frames passes the check of frames, but not when it is changed") {
  const FrameTable table = frame_table(quintic, {TabulatedFrame::rmf}, {0, Rational(1, 2), 1});
  std::vector<GivenFrame> frames;
  for (const std::vector<double>& row : table.rows) {
    GivenFrame frame{exact_rational(row[0]), {}};
    for (std::size_t k = 0; k < 3; ++k) frame.f2[k] = exact_rational(row[7 + k]);
    frames.push_back(frame);
  }
  CheckQuery query{frames};
  query.options.tolerance = Rational(1, Integer(1) << 50);
  CHECK(answer(whole(), query).verdict.passes);
  query.frames[1].f2[0] += Rational(1, 1'000'000);
  CHECK_FALSE(answer(whole(), query).verdict.passes);
}

TEST_CASE("answers: compiled polynomials are as near as they say to the known angle") {
  const CompiledAnswer compiled = answer(whole(), CompiledQuery{.start = Angle()});
  const PolynomialPiece& piece = compiled.angle->at(0.5);
  const double y = (0.5 - piece.center) * piece.scale;
  const auto degree = static_cast<std::size_t>(compiled.angle->shape().degree);
  double s = piece.coefficients[0];
  for (std::size_t k = 1; k < degree; ++k) s = s * y + piece.coefficients[k];
  const double theta = piece.coefficients[degree] + (piece.coefficients[degree + 1] + s * y);
  const Rational known = parse_rational(truth("theta_RMF_rel_ERF", "1/2"));
  const double ulp = 0x1p-55;  // of a number in [1/8, 1/4): the last rounding
  CHECK(abs(exact_rational(theta) - known) <= exact_rational(angle_error(compiled) + ulp));
  CHECK(angle_error(compiled) < 0x1p-50);
  CHECK(compiled.rotation != nullptr);
  CHECK(component_error(compiled) > 0);
  CHECK(component_error(compiled) < 0x1p-48);
  CompiledQuery frenet;
  frenet.reference = Reference::frenet;
  CHECK(component_error(answer(whole(), frenet)) == 0);
}

TEST_CASE("answers: an integral, and what a proof assistant is to prove") {
  IntegralQuery query{RationalFunction({4}, {1, 0, 1})};
  query.ends = {PathEnd(Rational(0)), PathEnd(Rational(1))};
  query.digits = 20;
  const IntegralAnswer pi = answer(query);
  CHECK(pi.definite->value.value == "3.1415926535897932385");
  CHECK(pi.definite->exact == ExactValue{0, 1, {}, {}});
  const CoqAnswer coq = answer(quintic, CoqQuery{1, 20});
  check_rounded(coq.theta.value, coq.theta.radius, truth("theta_RMF_rel_ERF", "1"), 20, 40);
  CHECK(coq.half_unit == Rational(1, 2 * pow(Integer(10), 20)));
  CHECK_THROWS_AS(answer(quintic, CoqQuery{0, 20}), DomainError);
}

// What the proof that Coq checks is made of obeys the identities that it is to prove.
TEST_CASE("answers: cofactors make 1, and fractions in lowest terms are the rates of the angle") {
  const CoqAnswer coq = answer(quintic, CoqQuery{1, 20, Reference::frenet});
  const auto& [u, v, p, q] = quintic.preimage();
  const auto& c = coq.cofactors.value();
  CHECK(c[0] * u + c[1] * v + c[2] * p + c[3] * q == Polynomial{1});
  const GaussianPolynomial g = bend_numerator(quintic.preimage());
  const auto& d = coq.bend_cofactors.value();
  CHECK(d[0] * g.re + d[1] * g.im == Polynomial{1});
  CHECK_FALSE(coq.domain.has_value());
  CHECK(coq.rate.lowest == rate_to_erf(quintic.preimage()));
  CHECK(coq.rate.lowest + coq.bend_rate.value().lowest ==
        RmfAngle(quintic, Reference::frenet).rate());
  CHECK(coq.rate.lowest.denominator() * coq.rate.common == sigma(quintic.preimage()));
  CHECK(Rational(4) * coq.bend_rate->lowest.denominator() * coq.bend_rate->common ==
        rho(quintic.preimage()));
  // Times t² + 1 there are no cofactors, and nothing is known beyond an interval.
  const Polynomial factor{1, 0, 1};
  const Curve common({factor * u, factor * v, factor * p, factor * q});
  const CoqAnswer other = answer(common, CoqQuery{2, 20});
  CHECK_FALSE(other.cofactors.has_value());
  CHECK(other.domain.value().lower == Rational(-1, 2));
  CHECK(other.domain->upper == Rational(5, 2));
  CHECK(other.rate.lowest == coq.rate.lowest);
}

// With θ_i = 0 and θ_f = θ_RMF(1) to the nearest 10⁻³⁰ no twist is left; θ is that of the RMF.
TEST_CASE("answers: of minimal twist between the orientations of the RMF") {
  const Rational end = parse_rational(truth("theta_RMF_rel_ERF", "1").substr(0, 32));
  MinimalTwistQuery query{Angle(), Angle(end)};
  query.at = {Rational(1, 2)};
  query.digits = 20;
  const MinimalTwistAnswer mtf = answer(whole(), query);
  CHECK(mtf.length.exact() == Rational(71, 15));
  check_angle(mtf.values.at(0), truth("theta_RMF_rel_ERF", "1/2"), 20);
  CHECK(abs(parse_rational(mtf.twist.value)) < power_of_ten(-28));
  CHECK_FALSE(mtf.rational.has_value());
}
