#include "phrame/ph/curve/formula_domain.hpp"

#include "phrame/algebra/error.hpp"
#include "support/expression_curves.hpp"

using namespace phrame;
using test::expression_curve;

namespace {

std::string undefined(const Vector<const char*>& r, const char* from, const char* to) {
  try {
    expression_curve(r, from, to);
  } catch (const DomainError& error) {
    return error.what();
  }
  return "none";
}

std::string undecided(const Vector<const char*>& r, const char* from, const char* to) {
  try {
    expression_curve(r, from, to);
  } catch (const Undecided& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("formula domain: a pole on the path is named, wherever it is") {
  CHECK(undefined({"s", "s^2", "1/(s - 1/2)"}, "0", "2") ==
        "1/(s - 1/2) is undefined at s = 1/2: s - 1/2 is 0 there");
  CHECK(undefined({"s", "s^2", "1/(s^2 - 2)"}, "0", "2").substr(0, 41) ==
        "1/(s^2 - 2) has a pole near s = 1.4142135");
  CHECK(undefined({"s", "s^2", "(s - 1)^-2"}, "0", "3") ==
        "(s - 1)^(-2) is undefined at s = 1: s - 1 is 0 there");
  CHECK(undefined({"s", "s^2", "tan(s)"}, "0", "2*pi") ==
        "sin(s)/cos(s) is undefined at s = 1/2*pi: cos(s) is 0 there");
  CHECK(undefined({"s", "s^2", "0/s"}, "-1", "1") == "0/s is undefined at s = 0: s is 0 there");
}

TEST_CASE("formula domain: so is a logarithm, root or power of what is not positive") {
  CHECK(undefined({"s", "s^2", "log(s)"}, "0", "1") ==
        "log(s) is undefined at s = 0: s is 0 there");
  CHECK(undefined({"s", "s^2", "log(s - 3)"}, "pi", "0").substr(0, 42) ==
        "log(s - 3) is undefined at s = 3: s - 3 is");
  CHECK(undefined({"s", "s^2", "sqrt(-1 - s^2)"}, "0", "1") ==
        "sqrt(-1 - s^2) is undefined near s = 0: -1 - s^2 is negative there");
  CHECK(undefined({"s", "s^2", "s^(1/3)"}, "-1", "0").substr(0, 60) ==
        "s^(1/3) is undefined near s = -1: s is negative there");
  CHECK(undefined({"s", "s^2", "0*log(s)"}, "0", "1") ==
        "log(s) is undefined at s = 0: s is 0 there");
}

TEST_CASE("formula domain: a cusp is proved where r' is 0 by its form") {
  CHECK(undefined({"s^2", "s^3", "0"}, "-1", "1") == "r' is 0 at s = 0: a cusp");
  CHECK(undefined({"cos(s)^3", "sin(s)^3", "0"}, "1", "2*pi") == "r' is 0 at s = 1/2*pi: a cusp");
  CHECK(undefined({"s - sin(s)", "1 - cos(s)", "0"}, "pi", "3*pi") ==
        "r' is 0 at s = 2*pi: a cusp");
  CHECK(undefined({"1", "2", "pi"}, "0", "1") == "r' is 0 at s = 0: a cusp");
  CHECK(undecided({"(s - 2^(1/3))^2", "(s - 2^(1/3))^3", "0"}, "0", "2").substr(0, 30) ==
        "whether r' is 0 near s = 1.259");
}

TEST_CASE("formula domain: what comes close to a pole or a cusp is none") {
  CHECK_NOTHROW(expression_curve({"s", "s^2", "1/(s + 1e-6)"}, "0", "1"));
  CHECK_NOTHROW(expression_curve({"s^2", "s^3", "s/1e6"}, "-1", "1"));
  CHECK_NOTHROW(expression_curve({"s", "1", "sqrt(s^2 + 1e-12)"}, "-1", "1"));
}

TEST_CASE("formula domain: the ends of the parameter are constants, defined and different") {
  CHECK(undefined({"s", "0", "0"}, "0", "s") == "the end s of the parameter is no constant");
  CHECK(undefined({"s", "0", "0"}, "log(0)", "1") ==
        "the end log(0) of the parameter is undefined");
  CHECK(undefined({"s", "0", "0"}, "pi/3", "pi*2/6") ==
        "s goes from pi/3 to pi*2/6: that is a point");
  CHECK(undefined({"s", "0", "0"}, "sqrt(6)", "sqrt(2)*sqrt(3)") ==
        "s goes from sqrt(6) to sqrt(2)*sqrt(3): that is a point");
  CHECK(undecided({"s", "0", "0"}, "log(6)", "log(2) + log(3)") ==
        "s goes from log(6) to log(2) + log(3): within 2^-1024 these ends are not told apart");
}
