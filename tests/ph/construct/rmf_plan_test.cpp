#include "phrame/ph/construct/rmf_plan.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/hermite.hpp"

using namespace phrame;
using test::one_segment;
using test::relative;

namespace {

constexpr long bits = 200;

RmfPlan plan_of(const HermiteSpline& data) {
  return rmf_plan(data, relative(data, parse_rational("1e-15")), bits);
}

/// A line, a curve in a plane between parallel tangents, and one in space.
HermiteSpline all_forms() {
  return {{{0, 0, 0}, {2, 0, 0}, {4, 1, 0}, {5, 2, 1}},
          {{1, 0, 0}, {3, 0, 0}, {2, 0, 0}, {0, 1, 1}},
          {0, 1, 2, Rational(5, 2)}};
}

}  // namespace

TEST_CASE("RMF plans: lines, planes between parallel tangents, and septics") {
  const RmfPlan plan = plan_of(all_forms());
  REQUIRE(plan.segments.size() == 3);
  CHECK(plan.segments[0].form == SegmentForm::line);
  CHECK(plan.segments[1].form == SegmentForm::plane);
  CHECK(plan.segments[2].form == SegmentForm::space);
  CHECK_FALSE(plan.segments[0].section);
  CHECK_FALSE(plan.segments[1].section);
  CHECK(plan.segments[2].section);
  // The first three tangents have one direction.
  CHECK(plan.base == std::vector<std::size_t>{0, 0, 0, 3});
  CHECK(plan.closing == 2);
}

TEST_CASE("RMF plans: tangents that are nearly parallel are not, but within the tolerance") {
  const auto form = [](const char* text) {
    const Rational e = parse_rational(text);
    return plan_of(one_segment({1, Rational(1, 10), Rational(1, 5)}, {1, 0, 0}, {1, e, 0}))
        .segments.front()
        .form;
  };
  CHECK(form("1e-3") == SegmentForm::space);
  CHECK(form("1e-14") == SegmentForm::space);
  CHECK(form("1e-17") == SegmentForm::plane);
  CHECK(form("0") == SegmentForm::plane);
  // Opposite is not parallel.
  CHECK(plan_of(one_segment({1, 0, 0}, {0, 1, 0}, {0, -1, 0})).segments.front().form ==
        SegmentForm::space);
}

TEST_CASE("RMF plans: an end where the derivative is 0 goes by the other one") {
  const HermiteSpline from_rest{
      {{0, 0, 0}, {1, 1, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {0, 1, 2}};
  const RmfPlan plan = plan_of(from_rest);
  CHECK(plan.base == std::vector<std::size_t>{1, 1, 2});
  CHECK(plan.segments[0].form == SegmentForm::plane);
  CHECK(plan.segments[1].form == SegmentForm::space);
  CHECK(plan.closing == 1);
  const HermiteSpline along{{{0, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, {0, 1}};
  CHECK(plan_of(along).segments.front().form == SegmentForm::line);
  // Backwards there is no line.
  const HermiteSpline back{{{0, 0, 0}, {-2, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, {0, 1}};
  CHECK(plan_of(back).segments.front().form == SegmentForm::plane);
}

TEST_CASE("RMF plans: the septic of a plan ends where it is to, about") {
  const HermiteSpline data = one_segment({1, Rational(1, 10), Rational(-1, 5)},
                                         {1, Rational(1, 2), 0}, {1, 0, Rational(1, 3)});
  const RmfPlan plan = plan_of(data);
  REQUIRE(plan.segments.front().section);
  const SepticSection& section = *plan.segments.front().section;
  // Where it is at the solution, nothing has to be added.
  for (const double x : section.change({0, 0, 0})) CHECK(x == 0);
  CHECK(plan.segments.front().unit > 0);
  CHECK(plan.segments.front().unit <= 1);
}

TEST_CASE("RMF plans: where no septic is found, the segment is named") {
  CHECK_THROWS_WITH_AS(
      plan_of(one_segment({1, Rational(1, 10), Rational(1, 5)}, {100'000'000, 0, 1},
                          {0, parse_rational("1e-8"), 0})),
      "segment 1: no septic with h = 0 was found that has its points and derivatives", Undecided);
}

TEST_CASE("RMF plans: mean derivatives are those by the parameter") {
  const HermiteSpline data = all_forms();
  CHECK(mean_derivative(data, 1) == Vector<Rational>{2, 1, 0});
  CHECK(mean_derivative(data, 2) == Vector<Rational>{2, 2, 2});
}
