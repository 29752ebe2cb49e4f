#include "phrame/answer/frame_table.hpp"
#include "phrame/io/write/frame_table.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

using namespace phrame;

namespace {

using Row = std::vector<double>;
using Kind = TabulatedFrame;

/// A = 1 + t²k: r′ = (1 − t⁴, 2t², 0), a plane curve with an inflection at t = 0.
Curve inflected() {
  return Curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial{0, 0, 1}});
}

std::string message(const Curve& curve, TabulatedFrame frame, const Rational& t) {
  return test::refusal_of<Error>([&] { frame_table(curve, {frame}, {t}); });
}

}  // namespace

TEST_CASE("frame table: the columns are named after the vectors, in the order asked for") {
  const FrameTable table = frame_table(test::farouki_quintic().curve,
                                       {Kind::frenet, Kind::rmf, Kind::euler_rodrigues}, {});
  CHECK(table.columns == std::vector<std::string>{"t",   "x",   "y",   "z",   "e1x", "e1y", "e1z",
                                                  "nx",  "ny",  "nz",  "bx",  "by",  "bz",  "f2x",
                                                  "f2y", "f2z", "f3x", "f3y", "f3z", "e2x", "e2y",
                                                  "e2z", "e3x", "e3y", "e3z"});
  CHECK(table.rows.empty());
}

// At t = 1, A = 1 + i + j + k turns i → j → k → i, so (e₁, e₂, e₃) = (j, k, i), and θ = −1:
// f₂ = cos 1·k − sin 1·i, f₃ = sin 1·k + cos 1·i. r(1) = ∫₀¹ A i A*: x′ = u² + v² − p² − q² = t⁴ −
// 1, y′ = 2(uq + vp) = 4t², z′ = 2(vq − up) = 2t − 2t³. The decimals of cos 1 and sin 1 are well
// known.
TEST_CASE("frame table: values are the correctly rounded doubles") {
  const double cos1 = 0.540302305868139717400936607443;
  const double sin1 = 0.841470984807896506652502321630;
  const Curve curve = test::rational_angle_curve().curve;
  TableColumns columns{{Kind::euler_rodrigues, Kind::rmf}};
  columns.start = Angle();
  const FrameTable table = frame_table(curve, columns, {Rational(0), Rational(1)});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[1] == Row{1, -0.8, 4.0 / 3, 0.5, 0, 1, 0,  //
                             0, 0, 1, 1, 0, 0,                //
                             -sin1, 0, cos1, cos1, 0, sin1});
  // At t = 0, A = k: e₁ = k i k* = −i, e₂ = −j, e₃ = k, and the RMF is the ERF.
  CHECK(table.rows[0] == Row{0, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, -1, 0, 0, 0, 1});
}

// At t = 1 the tangent is j and turns to the left (its angle is 2 atan t²): n = −i, b = k.
// r(1) = (1 − 1/5, 2/3, 0).
TEST_CASE("frame table: the Frenet frame is tangent, normal, binormal") {
  const FrameTable table = frame_table(inflected(), {Kind::frenet}, {1});
  CHECK(table.rows.at(0) == Row{1, 0.8, 2.0 / 3, 0, 0, 1, 0, -1, 0, 0, 0, 0, 1});
}

TEST_CASE("frame table: where Frenet's frame is undefined, the reason and t are named") {
  CHECK_THROWS_AS(frame_table(inflected(), {Kind::frenet}, {1, 0}), DomainError);
  CHECK(message(inflected(), Kind::frenet, 0).find("t = 0 is an inflection") != std::string::npos);
  CHECK_THROWS_AS(frame_table(test::straight_line().curve, {Kind::frenet}, {1}), DomainError);
  CHECK(message(test::straight_line().curve, Kind::frenet, 1).find("straight line") !=
        std::string::npos);
  CHECK(message(inflected(), Kind::rmf, 0).empty());
}

// r(t) = (t − t⁵/5, 2t³/3, 0); at t = 1 r′ = (0, 2, 0), r″ = (−4, 4, 0), so that n = −i, b = k, κ
// = 1.
TEST_CASE("frame table: where a Frenet frame is undefined its cells are empty, if they may be") {
  TableColumns columns{{Kind::frenet, Kind::euler_rodrigues}, {TabulatedScalar::curvature}};
  columns.may_be_empty = true;
  const FrameTable table = frame_table(inflected(), columns, {Rational(0), Rational(1)});
  CHECK(table.incomplete_rows == 1);
  CHECK(table.first_reason.find("t = 0 is an inflection") != std::string::npos);
  CHECK(to_csv(table) ==
        "t,x,y,z,e1x,e1y,e1z,nx,ny,nz,bx,by,bz,e2x,e2y,e2z,e3x,e3y,e3z,curvature\n"
        "0,0,0,0,1,0,0,,,,,,,0,1,0,0,0,1,0\n"
        "1,0.8,0.6666666666666666,0,0,1,0,-1,0,0,0,0,1,-1,0,0,0,0,1,1\n");
  const auto rows = test::Json::parse(to_json(table))["rows"];
  CHECK(rows[0][6] == 0);
  CHECK(rows[0][7] == nullptr);
  CHECK(rows[0][12] == nullptr);
  CHECK(rows[0][13] == 0);
  CHECK(rows[1][7] == -1);
  const std::string npy = to_npy(table);  // 20 doubles a row, at the end; 7FF8… is NaN
  const std::string nx = npy.substr(npy.size() - 33 * 8, 8);
  CHECK(nx == std::string("\0\0\0\0\0\0\xF8\x7F", 8));
}

TEST_CASE("frame table: of a straight line, and where a curvature is infinite, cells are empty") {
  TableColumns columns{{Kind::frenet}};
  columns.may_be_empty = true;
  const Curve line({{1}, {}, {}, {}});
  const FrameTable straight = frame_table(line, columns, {Rational(0), Rational(1)});
  CHECK(straight.incomplete_rows == 2);
  CHECK(to_csv(straight).ends_with("\n0,0,0,0,1,0,0,,,,,,\n1,1,0,0,1,0,0,,,,,,\n"));
  // r′ = t·(1 − t², 2t, 0) has a cusp at 0 with κ = 2/(t(1 + t²)²).
  const Curve cusp({{1}, {}, {}, {0, 1}}, Polynomial{0, 1});
  columns = {{}, {TabulatedScalar::curvature}};
  CHECK_THROWS_AS(frame_table(cusp, columns, {Rational(0)}), DomainError);
  columns.may_be_empty = true;
  const FrameTable table = frame_table(cusp, columns, {Rational(1), Rational(0)});
  CHECK(to_csv(table).ends_with("0.5\n0,0,0,0,1,0,0,\n"));
}

TEST_CASE("frame table: an overflow is refused, not rounded to infinity") {
  // r = (t, 0, 0)
  CHECK(frame_table(test::straight_line().curve, {Kind::rmf}, {power_of_ten(308)}).rows[0][1] ==
        1e308);
  CHECK_THROWS_AS(frame_table(test::straight_line().curve, {Kind::rmf}, {power_of_ten(309)}),
                  InputError);
  CHECK(message(test::farouki_quintic().curve, Kind::euler_rodrigues, power_of_ten(100))
            .find("x does not fit a double") != std::string::npos);
}

// κ, τ and ω at t = 1/3 by mpmath from numerical derivatives of the hodograph, 50 digits. At t = 0
// the paper's polynomials give κ² = ρ/σ⁴ = 720/6⁴ and τ = (r′ × r″)·r‴/(σ²ρ) = −576/(36·720).
TEST_CASE("frame table: arc length, curvature, torsion and the rate of the Frenet frame") {
  const Curve curve = test::farouki_quintic().curve;
  const TableColumns columns{{Kind::euler_rodrigues},
                             {TabulatedScalar::arc_length, TabulatedScalar::curvature,
                              TabulatedScalar::torsion, TabulatedScalar::frenet_rate}};
  const FrameTable table = frame_table(curve, columns, {Rational(1, 3), Rational(0), Rational(1)});
  const std::size_t n = table.columns.size();
  CHECK(std::vector(table.columns.end() - 4, table.columns.end()) ==
        std::vector<std::string>{"s", "curvature", "torsion", "frenet_rate"});
  const auto last = [](const Row& row) { return std::vector(row.end() - 4, row.end()); };
  REQUIRE(table.rows.size() == 3);
  CHECK(n == table.rows[0].size());
  const Row inside = last(table.rows[0]);
  CHECK(Row(inside.begin() + 1, inside.end()) == Row{0.38141781257101745976686709325,
                                                     -0.506069935540408449353258044013,
                                                     0.633708393036050113137971138708});
  CHECK(last(table.rows[1]) ==
        Row{0, 0.745355992499929898803057889577, -1.0 / 45, 0.745687188247222994164498219777});
  CHECK(last(table.rows[2])[0] == 71.0 / 15);
}

// A = 1 + tk: r = (t − t³/3, t², 0), e₁ = (1 − t², 2t, 0)/(1 + t²), κ = 2/(1 + t²)². At t = 1/√2,
// which is 0.70710678118654752440…: y = 1/2, e₁ = (1/3, 2√2/3, 0), κ = 8/9, s = t + t³/3 = 7√2/12.
TEST_CASE("frame table: at an irrational t the rational values are exact, the others rounded") {
  const Curve curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial{0, 1}});
  const RealAlgebraic t = real_root({-1, 0, 2}, closed_interval(0, 1));
  const TableColumns columns{
      {Kind::rmf, Kind::frenet, Kind::euler_rodrigues},
      {TabulatedScalar::curvature, TabulatedScalar::torsion, TabulatedScalar::arc_length}};
  const FrameTable table = frame_table(curve, columns, {t});
  const double third = 1.0 / 3;
  const double root = 0.942809041582063365867792482806;  // 2√2/3
  CHECK(table.rows.at(0) == Row{0.707106781186547524400844362105,
                                0.589255650988789603667370301754,
                                0.5,
                                0,
                                third,
                                root,
                                0,  //
                                -root,
                                third,
                                0,
                                0,
                                0,
                                1,  // the ERF does not turn
                                -root,
                                third,
                                0,
                                0,
                                0,
                                1,  //
                                -root,
                                third,
                                0,
                                0,
                                0,
                                1,  //
                                8.0 / 9,
                                0,
                                0.824957911384305445134318422455});
}

TEST_CASE("frame table: scalars that are undefined or infinite are refused, with t") {
  const auto message = [](const Curve& curve, TabulatedScalar scalar, const RealAlgebraic& t) {
    return test::refusal_of<DomainError>([&] { frame_table(curve, {{}, {scalar}}, {t}); });
  };
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const Curve line = test::straight_line().curve;
  CHECK(contains(message(line, TabulatedScalar::torsion, Rational(0)), "straight line"));
  CHECK(message(line, TabulatedScalar::curvature, Rational(0)).empty());
  const Polynomial c{-1, 0, 2};
  const Curve cusped({c, Polynomial(), Polynomial(), c * Polynomial{0, 1}});
  const RealAlgebraic cusp = real_root(c, closed_interval(0, 1));
  CHECK(contains(message(cusped, TabulatedScalar::curvature, cusp),
                 "curvature: infinite at t ≈ 0.707106781187"));
  CHECK(message(cusped, TabulatedScalar::curvature, Rational(1)).empty());
  // Half as long up to t = 1/2, and back.
  const Curve turning({{1}, {}, {}, {}}, {-1, 2});
  const auto back = frame_table(turning, {{}, {TabulatedScalar::arc_length}},
                                {Rational(0), Rational(1, 2), Rational(3, 4), Rational(1)});
  CHECK(back.rows[0].back() == 0);
  CHECK(back.rows[1].back() == 0.25);
  CHECK(back.rows[2].back() == 0.3125);
  CHECK(back.rows[3].back() == 0.5);
  const Curve widening({{1}, {}, {}, {}}, {1, 1});
  CHECK(contains(message(widening, TabulatedScalar::arc_length, Rational(3, 2)),
                 "t = 3/2 is outside [0, 1]"));
  CHECK(message(widening, TabulatedScalar::arc_length, Rational(1)).empty());
  CHECK(message(line, TabulatedScalar::arc_length, Rational(-7)).empty());
}

// f′ = −(f·e₁′)e₁ from the projected vector at t = 0, by mpmath's Taylor series method.
TEST_CASE("frame table: the rotation-minimizing frame starts where it is asked to") {
  TableColumns columns{{Kind::rmf, Kind::euler_rodrigues}};
  columns.start = StartNormal({1, 2, -3});
  const auto at = [&](const RealAlgebraic& t) {
    const Row row = frame_table(test::quintic, columns, {t}).rows[0];
    return Row(row.begin() + 7, row.begin() + 10);
  };
  CHECK(at(Rational(0)) ==
        Row{0.09245003270420485367, 0.36980013081681941468, -0.9245003270420485367});
  CHECK(at(Rational(1, 3)) ==
        Row{0.37943567170755379896, 0.89121339729086589591, -0.24853018232220947318});
  CHECK(at(Rational(1)) ==
        Row{0.23805579746694417487, -0.17854184810020813116, -0.95470008158025181009});
  columns.start = StartNormal({Rational(1, 3), 0, 5});
  CHECK(at(Rational(1)) ==
        Row{-0.34706300803479110769, 0.26029725602609333076, 0.90099534236261673487});
  // At an irrational t between two rational ones.
  const RealAlgebraic root = real_root({-1, 0, 2}, closed_interval(0, 1));
  const Rational near = parse_rational("0.70710678118654752440084436210484903928");
  const Row exact = at(root);
  const Row beside = at(near);
  for (std::size_t k = 0; k < 3; ++k) CHECK(exact[k] == beside[k]);
  // An angle is that to e₂; whole turns are no matter, however many.
  columns.start = Angle(Rational(1, 3), Rational(1, 7));
  const Row some = at(Rational(2, 5));
  columns.start = Angle(2 * power_of_ten(40) + Rational(1, 3), Rational(1, 7));
  CHECK(at(Rational(2, 5)) == some);
  columns.start = StartNormal({2, 2, 1});
  CHECK_THROWS_AS(at(Rational(0)), DomainError);
}

TEST_CASE("frame table: CSV reads back to the same doubles") {
  const FrameTable table = frame_table(test::farouki_quintic().curve, {Kind::rmf, Kind::frenet},
                                       {0, Rational(1, 3), power_of_ten(-30), -1000});
  std::istringstream lines(to_csv(table));
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(line == "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z,nx,ny,nz,bx,by,bz");
  for (const Row& row : table.rows) {
    REQUIRE(std::getline(lines, line));
    Row read;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      char* end = nullptr;
      read.push_back(std::strtod(cell.c_str(), &end));
      CHECK(*end == '\0');
    }
    CHECK(read == row);
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("frame table: JSON reads back to the same doubles") {
  const FrameTable table =
      frame_table(test::farouki_quintic().curve, {Kind::rmf}, {0, Rational(1, 7), 1});
  const test::Json json = test::Json::parse(to_json(table));
  CHECK(json["phrame"] == "frames/1");
  CHECK(json["columns"].get<std::vector<std::string>>() == table.columns);
  CHECK(json["rows"].get<std::vector<Row>>() == table.rows);
}

// numpy.lib.format: "\x93NUMPY", version 1.0, the length of the header in two bytes, low one first,
// the header, a Python literal that ends in a newline and pads all to a multiple of 64, then the
// data.
TEST_CASE("frame table: npy has a valid header, then the rows as little-endian doubles") {
  for (const std::size_t count : {0U, 1U, 3U, 12U, 101U}) {
    FrameTable table{{"t", "x"}, {}};
    for (std::size_t k = 0; k < count; ++k)
      table.rows.push_back({1.0 / (1.0 + static_cast<double>(k)), -2.5});
    const std::string bytes = to_npy(table);
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes.at(k)); };
    CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = byte(8) + 256U * byte(9);
    CHECK((10 + length) % 64 == 0);
    const std::string header = bytes.substr(10, length);
    const std::string literal =
        "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ", 2), }";
    CHECK(header.starts_with(literal));
    CHECK(header.find_first_not_of(' ', literal.size()) == length - 1);
    CHECK(header.back() == '\n');
    REQUIRE(bytes.size() == 10 + length + 16 * count);
    for (std::size_t k = 0; k < 2 * count; ++k) {
      std::uint64_t bits = 0;
      for (std::size_t b = 8; b-- > 0;) bits = bits << 8U | byte(10 + length + 8 * k + b);
      CHECK(std::bit_cast<double>(bits) == table.rows[k / 2][k % 2]);
    }
  }
}

TEST_CASE("frame table: the rows of a long table are those of short ones") {
  // A curve; one in a plane, with components 0 and irrational angles; one with a rational frame; a
  // line; a near-cusp that has no compiled frame; and t beyond [0, 1], in no order.
  const Polynomial steep = parse_rational("1e19") * Polynomial{-1, 3};
  const std::vector<Curve> curves{test::quintic,
                                  inflected(),
                                  Curve({Polynomial{1, 2}, Polynomial{0, 1}, {}, {}}),
                                  Curve(test::class_one),
                                  Curve({Polynomial{1}, {}, {}, {}}),
                                  Curve({Polynomial{1}, steep, steep, Polynomial{1, 1}})};
  for (const Curve& curve : curves) {
    std::vector<Rational> at;
    for (long k = 0; k < 1200; ++k) at.emplace_back((k * 389) % 1200 - 100, 997);
    at[7] = at[8];
    const std::vector<RealAlgebraic> points(at.begin(), at.end());
    for (const FrameStart& start :
         {FrameStart(), FrameStart(StartNormal({3, -1, 2})), FrameStart(Angle(Rational(5, 3)))}) {
      TableColumns columns{{Kind::rmf, Kind::euler_rodrigues}};
      columns.start = start;
      const FrameTable all = frame_table(curve, columns, points);
      for (std::size_t k = 0; k < at.size(); k += start == FrameStart() ? 29 : 101) {
        CAPTURE(at[k]);
        CHECK(all.rows[k] == frame_table(curve, columns, {points[k]}).rows[0]);
      }
    }
  }
  // All t the same: there is no interval.
  const FrameTable one = frame_table(test::quintic, {Kind::rmf}, std::vector(1500, Rational(1, 3)));
  CHECK(one.rows.back() == frame_table(test::quintic, {Kind::rmf}, {Rational(1, 3)}).rows[0]);
}

namespace {

const Path no_ph(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}));

const Place start(0, Rational(0));

double angle_between(const Vector<double>& a, const Vector<double>& b) {
  return std::sqrt(dot(a - b, a - b));
}

}  // namespace

// f₂ is that of the solution of f₂′ = −(f₂·T′)T by mpmath's odefun (Taylor series, 30 digits); κ
// and τ are |r′ × r″|/|r′|³ and det(r′, r″, r‴)/|r′ × r″|².
TEST_CASE("frame table: those of a cubic that is no PH curve are correctly rounded") {
  TableColumns columns{{TabulatedFrame::rmf, TabulatedFrame::up, TabulatedFrame::frenet},
                       {TabulatedScalar::curvature, TabulatedScalar::torsion}};
  const FrameTable table =
      frame_table(PathAngle(no_ph, {0, 0, 1}), columns, {{0, Rational(1, 2)}, {0, Rational(1)}});
  REQUIRE(table.columns.size() == table.rows.at(0).size());
  const std::vector<double>& half = table.rows[0];
  CHECK(table.columns[7] == "f2x");
  CHECK(half[1] == 0.75);
  CHECK(half[7] == -0.9583377490235709016413);
  CHECK(half[8] == 0.1713824762533109234127);
  CHECK(half[9] == -0.2285099683377478978835);
  CHECK(table.rows[1][7] == -0.9451273385037555372876);
  CHECK(table.rows[1][8] == 0.08650185619593178435427);
  CHECK(table.columns[13] == "up2x");
  CHECK(half[15] == 0);  // v × e₁ is across v
  CHECK(half[half.size() - 2] == 0.66647463901070117497);
  CHECK(half.back() == 0.52459016393442622951);
  // At t = 1 the frame of v is the Frenet frame.
  const auto at = [&](std::size_t k) {
    return Vector<double>{table.rows[1][k], table.rows[1][k + 1], table.rows[1][k + 2]};
  };
  CHECK(table.columns[19] == "nx");
  CHECK(angle_between(at(13), at(19)) == 0);
}

TEST_CASE("frame table: columns that only PH curves have are refused") {
  CHECK_THROWS_AS(frame_table(PathAngle(no_ph), {{TabulatedFrame::euler_rodrigues}}, {start}),
                  DomainError);
}

// r = (t, t³, t⁴) has an inflection at t = 0, where τ = 72t²/(36t² + …) is 2 by continuity.
TEST_CASE("frame table: cells may be empty where the Frenet frame is undefined") {
  const Path inflected(
      RationalCurve({Polynomial{0, 1}, Polynomial{0, 0, 0, 1}, Polynomial{0, 0, 0, 0, 1}}));
  TableColumns columns{{TabulatedFrame::frenet}, {TabulatedScalar::torsion}};
  CHECK_THROWS_AS(frame_table(PathAngle(inflected), columns, {start}), DomainError);
  columns.may_be_empty = true;
  const FrameTable table = frame_table(PathAngle(inflected), columns, {start, {0, Rational(1)}});
  CHECK(table.incomplete_rows == 1);
  CHECK(std::isnan(table.rows[0][7]));
  CHECK(table.rows[0].back() == 2);
  CHECK_FALSE(std::isnan(table.rows[1][7]));
}

// A = 1 + tk, f = 1 − 2t²: t by mpmath's findroot of ∫|f|(1 + t²) dt = 3/5, the others by quad and
// by e₁ = (1 − t², 2t, 0)/(1 + t²). This frame is rotation-minimizing.
TEST_CASE("frame table: of an arc length behind an irrational change of sign") {
  const Path path(Curve({{1}, {}, {}, {0, 1}}, {1, 0, -2}));
  const Place at = PathLength(path).point(Rational(3, 5));
  REQUIRE_FALSE(algebraic_number(at).has_value());
  const TableColumns columns{{Kind::rmf},
                             {TabulatedScalar::arc_length, TabulatedScalar::curvature}};
  const Row row = frame_table(PathAngle(path), columns, {at}).rows.at(0);
  const double e1x = 0.121894021689566887984817568310821792681;
  const double e1y = 0.9925431212175838746391869677701570299692;
  CHECK(row[0] == 0.8847031021012294972670398310098274768333);
  CHECK(row[1] == 0.4090405978789396295227697897011828224722);
  CHECK(row[2] == 0.1700809481081163770042467696512569729325);
  CHECK(row[4] == e1x);
  CHECK(row[5] == e1y);
  CHECK(row[7] == -e1y);  // f₂ of the LeastRotation, (0, 1, 0) at t = 0
  CHECK(row[8] == e1x);
  CHECK(row[12] == 1);
  CHECK(row[13] == doctest::Approx(0.6).epsilon(1e-15));
  CHECK(row[14] == 1.113059843372229309740904796093203136368);
}

// The same curve at t = 1 as above: decimals of cos 1 and sin 1, to 30 digits.
TEST_CASE(
    "frame table: decimals have the digits that are asked for, and are empty where doubles are") {
  TableColumns columns{{Kind::rmf, Kind::frenet}};
  columns.start = Angle();
  columns.digits = 30;
  columns.may_be_empty = true;
  const FrameTable table =
      frame_table(test::rational_angle_curve().curve, columns, {RealAlgebraic(1)});
  REQUIRE(table.decimals.size() == 1);
  CHECK(table.decimals[0].size() == table.columns.size());
  CHECK(table.decimals[0][1] == "-0.800000000000000000000000000000");
  CHECK(table.decimals[0][2] == "1.33333333333333333333333333333");
  CHECK(table.decimals[0][7] == "-0.841470984807896506652502321630");
  CHECK(table.decimals[0][9] == "0.540302305868139717400936607443");
  const FrameTable inflection = frame_table(inflected(), columns, {RealAlgebraic(0)});
  CHECK(inflection.decimals[0].back().empty());
  CHECK(std::isnan(inflection.rows[0].back()));
  CHECK(to_json(inflection).find("null]]") != std::string::npos);
  CHECK(to_csv(inflection).ends_with(",,,,,,\n"));
}

// Around a circle of radius 2 the frame that starts with f₂ inwards keeps it so.
TEST_CASE("frame table: bends and angular velocity are those by which the frame turns") {
  TableColumns columns{{Kind::rmf}};
  columns.scalars = {TabulatedScalar::bend_f2, TabulatedScalar::bend_f3, TabulatedScalar::omega_x,
                     TabulatedScalar::omega_y, TabulatedScalar::omega_z};
  const Path circle(Segment(bezier_curve({{2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {1, 1, 2})));
  const std::vector<Place> at{{0, Rational(0)}, {0, Rational(1, 3)}};
  for (const auto& row : frame_table(PathAngle(circle), columns, at).rows) {
    const std::vector<double> last(row.end() - 5, row.end());
    CHECK(last == Row{0.5, 0, 0, 0, 0.5});
  }
}

TEST_CASE("frame table: law: f2 turns by -k1 and f3 by -k2 of the arc length, against e1") {
  TableColumns columns{{Kind::rmf}};
  columns.scalars = {TabulatedScalar::bend_f2, TabulatedScalar::bend_f3, TabulatedScalar::curvature,
                     TabulatedScalar::arc_length};
  const Rational t(1, 3), h(1, 100000);
  for (const Path& path : {Path(test::quintic), test::by_positions(test::quintic)}) {
    const auto rows =
        frame_table(PathAngle(path), columns, {{0, Rational(t - h)}, {0, t}, {0, Rational(t + h)}})
            .rows;
    const Row& row = rows[1];
    const double step = rows[2].back() - rows[0].back();
    for (const std::size_t first : {std::size_t{7}, std::size_t{10}}) {
      double along = 0;
      for (std::size_t k = 0; k < 3; ++k)
        along += (rows[2][first + k] - rows[0][first + k]) / step * row[4 + k];
      CHECK(std::abs(along + row[first == 7 ? 13 : 14]) < 1e-7);
    }
    CHECK(std::abs(std::hypot(row[13], row[14]) - row[15]) < 1e-15);
  }
}
