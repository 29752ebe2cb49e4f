#include "phrame/ph/curve/curve_arc.hpp"

#include <cmath>
#include <limits>

#include "support/expression_curves.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::expression_curve;
using test::Random;

namespace {

PlaneBox box(double a, double b, double c, double d) { return {{{a, b}, {c, d}}}; }

bool contains(const DoubleInterval& x, const RealBall& value) {
  const double at = approximate(value);
  return x.lower <= at && at <= x.upper;
}

}  // namespace

TEST_CASE("curve arc: boxes are apart, one way or transversal only where that is sure") {
  CHECK(are_apart(box(0, 1, 0, 1), box(2, 3, 0, 1)));
  CHECK_FALSE(are_apart(box(0, 1, 0, 1), box(1, 3, 1, 2)));
  CHECK(is_one_way(box(1, 2, -1, 1)));
  CHECK_FALSE(is_one_way(box(-1, 2, -1, 1)));
  CHECK_FALSE(is_one_way(box(0, 2, -1, 1)));
  CHECK(are_transversal(box(1, 2, 0, 0), box(-1, 1, 1, 2)));
  CHECK_FALSE(are_transversal(box(1, 2, 0, 1), box(1, 2, 0, 1)));
  const double infinity = std::numeric_limits<double>::infinity();
  const PlaneBox all = box(-infinity, infinity, -infinity, infinity);
  CHECK_FALSE(is_one_way(all));
  CHECK_FALSE(are_transversal(all, box(1, 2, 0, 0)));
  CHECK_FALSE(are_apart(all, box(1, 2, 0, 0)));
}

TEST_CASE("curve arc: law: points and derivatives of an arc are in its boxes") {
  const ExpressionCurve c =
      expression_curve({"exp(sin(s))*cos(s)", "sin(2*s)/(2 + cos(s))", "cos(3*s)"}, "0", "2*pi");
  CurveTree tree(series_of(Path(c)), {2, -1, 3});
  test::for_samples(200, [&](Random& random) {
    CurveNode* node = &tree.root();
    for (long depth = random.integer(0, 12); depth > 0; --depth) {
      tree.split(*node);
      node = node->halves[static_cast<std::size_t>(random.integer(0, 1))].get();
    }
    const Rational share(random.integer(0, 16), 16);
    const Rational lower = exact_rational(node->lower);
    const Rational t = lower + share * (exact_rational(node->upper) - lower);
    const PlaneSeries at = tree.series(0, RealBall(t, 100), 2, 100);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(contains(node->box[k], at[k].coefficient(0)));
      CHECK(contains(node->velocity[k], at[k].coefficient(1)));
    }
  });
}

TEST_CASE("curve arc: the ends of neighbours are the same, around the whole curve") {
  CurveTree tree(series_of(Path(expression_curve({"cos(s)", "sin(s)", "0"}, "0", "2*pi"))),
                 {0, 0, 1});
  tree.split(tree.root());
  CurveNode& first = *tree.root().halves[0];
  CurveNode& last = *tree.root().halves[1];
  tree.split(first);
  tree.split(last);
  CHECK(tree.share_end(first, last));
  CHECK(tree.share_end(*first.halves[0], *last.halves[1]));
  CHECK(tree.share_end(*first.halves[1], *last.halves[0]));
  CHECK_FALSE(tree.share_end(*first.halves[0], *last.halves[0]));
}
