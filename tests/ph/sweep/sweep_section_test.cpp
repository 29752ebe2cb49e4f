#include "phrame/ph/sweep/sweep_section.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/sweep/sweep.hpp"

using namespace phrame;

// The bound of the normals, against normals of surfaces that are known in closed form: along a line
// and along curves y = f(x), and around a circle, where f₂ and f₃ are known. They come from
// differences of places on the surface, at many of its points on each pair of triangles.
namespace sweep_section_test {

using PlaneLocation = std::array<double, 2>;

struct KnownSurface {
  Path path;
  Vector<Rational> left;  ///< f₂ at its start
  /// Where (x, y) of the profile is, unscaled and not turned.
  std::function<Vector<double>(const PlaneLocation& place, double t)> at;
  /// Of a point of the first section, its (x, y).
  std::function<PlaneLocation(const Vector<double>& point)> first;
  std::function<double(const Vector<double>& center)> parameter;  ///< of r(t)
  bool is_closed = false;
  std::function<double(double t)> scale = [](double) { return 1; };
  std::function<double(double t)> turn = [](double) { return 0; };
  bool is_round = false;   ///< does the profile stand for a circle?
  PlaneLocation center{};  ///< of that

  Vector<double> place(const PlaneLocation& from, const PlaneLocation& to, double u,
                       double t) const {
    PlaneLocation p{from[0] + u * (to[0] - from[0]), from[1] + u * (to[1] - from[1])};
    if (is_round) {
      const auto& [x, y] = center;
      const double stretch = std::hypot(from[0] - x, from[1] - y) / std::hypot(p[0] - x, p[1] - y);
      p = {x + stretch * (p[0] - x), y + stretch * (p[1] - y)};
    }
    const double c = scale(t) * std::cos(turn(t));
    const double s = scale(t) * std::sin(turn(t));
    return at({c * p[0] - s * p[1], s * p[0] + c * p[1]}, t);
  }
  Vector<double> normal(const PlaneLocation& from, const PlaneLocation& to, double u,
                        double t) const {
    constexpr double h = 1e-6;
    return cross(place(from, to, u + h, t) - place(from, to, u - h, t),
                 place(from, to, u, t + h) - place(from, to, u, t - h));
  }
};

double angle_to(const Vector<double>& a, const Vector<double>& b) {
  const Vector<double> across = cross(a, b);
  return std::atan2(std::sqrt(dot(across, across)), dot(a, b));
}

/// The points of the mesh, in sections.
class Rings {
 public:
  Rings(const Mesh& mesh, std::size_t corners) : mesh_(mesh), corners_(corners) {}
  std::size_t count() const { return mesh_.points.size() / corners_; }
  Vector<double> center(std::size_t ring) const {
    Vector<double> sum{};
    for (std::size_t k = 0; k < corners_; ++k) sum = sum + mesh_.points[ring * corners_ + k];
    return 1.0 / static_cast<double>(corners_) * sum;
  }
  /// Of the two triangles between a ring and the next.
  std::array<Vector<double>, 2> normals(std::size_t ring, std::size_t side) const {
    std::array<Vector<double>, 2> found{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [a, b, c] = mesh_.triangles[2 * (ring * corners_ + side) + k];
      found[k] = cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
    }
    return found;
  }

 private:
  const Mesh& mesh_;
  std::size_t corners_;
};

SweepForm with_normals(Profile profile, double angle) {
  SweepForm form{std::move(profile), RationalFunction(Polynomial{1}), 0, Rational(1000)};
  form.normal_tolerance = angle;
  return form;
}

SweptBody swept(const KnownSurface& surface, const SweepForm& form) {
  const PathAngle angle(surface.path);
  const StartAngle start = start_angle(StartNormal(surface.left), angle);
  return sweep({series_of(surface.path), CompiledFrames(angle, start), surface.path.is_closed()},
               form);
}

/// The greatest angle between triangles and surface.
double greatest_angle(const KnownSurface& surface, const SweptBody& body) {
  const Mesh& mesh = body.mesh;
  const std::size_t count = mesh.points.size() / body.sections;
  std::vector<PlaneLocation> corners;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [x, y] = surface.first(mesh.points[k]);
    corners.push_back({x / surface.scale(0), y / surface.scale(0)});
  }
  const Rings rings(mesh, count);
  const std::size_t strips = rings.count() - (surface.is_closed ? 0 : 1);
  double greatest = 0;
  const std::size_t all = strips * count;
  std::size_t step = 1 + all / 300;
  while (std::gcd(step, count) > 1) ++step;
  for (std::size_t n = 0; n < all; n += step) {
    const std::size_t ring = n / count;
    const std::size_t side = n % count;
    const double from = surface.parameter(rings.center(ring));
    double to = surface.parameter(rings.center((ring + 1) % rings.count()));
    if (to < from) to += 1;
    for (const Vector<double>& normal : rings.normals(ring, side))
      for (double u = 0.005; u < 1; u += 0.33)
        for (double part = 0; part <= 1; part += 0.25)
          greatest = std::max(
              greatest, angle_to(normal, surface.normal(corners[side], corners[(side + 1) % count],
                                                        u, from + part * (to - from))));
  }
  return greatest;
}

/// Of surfaces without a turn at the start. The bound may be more than it need be by the factor.
void check_normals(const KnownSurface& surface, const SweepForm& form, double idle = 5) {
  const SweptBody body = swept(surface, form);
  REQUIRE(body.normal_error);
  CHECK(*body.normal_error <= *form.normal_tolerance);
  const double greatest = greatest_angle(surface, body);
  CHECK(greatest <= *body.normal_error + 1e-6);
  CHECK(greatest >= *body.normal_error / idle);
}

/// y = f(x) with f′(0) = 0, f₂ being to the left of it.
KnownSurface graph(const Polynomial& f) {
  const auto value = [f](double x) { return round_to_double(f(exact_rational(x))); };
  const auto slope = [df = differentiate(f)](double x) {
    return round_to_double(df(exact_rational(x)));
  };
  KnownSurface surface{
      Segment(RationalCurve({Polynomial{0, 1}, f, Polynomial()})), {0, 1, 0}, {}, {}, {}};
  surface.at = [value, slope](const PlaneLocation& place, double t) {
    const double length = std::hypot(1, slope(t));
    return Vector<double>{t - place[0] * slope(t) / length, value(t) + place[0] / length, place[1]};
  };
  surface.first = [](const Vector<double>& p) { return PlaneLocation{p[1], p[2]}; };
  surface.parameter = [](const Vector<double>& center) { return center[0]; };
  return surface;
}

/// (2 cos s, 2 sin s, 0), likewise.
KnownSurface around_a_circle() {
  const Formula s = Formula::variable();
  KnownSurface surface{
      Segment(ExpressionCurve({Formula(2) * cos(s), Formula(2) * sin(s), Formula(0)}, Formula(0),
                              Formula(0, 2))),
      {-1, 0, 0},
      {},
      {},
      {}};
  surface.at = [](const PlaneLocation& place, double t) {
    const double radius = 2 - place[0];
    const double angle = 2 * M_PI * t;
    return Vector<double>{radius * std::cos(angle), radius * std::sin(angle), place[1]};
  };
  surface.first = [](const Vector<double>& p) { return PlaneLocation{2 - p[0], p[2]}; };
  surface.parameter = [](const Vector<double>& center) {
    const double t = std::atan2(center[1], center[0]) / (2 * M_PI);
    return t < -1e-9 ? t + 1 : t;
  };
  surface.is_closed = true;
  return surface;
}

const Polynomial line{};
/// 16x²(1 − x)², level at both ends and half way.
const Polynomial wave = Polynomial{0, 0, 16} * Polynomial{1, -2, 1};
const Profile square = rectangle_profile(1, 1);
const Profile thread = rectangle_profile(Rational(1, 1000), Rational(1, 1000));

TEST_CASE("normals: of a torus they are within the bound, which is not idle") {
  KnownSurface torus = around_a_circle();
  torus.is_round = true;
  for (const double angle : {0.5, 0.1})
    check_normals(torus,
                  with_normals(circle_profile(Rational(1, 2), 1, exact_rational(angle / 2)), angle),
                  2);
  // A circle that fills much of the hole.
  check_normals(torus, with_normals(circle_profile(Rational(3, 2), 1, Rational(1, 20)), 0.1), 2);
}

// Where a chord has the direction of the tangents at both its ends the triangles have the normals
// of the corners.
TEST_CASE("normals: they are bounded between sections, too") {
  check_normals(graph(wave), with_normals(thread, 0.1));
  check_normals(graph(Polynomial{Rational(1, 256)} * wave), with_normals(thread, 0.006));
  check_normals(graph(Polynomial{0, 0, 3, -2}), with_normals(thread, 0.3));
  KnownSurface waist = graph(line);
  waist.scale = [](double t) { return 1 + 16 * t * t * (1 - t) * (1 - t); };
  SweepForm form = with_normals(square, 0.1);
  form.scale = RationalFunction(Polynomial{1} + wave);
  check_normals(waist, form);
}

// A scale, a turn, and both; along a line |r′| is even, and around a circle.
TEST_CASE("normals: of what turns and grows they are within the bound") {
  const RationalFunction scale(Polynomial{2} + wave, Polynomial{3});
  for (const bool is_circle : {false, true})
    for (const double turn : {0.0, 6 * M_PI})
      for (const bool grows : {false, true}) {
        KnownSurface surface = is_circle ? around_a_circle() : graph(line);
        SweepForm form = with_normals(rectangle_profile(Rational(1, 2), Rational(1, 8)), 0.35);
        form.turn = turn;
        surface.turn = [turn](double t) { return turn * t; };
        if (grows) {
          form.scale = scale;
          surface.scale = [](double t) { return (2 + 16 * t * t * (1 - t) * (1 - t)) / 3; };
        }
        CAPTURE(is_circle);
        CAPTURE(turn);
        CAPTURE(grows);
        if (is_circle || turn > 0 || grows) check_normals(surface, form, 6);
      }
}

// So many turns that the sections of both ends and their normals are the same.
TEST_CASE("normals: a turn between sections is seen") {
  KnownSurface surface = graph(line);
  SweepForm form = with_normals(thread, 0.3);
  form.turn = 20 * M_PI;
  surface.turn = [](double t) { return 20 * M_PI * t; };
  check_normals(surface, form);
}

// λ′ = 0 at both ends, and the circle turned: what is round has normals of its own beside the
// sides'.
TEST_CASE("normals: those of a round profile that grows and turns") {
  KnownSurface surface = graph(line);
  surface.is_round = true;
  SweepForm form = with_normals(circle_profile(Rational(1, 2), 1, Rational(1, 60)), 0.4);
  form.turn = 2 * M_PI;
  surface.turn = [](double t) { return 2 * M_PI * t; };
  form.scale = RationalFunction(Polynomial{1} + wave);
  surface.scale = [](double t) { return 1 + 16 * t * t * (1 - t) * (1 - t); };
  check_normals(surface, form, 6);
}

// Far from the line, where it turns about that, each side goes another way than its arc.
TEST_CASE("normals: those of a round profile that turns about a line far away") {
  KnownSurface surface = graph(line);
  surface.is_round = true;
  surface.center = {10, 0};
  std::vector<ProfilePoint> corners = regular_polygon(20, Rational(1, 10)).corners();
  for (auto& [x, y] : corners) x += 10;
  SweepForm form = with_normals(Profile(corners, Rational(1, 600), Rational(22, 140)), 0.5);
  form.turn = 0.15;
  surface.turn = [](double t) { return 0.15 * t; };
  check_normals(surface, form);
}

TEST_CASE("normals: a body that folds over itself has none") {
  CHECK_THROWS_AS(swept(around_a_circle(), with_normals(rectangle_profile(4, 1), 0.2)), Undecided);
  CHECK_NOTHROW(swept(around_a_circle(), with_normals(rectangle_profile(3, 1), 0.2)));
  CHECK_THROWS_AS(swept(around_a_circle(), with_normals(circle_profile(1, Rational(1, 10)), 0.2)),
                  DomainError);
}

}  // namespace sweep_section_test
