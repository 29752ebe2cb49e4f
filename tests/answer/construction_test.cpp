#include "phrame/answer/construction.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

namespace construction_test {

using namespace phrame;
using test::Random;

namespace {

using Vectors = std::vector<Vector<Rational>>;

/// Data as nobody draws them at random: on axes, lines, symmetric, equal, antiparallel, 0.
class DegenerateData {
 public:
  explicit DegenerateData(Random& random)
      : random_(random),
        is_planar_(random.chance(2)),
        size_(pick<Rational>({1, 1, 1, Rational(1, 1000), power_of_two(40), power_of_two(-700)})) {}

  GivenPoints points() {
    GivenPoints given;
    given.is_planar = is_planar_;
    given.points = positions(static_cast<std::size_t>(pick<long>({2, 2, 2, 3, 4, 6})));
    const long with = random_.integer(0, 3);
    if (with == 1)
      given.tangents = directions(given.points);
    else if (with > 1)
      given.derivatives = directions(given.points);
    if (random_.chance(5)) {
      Rational t;
      for (std::size_t k = 0; k < given.points.size(); ++k)
        given.parameters.push_back(t += pick<Rational>({1, Rational(1, 2), 7, power_of_two(20)}));
    }
    return given;
  }
  Vectors accelerations(std::size_t n) {
    return random_.chance(2) ? Vectors(n) : directions(Vectors(n));
  }

  template <class T>
  T pick(std::vector<T> list) {
    return list[static_cast<std::size_t>(random_.integer(0, static_cast<long>(list.size()) - 1))];
  }

 private:
  Vector<Rational> vector() {
    Vector<Rational> v;
    const std::size_t dimension = is_planar_ ? 2 : 3;
    if (random_.chance(3))
      v[static_cast<std::size_t>(random_.integer(0, static_cast<long>(dimension) - 1))] =
          pick<Rational>({1, -1, 2});
    else
      for (std::size_t k = 0; k < dimension; ++k)
        v[k] = random_.chance(6) ? random_.rational() : Rational(random_.integer(-3, 3));
    return size_ * v;
  }
  Vectors positions(std::size_t n) {
    Vectors list;
    const Vector<Rational> start = vector();
    const Vector<Rational> step = vector();
    const long form = random_.integer(0, 4);
    for (std::size_t k = 0; k < n; ++k) {
      const Rational number(static_cast<long>(k));
      if (form == 0)
        list.push_back(start + number * step);
      else if (form == 1 && 2 * k >= n)
        list.push_back(Rational(-1) * list[n - 1 - k]);
      else if (form == 2 && random_.chance(3) && k > 0)
        list.push_back(list.back());
      else
        list.push_back(vector());
    }
    return list;
  }
  Vectors directions(const Vectors& points) {
    Vectors list;
    const Vector<Rational> all = vector();
    const Rational factor = pick<Rational>({1, -1, 3, -6, 15, Rational(1, 2)});
    const long form = random_.integer(0, 4);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t next = k + 1 < points.size() ? k + 1 : k;
      if (form == 0)
        list.push_back(all);
      else if (form == 1)
        list.push_back(Rational(k % 2 == 0 ? 1 : -1) * all);
      else if (form == 2)
        list.push_back(factor * (points[next] - points[next - 1]));
      else
        list.push_back(vector());
    }
    return list;
  }

  Random& random_;
  bool is_planar_;
  Rational size_;
};

ConstructQuery random_query(Random& random, DegenerateData& data) {
  const NamedKind& named = data.pick(curve_kinds());
  ConstructQuery query;
  query.kind = named.kind;
  query.solution = random.integer(1, named.solutions);
  query.is_closed = random.chance(4);
  query.tolerance = data.pick<Rational>(
      {Rational(1, 1'000'000), query.tolerance, Rational(1, 2), power_of_two(-200)});
  if (random.chance(4)) query.points = PointRule::exact;
  if (random.chance(4))
    query.choice = data.pick<QuinticSelection>(
        {QuinticSelection::minimal, QuinticSelection::bv, QuinticSelection::cc,
         QuinticSelection::shortest, QuinticSelection::longest, QuinticSelection::energy});
  else if (random.chance(2))
    query.choice = FreeAngles{Angle(Rational(random.integer(-2, 2), 2), 0),
                              Angle(Rational(random.integer(-2, 2), 2), 0)};
  return query;
}

}  // namespace

// PHRAME_TEST_MULTIPLIER=100 makes them 6000. An Error that is none of these three is a fault of
// the program, as is one that is thrown by the library of C++.
TEST_CASE("construction: whatever is given, there is a curve near it or a reason") {
  test::for_samples(60, [](Random& random) {
    DegenerateData data(random);
    GivenPoints given = data.points();
    const ConstructQuery query = random_query(random, data);
    if (query.kind == CurveKind::c2_hermite)
      given.accelerations = data.accelerations(given.points.size());
    CAPTURE(static_cast<int>(query.kind));
    try {
      const ConstructionAnswer found = answer(given, query);
      CHECK(is_within(found.deviation, found.tolerance));
      CHECK((!query.is_closed || found.path.path.closing_turn()));
      CHECK(found.path.path.segments().front().start() == given.points.front());
    } catch (const InputError&) {
    } catch (const DomainError&) {
    } catch (const Undecided&) {
    }
  });
}

TEST_CASE("construction: the curve is the same where its segments are not measured") {
  GivenPoints given;
  given.points = {{0, 0, 0}, {1, 2, 0}, {3, 1, 1}};
  ConstructQuery query;
  const ConstructionAnswer measured = answer(given, query);
  query.is_measured = false;
  const ConstructionAnswer other = answer(given, query);
  CHECK(measured.segments.size() == 2);
  CHECK(other.segments.empty());
  CHECK(other.path.path == measured.path.path);
}

}  // namespace construction_test
