#include "phrame/io/read/curve_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

namespace curve_file_test {

using namespace phrame;
using test::contains;

namespace {

/// A curve/1 file with these further members.
std::string file(const std::string& members) { return R"({"phrame": "curve/1", )" + members + "}"; }

/// A = c with the number `c` as it is written.
std::string constant(const std::string& c) {
  return file(R"("basis": "power", "preimage": {"u": [)" + c +
              R"(], "v": ["1"], "p": ["0"], "q": ["0"]})");
}

Rational read_number(const std::string& text) {
  return read_curve(constant(text)).curve.preimage().u.coefficient(0);
}

/// "place: reason" of the refusal, always one line and never long.
std::string refusal(const std::string& text, const CurveLimits& limits = {}) {
  try {
    read_curve(text, limits);
  } catch (const InputError& error) {
    std::string message = error.what();
    CHECK(message.size() < 400);
    for (const char c : message) CHECK(static_cast<unsigned char>(c) >= 0x20U);
    return message;
  }
  return "(accepted)";
}

const std::string zeros = R"("v": [0], "p": [0], "q": [0])";

}  // namespace

// The quintic of Farouki 2003, §4: A₀ = 2 + i + k, A₁ = i − 2j + 2k, A₂ = 2 + k in Bernstein form.
// By hand in power form: u = 2(1−t)² + 2t² = 4t² − 4t + 2, v = (1−t)² + 2t(1−t) = 1 − t²,
// p = −4t(1−t) = 4t² − 4t, q = (1−t)² + 4t(1−t) + t² = −2t² + 2t + 1.
TEST_CASE("curve files: preimage, quaternions and hopf in either basis give the same curve") {
  const Curve expected(
      {Polynomial{2, -4, 4}, Polynomial{1, 0, -1}, Polynomial{0, -4, 4}, Polynomial{1, 2, -2}});
  const char* const forms[] = {
      R"("basis": "bernstein",
         "preimage": {"u": [2, 0, 2], "v": [1, 1, 0], "p": [0, -2, 0], "q": [1, 2, 1]})",
      R"("basis": "power",
         "preimage": {"u": [2, -4, 4], "v": [1, 0, -1], "p": [0, -4, 4], "q": [1, 2, -2]})",
      R"("basis": "bernstein", "quaternions": [[2, 1, 0, 1], [0, 1, -2, 2], [2, 0, 0, 1]])",
      R"("basis": "power", "quaternions": [[2, 1, 0, 1], [-4, 0, -4, 2], [4, -1, 4, -2]])",
      // α = u + iv, β = q + ip
      R"("basis": "bernstein", "hopf": {"alpha": [[2, 1], [0, 1], [2, 0]],
                                        "beta": [[1, 0], [2, -2], [1, 0]]})",
      R"("basis": "power", "hopf": {"alpha": [[2, 1], [-4, 0], [4, -1]],
                                    "beta": [[1, 0], [2, -4], [-2, 4]]})"};
  for (const char* form : forms) {
    CAPTURE(form);
    CHECK(read_curve(file(form)).curve == expected);
  }
  CHECK(read_curve(file(forms[0])).name.empty());
}

// r′ = w², w = (1 + i)(1 − t)² + 2t(1 − t)·2 − i·t² = 1 + i + (2 − 2i)t − 3t².
TEST_CASE("curve files: a plane curve by the complex numbers of w, in either basis") {
  const Curve expected({Polynomial{1, 2, -3}, {}, {}, Polynomial{1, -2}}, {2, -2}, {1, 2, 3});
  const std::string start = R"(, "start": [1, 2, 3])";
  CHECK(read_curve(file(R"("basis": "power", "multiplier": [2, -2],
      "complex": [[1, 1], [2, -2], [-3, 0]])" +
                        start))
            .curve == expected);
  CHECK(read_curve(file(R"("basis": "bernstein", "multiplier": [2, 1, 0],
      "complex": [[1, 1], [2, 0], [0, -1]])" +
                        start))
            .curve == expected);
  CHECK(refusal(file(R"("basis": "power", "complex": [[1, 0, 2]])")) ==
        "/complex/0: 2 numbers are wanted, not 3");
  CHECK(refusal(file(R"("basis": "power", "complex": [[0, 0], [0, 0]])")) ==
        "/complex: the preimage is zero, so the curve is a single point");
  CHECK(refusal(file(R"("basis": "power", "complex": [[1, 0]], "hopf": {})")) ==
        "/: \"hopf\" and \"complex\" exclude each other");
}

TEST_CASE("curve files: short lists are padded in the power basis") {
  const Curve curve = read_curve(file(R"("basis": "power",
      "preimage": {"u": [1, 2, 3], "v": [4], "p": [0, 0, 0, 0], "q": [0]})"))
                          .curve;
  CHECK(curve == Curve({Polynomial{1, 2, 3}, Polynomial{4}, Polynomial(), Polynomial()}));
  CHECK(degree(curve) == 5);
}

TEST_CASE("curve files: the multiplier is in the same basis, the start is a point") {
  const std::string rest = R"(, "start": [1, "-1/2", 0.25], "multiplier": [1, 3, 2])";
  const std::string power = R"("basis": "power", "preimage": {"u": [1], )" + zeros + "}" + rest;
  const std::string bernstein =
      R"("basis": "bernstein", "preimage": {"u": [1], )" + zeros + "}" + rest;
  const Curve a = read_curve(file(power)).curve;
  CHECK(a.multiplier() == Polynomial{1, 3, 2});
  CHECK(a.start() == Vector<Rational>{1, Rational(-1, 2), Rational(1, 4)});
  // (1 − t)² + 6t(1 − t) + 2t² = 1 + 4t − 3t²
  CHECK(read_curve(file(bernstein)).curve.multiplier() == Polynomial{1, 4, -3});
  CHECK(read_curve(constant("1")).curve.multiplier() == Polynomial{1});
  CHECK(read_curve(constant("1")).curve.start() == Vector<Rational>{0, 0, 0});
}

TEST_CASE("curve files: remarks are skipped, whatever they hold") {
  const auto named = read_curve(file(R"("name": "a", "note": {"any": [null]}, "family": 7,
      "expected": {"theta_erf_1": "x"}, "basis": "power", "preimage": {"u": [1], )" +
                                     zeros + "}"));
  CHECK(named.name == "a");
}

TEST_CASE("curve files: numbers are read exactly, bare or as text") {
  CHECK(read_number("0.1") == Rational(1, 10));
  CHECK(read_number("\"0.1\"") == Rational(1, 10));
  CHECK(read_number("-2") == -2);
  CHECK(read_number("\"-2\"") == -2);
  CHECK(read_number("\"3/7\"") == Rational(3, 7));
  CHECK(read_number("\"-6/14\"") == Rational(-3, 7));
  CHECK(read_number("\"0x1.8p-3\"") == Rational(3, 16));
  CHECK(read_number("1e-3") == Rational(1, 1000));
  CHECK(read_number("0.30000000000000000000000000000000001") ==
        Rational(3, 10) + power_of_ten(-35));
  CHECK(read_number("1e400") == power_of_ten(400));
  CHECK(read_number("1e-5000") == power_of_ten(-5000));
  // 400 nines
  CHECK(read_number(std::string(400, '9')) == power_of_ten(400) - 1);
  CHECK(read_number("-" + std::string(400, '9')) == 1 - power_of_ten(400));
  CHECK(read_number("18446744073709551617") == Rational(Integer(1) << 64) + 1);
}

TEST_CASE("curve files: what is no number is refused with its place and its text") {
  const auto number = [](const std::string& text) { return refusal(constant(text)); };
  CHECK(number("\"1/0\"") == "/preimage/u/0: \"1/0\" divides by zero");
  for (const char* text : {"nan", "inf", "-Infinity", "", " 1", "1 2", "1/2/3", "2.5/3", "0x",
                           "--1", "1/-2", "1e", "1e1000000", "one"}) {
    CAPTURE(text);
    const std::string quoted = '"' + std::string(text) + '"';
    CHECK(number(quoted).starts_with("/preimage/u/0: " + quoted + " is not a number"));
  }
  CHECK(number("null") == "/preimage/u/0: a number is wanted, not null");
  CHECK(number("true") == "/preimage/u/0: a number is wanted, not true");
  CHECK(number("[1]") == "/preimage/u/0: a number is wanted, not an array of 1");
  CHECK(number("1, {}") == "/preimage/u/1: a number is wanted, not an object of 0");
  CHECK(number("\"a\\n\\u001b[31mb\"").starts_with("/preimage/u/0: \"a??[31mb\" is not a number"));
}

TEST_CASE("curve files: a number of a million digits is refused, not computed with") {
  const std::string digits(1'000'000, '7');
  CHECK(contains(refusal(constant('"' + digits + '"')), "/preimage/u/0: the number 7777"));
  CHECK(contains(refusal(constant('"' + digits + '"')), "longer than 100000 characters"));
  CHECK(contains(refusal(constant("0." + digits)), "longer than 100000 characters"));
  CHECK(contains(refusal(constant(digits)), "longer than 100000 characters"));
}

TEST_CASE("curve files: unequal Bernstein lists are refused with both lengths") {
  const auto message = refusal(file(
      R"("basis": "bernstein", "preimage": {"u": [1, 2, 3], "v": [1, 2, 3], "p": [1, 2], "q": [1]})"));
  CHECK(message == "/preimage: Bernstein lists must have equal lengths, here 3 and 2");
  CHECK(refusal(file(
            R"("basis": "bernstein", "hopf": {"alpha": [[1, 0]], "beta": [[1, 0], [0, 1]]})")) ==
        "/hopf: Bernstein lists must have equal lengths, here 1 and 2");
}

TEST_CASE("curve files: empty lists are refused") {
  const std::string empty = "the list of coefficients is empty";
  CHECK(refusal(constant("")) == "/preimage/u: " + empty);
  CHECK(refusal(file(R"("basis": "power", "quaternions": [])")) == "/quaternions: " + empty);
  CHECK(refusal(file(R"("basis": "power", "hopf": {"alpha": [[1, 0]], "beta": []})")) ==
        "/hopf/beta: " + empty);
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": [1], )" + zeros +
                     R"(}, "multiplier": [])")) == "/multiplier: " + empty);
}

TEST_CASE("curve files: tuples of the wrong size are refused where they stand") {
  CHECK(refusal(file(R"("basis": "power", "quaternions": [[1, 2, 3, 4], [1, 2, 3]])")) ==
        "/quaternions/1: 4 numbers are wanted, not 3");
  CHECK(refusal(file(R"("basis": "power", "quaternions": [7])")) ==
        "/quaternions/0: an array of 4 numbers is wanted, not the number 7");
  CHECK(refusal(file(R"("basis": "power", "hopf": {"alpha": [[1, 0, 0]], "beta": [[1, 0]]})")) ==
        "/hopf/alpha/0: 2 numbers are wanted, not 3");
  const std::string good = R"("basis": "power", "preimage": {"u": [1], )" + zeros + "}";
  CHECK(refusal(file(good + R"(, "start": [0, 0])")) == "/start: 3 numbers are wanted, not 2");
  CHECK(refusal(file(good + R"(, "start": [0, 0, "x"])")).starts_with("/start/2: \"x\" is not a"));
  CHECK(refusal(file(good + R"(, "start": "origin")")) ==
        "/start: an array of 3 numbers is wanted, not the string \"origin\"");
}

TEST_CASE("curve files: values of the wrong kind are refused where they stand") {
  CHECK(refusal("[]") == "/: an object is wanted, not an array of 0");
  CHECK(refusal("null") == "/: an object is wanted, not null");
  CHECK(refusal(R"({"phrame": 1})") == "/phrame: a string is wanted, not the number 1");
  CHECK(refusal(file(R"("basis": 3)")) == "/basis: a string is wanted, not the number 3");
  CHECK(refusal(file(R"("basis": "power", "preimage": [1, 2, 3, 4])")) ==
        "/preimage: an object is wanted, not an array of 4");
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": 1, )" + zeros + "}")) ==
        "/preimage/u: an array of coefficients is wanted, not the number 1");
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": null, )" + zeros + "}")) ==
        "/preimage/u: an array of coefficients is wanted, not null");
  CHECK(refusal(file(R"("basis": "power", "quaternions": {"u": [1]})")) ==
        "/quaternions: an array of coefficients is wanted, not an object of 1");
  CHECK(refusal(file(R"("name": ["x"], "basis": "power", "preimage": {"u": [1], )" + zeros +
                     "}")) == "/name: a string is wanted, not an array of 1");
}

TEST_CASE("curve files: what is missing is named") {
  CHECK(refusal("{}") == "/: the key \"phrame\" is missing");
  CHECK(refusal(R"({"phrame": "curve/1"})") == "/: the key \"basis\" is missing");
  CHECK(refusal(file(R"("basis": "power")")) ==
        "/: a curve needs one of \"preimage\", \"quaternions\", \"hopf\", \"complex\" and "
        "\"control_points\"");
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": [1], "v": [0], "q": [0]})")) ==
        "/preimage: the key \"p\" is missing");
  CHECK(refusal(file(R"("basis": "power", "hopf": {"alpha": [[1, 0]]})")) ==
        "/hopf: the key \"beta\" is missing");
}

TEST_CASE("curve files: an unknown key is refused with the nearest known one") {
  CHECK(refusal(file(R"("basis": "power", "preimag": {})")) ==
        "/: unknown key \"preimag\"; the nearest known key is \"preimage\"");
  CHECK(refusal(file(R"("basis": "power", "multiplyer": [1])")) ==
        "/: unknown key \"multiplyer\"; the nearest known key is \"multiplier\"");
  CHECK(refusal(file(R"("basis": "power", "hopf": {"alhpa": [], "beta": []})")) ==
        "/hopf: unknown key \"alhpa\"; the nearest known key is \"alpha\"");
  CHECK(contains(refusal(file(R"("a\u0007\n": 1)")), "unknown key \"a??\""));
  CHECK(contains(refusal(file('"' + std::string(100'000, 'x') + "\": 1")), "(100000 characters)"));
}

TEST_CASE("curve files: a key given twice is refused") {
  CHECK(refusal(R"({"phrame": "curve/1", "phrame": "curve/1"})") ==
        "/phrame: the key occurs twice");
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": [1], "u": [1]})")) ==
        "/preimage/u: the key occurs twice");
}

TEST_CASE("curve files: two descriptions of one curve exclude each other") {
  CHECK(refusal(file(R"("basis": "power", "preimage": {}, "hopf": {})")) ==
        "/: \"preimage\" and \"hopf\" exclude each other");
  CHECK(refusal(file(R"("basis": "power", "quaternions": [], "preimage": {})")) ==
        "/: \"preimage\" and \"quaternions\" exclude each other");
}

TEST_CASE("curve files: formats and bases are refused by name") {
  CHECK(refusal(R"({"phrame": "spline/1", "segments": []})") ==
        "/phrame: this is a spline; one curve is wanted");
  CHECK(refusal(R"({"phrame": "curve/2"})") ==
        "/phrame: the format is \"curve/1\", not \"curve/2\"");
  CHECK(refusal(file(R"("basis": "Bernstein\n")")) ==
        "/basis: the basis is \"bernstein\" or \"power\", not \"Bernstein?\"");
}

TEST_CASE("curve files: a curve that is a single point is refused") {
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": ["0.0"], )" + zeros + "}")) ==
        "/preimage: the preimage is zero, so the curve is a single point");
  CHECK(refusal(file(R"("basis": "bernstein", "quaternions": [[0, 0, 0, 0], [0, 0, "0/5", 0]])")) ==
        "/quaternions: the preimage is zero, so the curve is a single point");
  CHECK(refusal(file(R"("basis": "power", "preimage": {"u": [1], )" + zeros +
                     R"(}, "multiplier": [0, 0])")) ==
        "/multiplier: the multiplier is zero, so the curve is a single point");
}

TEST_CASE("curve files: the degree is limited, and the limit can be raised") {
  const auto of_length = [](std::size_t n) {
    std::string list = "1";
    for (std::size_t k = 1; k < n; ++k) list += ",1";
    return constant(list);
  };
  // A preimage of degree m makes a curve of degree 2m + 1.
  CHECK(refusal(of_length(501)) == "(accepted)");  // 1001
  CHECK(refusal(of_length(502)) ==
        "/: the curve has degree 1003, the limit is 1001; --max-degree "
        "raises it");
  CHECK(refusal(of_length(502), {1003}) == "(accepted)");
  CHECK(refusal(of_length(100'001)) ==
        "/preimage/u: 100001 coefficients make a degree beyond the limit 1001; --max-degree raises "
        "it");
  CHECK(refusal(of_length(3), {4}) ==
        "/: the curve has degree 5, the limit is 4; --max-degree raises it");
  // The multiplier counts: 2·0 + 1 + 3.
  const std::string cubic = file(R"("basis": "power", "preimage": {"u": [1], )" + zeros +
                                 R"(}, "multiplier": [1, 0, 0, 1])");
  CHECK(refusal(cubic, {4}) == "(accepted)");
  CHECK(contains(refusal(cubic, {3}), "the curve has degree 4, the limit is 3"));
}

TEST_CASE("curve files: broken JSON is refused with line and column") {
  CHECK(refusal("").starts_with("1:1: not valid JSON"));
  CHECK(refusal("{\n \"phrame\": \"curve/1\",\n \"basis\"").starts_with("3:8: not valid JSON"));
  CHECK(refusal(constant("NaN")).find(": not valid JSON") != std::string::npos);
  CHECK(contains(refusal(file("\"name\": \"\xFF\"")), "not valid JSON"));
  CHECK(contains(refusal(R"({"note": )" + std::string(100'000, '[')), "nested deeper than 32"));
}

TEST_CASE("curve files: a table is said to be no curve file") {
  CHECK(refusal("t,x,y,z\n0,0,0,0\n") == "1:2: a curve file is JSON, this begins with \"t,x,y,z\"");
  CHECK(contains(refusal("\xEF\xBB\xBF 0 0 0 1\r1 0 0 1\r"), "this begins with \"0 0 0 1\""));
  CHECK(contains(refusal(std::string("\x93NUMPY\x01\0", 8)),
                 "a curve file is JSON, this is an array of NumPy"));
  CHECK(contains(refusal("[1, 2"), "not valid JSON"));
  CHECK(contains(refusal("7"), "an object is wanted"));
}

TEST_CASE("curve files: every prefix of a good file is refused, and nothing else happens") {
  const std::string good = file(R"("name": "é", "basis": "power", "multiplier": [1, 1],
      "hopf": {"alpha": [["1/2", 0.5]], "beta": [["0x1p-1", -1e3]]})");
  CHECK(refusal(good) == "(accepted)");
  for (std::size_t n = 0; n < good.size(); ++n)
    CHECK(contains(refusal(good.substr(0, n)), "not valid JSON"));
}

// r = (t − t³/3, t², 0) with r′ = (1 − t², 2t, 0): A = 1 + t·k, and the points by hand from
// b₁ = b₀ + r′(0)/3, b₂ = b₃ − r′(1)/3.
TEST_CASE("curve files: control points of a PH curve are identified") {
  const std::string points = R"("control_points": [[0, 0, 0], ["1/3", 0, 0], ["2/3", "1/3", 0],
                                                   ["2/3", 1, 0]])";
  const Curve expected({{1}, {}, {}, {0, 1}});
  CHECK(read_curve(file(points)).curve == expected);
  CHECK(read_curve(file(R"("name": "x", "basis": "bernstein", )" + points)).curve == expected);
  CHECK(read_curve(file(R"("name": "x", )" + points)).name == "x");
  const NamedHodograph read = read_hodograph(file(points));
  CHECK(read.hodograph == Vector<Polynomial>{Polynomial{1, 0, -1}, Polynomial{0, 2}, {}});
  CHECK(read.start == Vector<Rational>{});
  CHECK(read_curve(file(R"("control_points": [[1, "2.5", 3], [2, "2.5", 3]])")).curve ==
        Curve({{1}, {}, {}, {}}, {1}, {1, Rational(5, 2), 3}));
}

TEST_CASE("curve files: control points that make no PH curve are refused with the reason") {
  // r′ = (1, 2t, 0) and (1, 1, 0).
  CHECK(refusal(file(R"("control_points": [[0, 0, 0], [0.5, 0, 0], [1, 1, 0]])")) ==
        "/control_points: this is no PH curve: |r'| is no polynomial: |r'|^2 has the factor "
        "4*t^2 + 1 to an odd power");
  const std::string diagonal = file(R"("control_points": [[0, 0, 0], [1, 1, 0]])");
  const std::string no_preimage =
      "/control_points: this is no PH curve: |r'| is sqrt(2) times a polynomial: the curve is PH "
      "over the reals, but has no preimage with rational coefficients, whatever the multiplier";
  CHECK(refusal(diagonal) == no_preimage);
  CurveLimits limits;
  limits.near_option = "--near";
  CHECK(refusal(diagonal, limits) ==
        no_preimage + "; --near 1e-30 takes the PH curve 1.0e-31 from it");
  CHECK(read_hodograph(file(R"("control_points": [[0, 0, 0], [1, 1, 0]])")).hodograph ==
        Vector<Polynomial>{Polynomial{1}, Polynomial{1}, {}});
  // However long the factor is.
  std::string many = "[0, 0, 0]";
  for (int k = 1; k < 60; ++k) many += fmt::format(", [{}, {}e-50, 1e{}]", k, k * k, k);
  CHECK(contains(refusal(file(R"("control_points": [)" + many + "]")), "to an odd power"));
}

TEST_CASE("curve files: control points say all, so that nothing else may be said") {
  const std::string points = R"("control_points": [[0, 0, 0], [1, 0, 0]], )";
  for (const std::string key : {"start", "multiplier", "preimage", "hopf", "quaternions"})
    CHECK(refusal(file(points + '"' + key + "\": []")) ==
          "/: \"control_points\" and \"" + key + "\" exclude each other");
  CHECK(refusal(file(points + R"("basis": "power")")) ==
        "/basis: control points have the basis \"bernstein\", not \"power\"");
}

TEST_CASE("curve files: bad control points are refused where they stand") {
  const auto points = [](const std::string& list) { return file("\"control_points\": " + list); };
  CHECK(refusal(points("7")) == "/control_points: an array of points is wanted, not the number 7");
  CHECK(refusal(points("[]")) == "/control_points: a curve has at least 2 control points, not 0");
  CHECK(refusal(points("[[0, 0, 0]]")) ==
        "/control_points: a curve has at least 2 control points, not 1");
  CHECK(refusal(points("[[0, 0, 0], [1, 2]]")) ==
        "/control_points/1: 2 numbers here, but 3 in the first point");
  CHECK(refusal(points("[[0], [1]]")) ==
        "/control_points/0: a point has 2 or 3 coordinates, not 1");
  CHECK(refusal(points("[[0, 0, 0], [1, 2, \"x\"]]")).starts_with("/control_points/1/2: \"x\""));
  CHECK(refusal(points("[[1, 2, 3], [1, \"2\", 3.0], [1, 2, 3]]")) ==
        "/control_points: the control points are all equal, so the curve is a single point");
  CHECK(refusal(points("[[0,0,0], [1,0,0], [2,0,0]]"), {1}) ==
        "/control_points: 3 points make a degree beyond the limit 1; --max-degree raises it");
}

TEST_CASE("curve files: law: what is written is read as the same curve") {
  test::for_samples(60, [](test::Random& random) {
    const NamedCurve named{random.chance(2) ? "" : "a \"name\"\n", random.curve(3)};
    const std::string text = write_curve(named);
    const NamedCurve back = read_curve(text);
    CHECK(back.name == named.name);
    CHECK(back.curve == named.curve);
    const NamedHodograph other = read_hodograph(text);
    CHECK(other.hodograph == hodograph(named.curve));
    CHECK(other.start == named.curve.start());
  });
}

namespace {

std::string spline_file(const std::string& segments) {
  return R"({"phrame": "spline/1", "name": "s", "segments": [)" + segments + "]}";
}

/// Along x from wherever, and from x = 1.
const std::string along_x = R"({"basis": "power", "quaternions": [[1, 0, 0, 0]]})";
const std::string from_one =
    R"({"phrame": "curve/1", "basis": "power", "start": [1, 0, 0], "quaternions": [[1, 0, 0, 0]]})";

PhPath read_spline(const std::string& segments) { return read_path(spline_file(segments)).path; }

std::string spline_refusal(const std::string& text) {
  return test::refusal_of([&] { read_path(text); });
}

}  // namespace

TEST_CASE("spline files: segments start where they say, or where the one before ends") {
  const PhPath implied = read_spline(along_x + "," + along_x);
  REQUIRE(implied.segments().size() == 2);
  CHECK(implied.segments()[1].start() == Vector<Rational>{1, 0, 0});
  CHECK(read_spline(along_x + "," + from_one) == implied);
  const std::string bezier = R"({"control_points": [[1, 0, 0], [2, 0, 0]]})";
  CHECK(read_spline(along_x + "," + bezier) == implied);
  CHECK(read_spline(from_one).segments()[0].start() == Vector<Rational>{1, 0, 0});
  CHECK(read_path(spline_file(along_x)).name == "s");
  CHECK(read_path(file(R"("basis": "power", "quaternions": [[1, 0, 0, 0]])")).path.is_curve());
}

TEST_CASE("spline files: what is wrong is told with its segment") {
  const auto refused = [](const std::string& segments) {
    return spline_refusal(spline_file(segments));
  };
  CHECK(refused("") == "/segments: a spline has at least one segment");
  CHECK(refused(along_x + "," + from_one + "," + from_one) ==
        "/segments/2: it starts at (1, 0, 0), but the spline ends at (2, 0, 0)");
  CHECK(refused(along_x + R"(, {"basis": "power", "quaternions": [[0, 0, 1, 0]]})") ==
        "/segments/1: the tangent turns back: the spline ends in the direction (1, 0, 0), and it "
        "starts in the opposite one, so that frames are undefined there");
  CHECK(refused(along_x + R"(, {"basis": "power", "quaternions": [[1, 0, 0]]})") ==
        "/segments/1/quaternions/0: 4 numbers are wanted, not 3");
  CHECK(refused(along_x + R"(, {"phrame": "curve/2"})") ==
        "/segments/1/phrame: the format is \"curve/1\", not \"curve/2\"");
  CHECK(refused("3") == "/segments/0: an object is wanted, not the number 3");
  CHECK(spline_refusal(R"({"phrame": "spline/1"})") == "/: the key \"segments\" is missing");
  CHECK(spline_refusal(R"({"phrame": "spline/1", "segments": {}})") ==
        "/segments: an array of curves is wanted, not an object of 0");
  CHECK(spline_refusal(R"({"phrame": "spline/1", "segment": []})") ==
        "/: unknown key \"segment\"; the nearest known key is \"segments\"");
}

TEST_CASE("curve files: law: a spline that is written is read as the same spline") {
  test::for_samples(20, [](test::Random& random) {
    const Curve curve = random.curve(3);
    const NamedPhPath named{"a \"name\"", test::cut(curve, {Rational(1, 3), Rational(1, 2)})};
    const NamedPhPath back = read_path(write_path(named));
    CHECK(back.name == named.name);
    CHECK(back.path == named.path);
    CHECK(write_path(NamedCurve{"one", curve}) ==
          write_curve({"one", PhPath(curve).segments().front()}));
  });
  const NamedPhPath loop{"", test::closed_loop()};
  CHECK(read_path(write_path(loop)).path == loop.path);
}

// A fraction in a formula, which was a decimal, is read as a quotient.
TEST_CASE("curve files: law: a path of any kind that is written is read as the same path") {
  const auto check = [](const NamedPath& named) {
    const std::string written = write_path(named);
    const NamedPath back = read_any_path(written);
    CHECK(back.name == named.name);
    CHECK(write_path(back) == written);
    for (const Rational& t : {Rational(1, 3), named.path.end()}) {
      const Place at = locate(named.path, t);
      CHECK(round_to_double(position(back.path, at)) == round_to_double(position(named.path, at)));
    }
    return back.path == named.path;
  };
  for (const std::string name : {"mixed", "helix", "trefoil", "pipe-spline", "nurbs-circle"}) {
    CAPTURE(name);
    std::ifstream file(test::root("/examples/any/" + name + ".json"));
    check(read_any_path(std::string(std::istreambuf_iterator<char>(file), {})));
  }
  check(read_any_path(R"json({"phrame": "curve/1", "expressions":
      {"x": "-2/3 - (1 - cos(u))^2/(2*pi)", "y": "sin(u)", "z": "exp(-u)*(-3) + u^(2/3)^2"},
       "from": 1.5, "to": "-1/2*pi + pi/2 - 0.5 + 2^(1/2)/(1+1) - -3"})json"));
  // PH lines behind formulas, of which the first says where it starts.
  CHECK(check(read_any_path(R"json({"phrame": "spline/1", "segments": [
      {"expressions": {"x": "sin(pi*s)^2", "y": "0", "z": "s"}, "from": 0, "to": 1},
      {"control_points": [[0, 0, 1], [0, 0, "4/3"]]},
      {"preimage": {"u": [1], "v": [0], "p": [-1], "q": [0]}, "basis": "power"}]})json")));
}

}  // namespace curve_file_test
