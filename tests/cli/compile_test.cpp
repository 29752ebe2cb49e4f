#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstring>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/random.hpp"
#include "workshop.hpp"

// The headers are compiled by a C compiler ($CC, or cc) and compared with the exact engine: a
// million values with the correctly rounded ones, the worst of them with the exact ones.

using namespace phrame;
using test::check_failure;
using test::check_success;
using test::contains;
using test::Run;
using test::Workshop;

namespace {

constexpr long million = 1'000'000;

/// Writes, for each double it reads, θ and the frame (of CURVE's header, but for -DNO_FRAME) and
/// the two errors that the header states, in the mode of rounding given. Fails where the functions
/// of arrays, of these doubles in their order and in disorder, give something else: where products
/// and sums may be fused, so much that one is wrong.
constexpr const char* evaluator = R"(
#include <stdio.h>
#include <stdlib.h>
#include <fenv.h>
#include "angle.h"
enum { many = 4099 };
static double t[many], mixed[many], theta[many], rows[many][12];
#ifdef ARM_FRAME_ERROR
static double frames[9 * many];
#endif

static int agree(double a, double b, double error)
{
#ifdef __FMA__
  if (a - b <= 2 * error && b - a <= 2 * error) return 1;
#endif
  (void)error;
  return (a == b) | ((a != a) & (b != b));
}

static int are_as_one_by_one(size_t n, size_t step)
{
  for (size_t k = 0; k < n; ++k) mixed[k] = theta[k] = t[k * step % n];
  arm_theta_array(theta, theta, n);
#ifdef ARM_FRAME_ERROR
  arm_frame_array(mixed, frames, n);
#endif
  for (size_t k = 0; k < n; ++k) {
    const double *row = rows[k * step % n];
    if (!agree(theta[k], row[0], ARM_THETA_ERROR)) return 0;
#ifdef ARM_FRAME_ERROR
    for (size_t i = 0; i < 9; ++i)
      if (!agree(frames[9 * k + i], row[1 + i], ARM_FRAME_ERROR)) return 0;
#endif
  }
  return 1;
}

int main(int argc, char **argv)
{
  size_t n;
  if (argc > 1) fesetround(atoi(argv[1]));
  while ((n = fread(t, sizeof *t, many, stdin)) > 0) {
    for (size_t k = 0; k < n; ++k) {
      double *out = rows[k];
      out[0] = arm_theta(t[k]);
      out[10] = ARM_THETA_ERROR;
#ifdef ARM_FRAME_ERROR
      arm_frame(t[k], out + 1, out + 4, out + 7);
      out[11] = ARM_FRAME_ERROR;
#endif
    }
    if (fwrite(rows, sizeof *rows, n, stdout) != n) return 1;
    if (!are_as_one_by_one(n, 1) || !are_as_one_by_one(n, n - 1) || !are_as_one_by_one(n, 61)) return 3;
  }
  return 0;
}
)";
using Row = std::array<double, 12>;

/// Compiles the header angle.h in the workshop with the options.
void build_evaluator(const Workshop& shop, const std::string& options) {
  shop.write("evaluator.c", evaluator);
  const char* compiler = std::getenv("CC");
  const std::string command = "cd '" + shop.file(".").string() + "' && " +
                              (compiler == nullptr ? "cc" : compiler) +
                              " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror " + options +
                              " evaluator.c -o evaluator -lm";
  REQUIRE(std::system(command.c_str()) == 0);
}

/// The rows of what was compiled.
std::vector<Row> rows_at(const Workshop& shop, const std::vector<double>& at,
                         const std::string& mode = "") {
  std::string bytes(at.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), at.data(), bytes.size());
  shop.write("t.bin", bytes);
  const std::string command =
      "cd '" + shop.file(".").string() + "' && ./evaluator " + mode + " <t.bin >rows.bin";
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string rows = test::bytes_of(shop.file("rows.bin"));
  std::vector<Row> result(at.size());
  REQUIRE(rows.size() == at.size() * sizeof(Row));
  std::memcpy(result.data(), rows.data(), rows.size());
  return result;
}

std::vector<Row> evaluated(const Workshop& shop, const std::vector<double>& at,
                           const std::string& options) {
  build_evaluator(shop, options);
  return rows_at(shop, at);
}

/// Evenly spaced, the ends of [0, 1] among them.
std::vector<double> even_parameters(long count) {
  std::vector<double> at;
  for (long k = 0; k < count; ++k)
    at.push_back(static_cast<double>(k) / static_cast<double>(count - 1));
  return at;
}

Rational distance(double x, const Real& y) {
  const RealBall off = subtract(RealBall(exact_rational(x), 200), y.enclose(160), 200);
  return absolute(off).upper();
}

/// Every θ is off by no more than the header says, the worst ones compared with the exact angle.
void check_angles(const std::vector<double>& at, const std::vector<Row>& rows, RmfAngle& angle) {
  CompiledAngle rounded(angle, 0, 1);
  std::vector<std::pair<double, std::size_t>> worst;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double theta = rounded(at[k]);
    const double off = std::abs(rows[k][0] - theta);
    const double half_ulp = (std::nextafter(std::abs(theta), 10) - std::abs(theta)) / 2;
    if (!(off <= rows[k][10] + half_ulp)) FAIL_CHECK("θ is off by " << off << " at " << at[k]);
    worst.emplace_back(off, k);
  }
  std::partial_sort(worst.begin(), worst.begin() + 100, worst.end(), std::greater<>());
  for (int i = 0; i < 100; ++i) {
    const std::size_t k = worst[static_cast<std::size_t>(i)].second;
    CAPTURE(at[k]);
    CHECK(distance(rows[k][0], angle.value(exact_rational(at[k]))) <= exact_rational(rows[k][10]));
  }
}

void check_frames(const std::vector<double>& at, const std::vector<Row>& rows, const Curve& curve,
                  RmfAngle& angle) {
  const CompiledFrames rounded(curve, angle, 0, 1);
  std::vector<std::pair<double, std::size_t>> worst;
  for (std::size_t k = 0; k < at.size(); k += 5) {
    const Frame<double> frame = rounded(at[k]);
    double off = 0;
    for (std::size_t i = 0; i < 3; ++i)
      off = std::max({off, std::abs(rows[k][1 + i] - frame.e1[i]),
                      std::abs(rows[k][4 + i] - frame.e2[i]),
                      std::abs(rows[k][7 + i] - frame.e3[i])});
    if (!(off <= rows[k][11] + 0x1p-53))
      FAIL_CHECK("the frame is off by " << off << " at " << at[k]);
    worst.emplace_back(off, k);
  }
  std::partial_sort(worst.begin(), worst.begin() + 20, worst.end(), std::greater<>());
  const Frames frames(curve);
  for (int j = 0; j < 20; ++j) {
    const std::size_t k = worst[static_cast<std::size_t>(j)].second;
    const auto exact = frames.rotation_minimizing(angle, exact_rational(at[k]));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(distance(rows[k][1 + i], exact.e1[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][4 + i], exact.e2[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][7 + i], exact.e3[i]) <= exact_rational(rows[k][11]));
    }
  }
}

/// The line of tests/data/curves.jsonl with that name.
std::string curve_named(const std::string& name) {
  std::ifstream file(test::data("/curves.jsonl"));
  for (std::string line; std::getline(file, line);)
    if (test::contains(line, "\"name\": \"" + name + "\"")) return line;
  FAIL(name);
  return {};
}

}  // namespace

TEST_CASE("compile: the values of a header are as exact as it says") {
  for (const std::string name : {"seed-farouki2003", "gen-m10-0", "deg-hzero", "deg-line"}) {
    CAPTURE(name);
    const auto at =
        even_parameters(name == "seed-farouki2003" ? test::everyday(million / 10, million)
                                                   : test::everyday(million / 40, million / 5));
    const Workshop shop;
    shop.write("curve.json", curve_named(name));
    const auto run = shop.run("compile curve.json --start erf --prefix arm -o angle.h");
    CHECK(run.status == 0);
    const Curve curve = read_curve(curve_named(name)).curve;
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const auto rows = evaluated(shop, at, "-std=c99 -O2");
    check_angles(at, rows, angle);
    check_frames(at, rows, curve, angle);
    CHECK(rows[0][10] < 0x1p-50);
    CHECK(rows[0][11] < 0x1p-50);
  }
}

TEST_CASE("compile: on a near-cusp, with every optimization that keeps IEEE arithmetic") {
  const std::string text = curve_named("deg-nearcusp");
  const Curve curve = read_curve(text).curve;
  RmfAngle angle(curve, Reference::euler_rodrigues);
  auto at = even_parameters(test::everyday(5'000, 20'000));
  // And next to t = 1/3, where θ turns within 1e-8.
  for (long k = -20'000; k < 20'000; k += test::everyday(4, 1))
    at.push_back(1.0 / 3 + static_cast<double>(k) * 2e-12);
  const Workshop shop;
  shop.write("curve.json", text);
  CHECK(shop.run("compile curve.json --start erf --prefix arm -o angle.h").status == 0);
  for (const std::string options : {"-std=c11 -O3 -march=native", "-x c++ -std=c++17 -O0"}) {
    CAPTURE(options);
    const auto rows = evaluated(shop, at, options);
    check_angles(at, rows, angle);
    check_frames(at, rows, curve, angle);
  }
}

TEST_CASE("compile: other intervals and angles, Frenet's frame, and what is outside") {
  const Workshop shop;
  CHECK(
      shop.run("compile quintic.json --frame frenet --start frenet --theta0 7/3 --from -1/2 --to 3 "
               "--prefix arm -o angle.h")
          .status == 0);
  CHECK_FALSE(test::contains(test::bytes_of(shop.file("angle.h")), "arm_frame"));
  const Curve curve = read_curve(test::bytes_of(shop.file("quintic.json"))).curve;
  RmfAngle angle(curve, Reference::frenet);
  std::vector<double> at;
  for (long k = 0; k <= 200; ++k) at.push_back(-0.5 + static_cast<double>(k) * 3.5 / 200);
  const auto rows = evaluated(shop, at, "-std=c99 -O2");
  for (std::size_t k = 0; k < at.size(); ++k)
    CHECK(distance(rows[k][0], angle.value(exact_rational(at[k])) + Rational(7, 3)) <=
          exact_rational(rows[k][10]));
  for (const Row& row : evaluated(shop, {-0.51, 3.01, 1e300, HUGE_VAL, std::nan("")}, "-std=c99"))
    CHECK(std::isnan(row[0]));
}

TEST_CASE("compile: nothing where rounding is another, or constants are floats") {
  const Workshop shop;
  CHECK(shop.run("compile quintic.json --prefix arm -o angle.h").status == 0);
  const std::vector<double> at{0, 0.3, 1};
  build_evaluator(shop, "-std=c99 -O2");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (const Row& row : rows_at(shop, at, std::to_string(mode)))
      for (std::size_t k = 0; k < 10; ++k) CHECK(std::isnan(row[k]));
  for (const Row& row : rows_at(shop, at, std::to_string(FE_TONEAREST)))
    CHECK_FALSE(std::isnan(row[0]));
  shop.write("constants.c", "#include \"angle.h\"\nint main(void) { return 0; }\n");
  const char* compiler = std::getenv("CC");
  const std::string compile = "cd '" + shop.file(".").string() + "' && " +
                              (compiler == nullptr ? "cc" : compiler) +
                              " -w constants.c -o constants 2>errors ";
  CHECK(std::system(compile.c_str()) == 0);
  // clang does not know the option, and gcc refuses the array.
  CHECK(std::system((compile + "-fsingle-precision-constant -Werror").c_str()) != 0);
}

TEST_CASE("compile: from a given normal, within the errors that are stated") {
  const Workshop shop;
  CHECK(shop.run("compile quintic.json --start-normal 1,2,-3 --prefix arm -o angle.h").status == 0);
  const Curve curve = read_curve(test::bytes_of(shop.file("quintic.json"))).curve;
  const RmfAngle angle(curve);
  const FrameAngle start = angle_of(GaussianRational{-2, -3});  // to e₂ = (−2, 1, 2)/3
  const auto at = even_parameters(201);
  const auto rows = evaluated(shop, at, "-std=c99 -O2");
  for (std::size_t k = 0; k < at.size(); ++k) {
    CAPTURE(at[k]);
    const Real theta = angle.value(exact_rational(at[k])) + to_real(start);
    CHECK(distance(rows[k][0], theta) <= exact_rational(rows[k][10]));
    const auto exact = turned(as_real(euler_rodrigues_frame(curve, exact_rational(at[k]))), theta);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(distance(rows[k][4 + i], exact.e2[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][7 + i], exact.e3[i]) <= exact_rational(rows[k][11]));
    }
  }
  CHECK(rows[0][10] < 0x1p-50);
  CHECK(rows[0][11] < 0x1p-49);
}

TEST_CASE("compile: of a spline there is one angle and one frame, through the joints") {
  const Workshop shop;
  shop.write("spline.json", test::bytes_of(test::root("/examples/curves/closed-spline.json")));
  CHECK(shop.run("compile spline.json --start erf --theta0 1/3 --prefix arm -o angle.h").status ==
        0);
  const PhPath path = read_path(test::bytes_of(shop.file("spline.json"))).path;
  REQUIRE(path.segments().size() > 2);
  PathAngle angle(path);
  std::vector<double> at{std::nextafter(1, 0), std::nextafter(1, 2), std::nextafter(2, 0)};
  const double end = static_cast<double>(path.segments().size());
  for (long k = 0; k <= 160; ++k) at.push_back(static_cast<double>(k) * end / 160);
  const auto rows = evaluated(shop, at, "-std=c99 -O2");
  for (std::size_t k = 0; k < at.size(); ++k) {
    CAPTURE(at[k]);
    const PathParameter t = locate(path, exact_rational(at[k]));
    const Real theta = angle.value(t) + Rational(1, 3);
    CHECK(distance(rows[k][0], theta) <= exact_rational(rows[k][10]));
    const Frames frames(path.segments()[t.segment]);
    const auto exact = turned(as_real(frames.euler_rodrigues(t.t)), theta);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(distance(rows[k][1 + i], exact.e1[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][4 + i], exact.e2[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][7 + i], exact.e3[i]) <= exact_rational(rows[k][11]));
    }
  }
  CHECK(rows[0][11] < 0x1p-50);
  check_failure(shop.run("compile spline.json --to 2"), 2, "--to: is for single polynomial");
  // What is given is not ignored, though it be the default of a curve.
  check_failure(shop.run("compile spline.json --to 1"), 2, "--to: is for single polynomial");
  check_failure(shop.run("compile spline.json --from 0"), 2, "--from: is for single polynomial");
  check_failure(shop.run("compile spline.json --frame frenet"), 3, "at the joint t = 1 it jumps");
}

TEST_CASE("compile: more pieces than a short index can count") {
  constexpr std::size_t count = 70'000;
  const auto step = [](double low, double high) {  // θ = k on [k, k + 1]
    auto piece = empty_piece(low, high);
    piece->coefficients =
        round_coefficients({BallPolynomial({RealBall(exact_rational(low), 64)})}, plain_shape(1));
    return piece;
  };
  const Curve line({{1}, {}, {}, {}});
  const CompiledAnswer compiled{NamedPhPath("", line), Reference::euler_rodrigues, Angle(),
                                FrameAngle(),
                                shared(PiecewisePolynomial::on_units(count, plain_shape(1), step))};
  const std::string header = to_c_header(compiled, "arm");
  CHECK(contains(header, "static const unsigned long"));
  if (test::multiplier() == 1) return;  // compilers take seconds for so many
  const Workshop shop;
  shop.write("angle.h", header);
  const auto rows = evaluated(shop, {0.5, 65535.5, 65536, 65537.5, 69999.5, 70000}, "-std=c99");
  const std::vector<double> expected{0, 65535, 65536, 65537, 69999, 69999};
  for (std::size_t k = 0; k < rows.size(); ++k) CHECK(rows[k][0] == expected[k]);
}

TEST_CASE("compile: names in C come from the curve's, and --prefix must be one") {
  const Workshop shop;
  const auto names = [&](const std::string& name) {
    shop.write("named.json", R"({"phrame": "curve/1", "name": ")" + name + R"(", "basis": "power",
        "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})");
    const auto run = shop.run("compile named.json");
    check_success(run);
    const std::size_t at = run.out.find(" * double ");
    REQUIRE(at != std::string::npos);
    return run.out.substr(at + 10, run.out.find('(', at) - at - 10);
  };
  CHECK(names("arm-2 of /* a robot */") == "arm_2_of_a_robot_theta");
  CHECK(names(std::string(39, 'x') + "/y") == std::string(39, 'x') + "_theta");
  CHECK(names("2nd") == "curve_2nd_theta");
  CHECK(names("кривая") == "curve_theta");
  CHECK(names("") == "curve_theta");

  for (const std::string prefix : {"2nd", "_a", "a b", "a-b", "é", "a__b", "a_"})
    check_failure(shop.run("compile quintic.json --prefix '" + prefix + "'"), 2, "--prefix");
  check_failure(shop.run("compile quintic.json --from 1"), 2, "--to: \"1\"");
  check_failure(shop.run("compile quintic.json --to x"), 2, "--to: ");
  check_failure(shop.run("compile quintic.json --to 1e309"), 2, "--to: \"1e309\" is too large");
  check_failure(shop.run("compile quintic.json --theta0 1e309"), 2,
                "--theta0: \"1e309\" is too large for a double");
  check_failure(shop.run("compile quintic.json --to 1e280"), 2,
                "--to: \"1e280\": the interval is longer than 2^900\n");
  check_failure(shop.run("compile quintic.json --from=-1e308 --to 1e308"), 2,
                "--to: \"1e308\": the interval is longer than 2^900\n");
  check_failure(shop.run("compile quintic.json --to 1e-280"), 2,
                "--to: \"1e-280\": the interval is shorter than 2^-900\n");
  // 2⁹⁰⁰ = 8.45e270.
  check_success(shop.run("compile line.json --to 8e270"));
  check_failure(shop.run("compile line.json --frame frenet"), 3, "straight line");
  shop.write("steep.json", R"({"phrame": "curve/1", "basis": "power", "preimage":
      {"u": [1], "v": ["-1e19", "3e19"], "p": ["-1e19", "3e19"], "q": [1, 1]}})");
  check_failure(shop.run("compile steep.json -o steep.h"), 4, "next to t = 0.33333");
  CHECK_FALSE(std::filesystem::exists(shop.file("steep.h")));
}

// Against the exact angles and frames, whose values have tests of their own.
TEST_CASE("compile: curves of any kind, by angles to the frame of v") {
  const Workshop shop;
  shop.write("cubic.json", R"({"phrame": "curve/1", "name": "cubic", "weights": [1, 2, "1/2", 1],
      "control_points": [[0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 2, 3]]})");
  CHECK(shop.run("compile cubic.json --up 0,0,1 --start up --theta0 1/8 --prefix arm -o angle.h")
            .status == 0);
  const std::string header = test::bytes_of(shop.file("angle.h"));
  CHECK(test::contains(header, "frame (e1, e2, e3) of v = (0, 0, 1),"));
  CHECK(test::contains(header, "theta(0) = 1/8."));
  const Path path(
      bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}, {1, 2, Rational(1, 2), 1}));
  const PathAngle angle(path, {0, 0, 1});
  const Real start = Rational(1, 8);
  const auto at = even_parameters(1001);
  const auto rows = evaluated(shop, at, "-std=c99 -O2");
  CHECK(rows[0][10] < 0x1p-50);
  CHECK(rows[0][11] < 0x1p-50);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Place t(0, exact_rational(at[k]));
    CHECK(distance(rows[k][0], angle.value(t) + start) <= exact_rational(rows[k][10]));
    const Frame<Real> exact = rotation_minimizing_frame(angle, t, start);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(distance(rows[k][1 + i], exact.e1[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][4 + i], exact.e2[i]) <= exact_rational(rows[k][11]));
      CHECK(distance(rows[k][7 + i], exact.e3[i]) <= exact_rational(rows[k][11]));
    }
  }
  const Run frenet = shop.run("compile cubic.json --frame frenet");
  check_success(frenet);
  CHECK_FALSE(test::contains(frenet.out, "cubic_frame"));
  check_success(shop.run("compile cubic.json --start-normal 1,1,0"));
  check_failure(shop.run("compile cubic.json --to 1/2"), 2,
                "--to: is for single polynomial Pythagorean");
  check_failure(shop.run("compile cubic.json --frame erf"), 2, "--frame: \"erf\" needs");
  check_failure(shop.run("compile cubic.json --up 1,0,0"), 2, "--up: the up vector (1, 0, 0) is");
  check_failure(shop.run("compile cubic.json --start-normal 1,0,0"), 2, "--start-normal: ");
}

// Of what fails, the reason is the only line.
TEST_CASE("compile: a note about --near is for what is answered") {
  const Workshop here;
  here.write("huge.csv",
             "# kind: bezier\n# degree: 3\nx,y,z\n0,.5,0x1p1023\n1,2,0\n2,0,1\n3,1,1\n");
  check_failure(here.run("compile huge.csv"), 4, "double");
  const Run info = here.run("info huge.csv");
  CHECK(info.status == 0);
  CHECK(contains(info.err, "huge.csv: a PH curve is at most "));
}
