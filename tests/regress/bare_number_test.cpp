// A bare number beyond the range of long double was refused: "put it in quotes".
#include <doctest/doctest.h>

#include "phrame/io/read/curve_file.hpp"

using namespace phrame;

TEST_CASE("bare number: it is read exactly, in quotes or not") {
  const NamedCurve named = read_curve(R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": [1e5000, -1e-5000], "v": ["1e5000"], "p": [0], "q": [0]}})");
  const QuaternionPolynomial& a = named.curve.preimage();
  CHECK(a.u.coefficient(0) == a.v.coefficient(0));
  CHECK(a.u.coefficient(0) * a.u.coefficient(1) == -1);
}
