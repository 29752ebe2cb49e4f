#include "phrame/ph/construct/rrmf_joint.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/hermite.hpp"

namespace rrmf_joint_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

void check_root(const RrmfJoint& joint) {
  CHECK(norm(joint.a) % joint.modulus == 0);
  CHECK(joint.modulus % 2 == 1);
  CHECK((joint.root * joint.root + 1) % joint.modulus == 0);
}

/// |a − b| ≤ 2^−bits·|b|.
void check_near(const RationalQuaternion& a, const RationalQuaternion& b, long bits) {
  CHECK(norm(a - b) <= power_of_two(-2 * bits) * norm(b));
}

RrmfQuintic<Rational> random_quintic(Random& random) {
  const auto part = [&] { return Rational(random.integer(-999, 999), 1000); };
  return {{1 + part() / 2, part() / 2, part(), part()}, part(), 1};
}

/// The quintic, and that it is one, near x.
JoinedRrmf checked(const RrmfJoint& start, const RrmfQuintic<Rational>& x, long bits) {
  JoinedRrmf found = joined_rrmf(start, x, bits);
  const RationalQuaternion a0 = found.size * exact(start.a, 1);
  CHECK(symmetric_product(a0, found.a2) == rotated_i(found.a1));
  CHECK(wedge(found.a2, exact(found.end.a, 1)) == ComplexOf<Rational>{});
  const ComplexOf<Rational> along = hermitian_product(found.a2, exact(found.end.a, 1));
  CHECK(along.re > 0);
  CHECK(along.im == 0);
  check_root(found.end);
  check_near(found.a1, a0 * x.b, bits);
  check_near(found.a2, a0 * last_coefficient(x), bits - 2);
  return found;
}

}  // namespace

TEST_CASE("RRMF joints: the first one is near its direction, and on an axis it is that") {
  for_samples(5, [](Random& random) {
    const Vector<Rational> d{random.rational(), random.rational(), random.integer(1, 9)};
    const RrmfJoint joint = first_joint(d, 60);
    check_root(joint);
    CHECK(norm(joint.a) / joint.modulus <= 4);  // what is left is a power of 2
    CHECK(squared_sine(rotated_i(exact(joint.a, 1)), d) < power_of_two(-118));
  });
  for (std::size_t k = 0; k < 3; ++k) {
    Vector<Rational> axis{};
    axis[k] = 3;
    const RrmfJoint joint = first_joint(axis, 60);
    check_root(joint);
    CHECK(squared_sine(rotated_i(exact(joint.a, 1)), axis) == 0);
  }
}

TEST_CASE("RRMF joints: along a chain all quintics have the law, and their numbers stay as short") {
  for (const long bits : {24L, 60L, 200L})
    for_samples(2, [bits](Random& random) {
      const RrmfJoint first = first_joint({random.rational(), random.rational(), 1}, bits);
      RrmfJoint joint = first;
      for (int k = 0; k < 30; ++k) {
        const JoinedRrmf found = checked(joint, random_quintic(random), bits);
        joint = found.end;
        CHECK(bit_length(norm(joint.a)) < 4 * bits + 60);
        CHECK(norm(joint.a) / joint.modulus == norm(first.a) / first.modulus);
      }
    });
}

TEST_CASE("RRMF joints: where no root is known the law holds, and what is lost is not lost again") {
  const RrmfJoint unknown{{3, 1, 4, 1}, 1, 0};  // of the norm 27
  for_samples(3, [&](Random& random) {
    RrmfJoint joint = unknown;
    for (int k = 0; k < 10; ++k) joint = checked(joint, random_quintic(random), 60).end;
    CHECK(bit_length(norm(joint.a)) < 4 * 60 + 120);
  });
  const RrmfQuintic<Rational> without_middle{{0, 0, 0, 0}, 1, 1};
  CHECK(checked(unknown, without_middle, 60).a1 == RationalQuaternion{});
}

}  // namespace rrmf_joint_test
