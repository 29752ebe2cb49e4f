#include "phrame/ph/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/length_share.hpp"

namespace phrame {
namespace {

// The surface is S(u, t) = r + a·v(u), a = λe^{iφ}, v = x f₂ + y f₃ of the constant length |v|. On
// a side of the polygon it is linear in u, so that between two sections, at the distance Δt, it is
// as near to the bilinear patch through its four corners as |S_tt|·Δt²/8 on the two edges u =
// const. With the unit tangent T and f₂′ = −(f₂·T′)T, the derivatives of v are
//   |v′| ≤ |v|·|T′|,  |v″| ≤ |v|·(|T″| + |T′|²),
// and those of T, from T′ = (r″ − (T·r″)T)/|r′|,
//   |T′| ≤ |r″|/|r′|,  |T″| ≤ (|r‴| + 3|T′||r″|)/|r′|;
// φ′ = Φ|r′|/S for a turn by Φ along the length S. All of this is bounded by balls around all t of
// a part. The two triangles of four corners are as near to the patch as the lines through its
// diagonals are to each other, where the diagonals cross in projection along their common normal:
// the patch and the triangles are graphs above the same quadrilateral then, between the two
// parallel planes of the diagonals. Otherwise a quarter of |P₀₀ − P₀₁ − P₁₀ + P₁₁| is a bound.

constexpr long bits = 64;
/// Bounds in doubles are of some ten operations on positive numbers.
constexpr double slack = 1 + 0x1p-40;
constexpr std::size_t most_points = 20'000'000;

double length_below(const Vector<RealBall>& v) {
  RealBall sum;
  for (const RealBall& x : v) {
    const RealBall size = absolute(x);
    sum = add(sum, multiply(size, size, bits), bits);
  }
  return -upper_double(subtract(RealBall(0, bits), sqrt_of_nonnegative(sum, bits), bits));
}

double length_above(const Vector<RealBall>& v) {
  RealBall sum;
  for (const RealBall& x : v) sum = add(sum, multiply(x, x, bits), bits);
  return upper_double(sqrt_of_nonnegative(sum, bits));
}

/// The derivatives of λ, for bounds.
struct Scale {
  std::array<RationalFunction, 3> derivatives;

  explicit Scale(const RationalFunction& scale)
      : derivatives{scale, differentiate(scale), differentiate(differentiate(scale))} {}
  double bound(std::size_t order, const RealBall& t) const {
    return upper_double(absolute(evaluate(derivatives[order], t, bits)));
  }
  double at(double t) const {
    return approximate(evaluate(derivatives[0], RealBall(exact_rational(t), bits), bits));
  }
};

/// A part of a segment.
struct Part {
  std::size_t segment;
  double from;
  double to;

  double start() const { return static_cast<double>(segment) + from; }
};

class Sections {
 public:
  Sections(const SweepPath& path, const SweepForm& form, double turn_per_length)
      : path_(path),
        scale_(form.scale),
        turn_per_length_(std::abs(turn_per_length)),
        reach_(form.profile.reach()) {}

  /// Parts on which r′ ≠ 0 and the edges are within `tolerance` of the surface. Throws Undecided.
  std::vector<Part> parts(double tolerance);
  /// Of the edges along them.
  double error() const { return error_; }

 private:
  /// No value where r′ may be 0.
  std::optional<double> edge_error(const Part& part) const;

  const SweepPath& path_;
  Scale scale_;
  double turn_per_length_;
  double reach_;
  double error_ = 0;
};

std::optional<double> Sections::edge_error(const Part& part) const {
  const RealBall t = hull(exact_rational(part.from), exact_rational(part.to), bits);
  const auto series = path_.series.position(part.segment, t, 4, bits);
  const auto derivative = [&](long order) {
    return Vector<RealBall>{series[0].coefficient(order), series[1].coefficient(order),
                            series[2].coefficient(order)};
  };
  const double r1_below = length_below(derivative(1));
  if (!(r1_below > 0)) return std::nullopt;
  const double r1 = length_above(derivative(1));
  const double r2 = 2 * length_above(derivative(2));
  const double r3 = 6 * length_above(derivative(3));
  const double t1 = r2 / r1_below;
  const double t2 = (r3 + 3 * t1 * r2) / r1_below;
  const RealBall along = add(t, RealBall(static_cast<long>(part.segment), bits), bits);
  const double scale0 = scale_.bound(0, along);
  const double scale1 = scale_.bound(1, along);
  const double scale2 = scale_.bound(2, along);
  const double phi1 = turn_per_length_ * r1;
  const double phi2 = turn_per_length_ * r2;
  const double a1 = scale1 + scale0 * phi1;
  const double a2 = scale2 + 2 * scale1 * phi1 + scale0 * (phi2 + phi1 * phi1);
  const double second = r2 + reach_ * (a2 + 2 * a1 * t1 + scale0 * (t2 + t1 * t1));
  const double step = part.to - part.from;
  return step * step / 8 * second * slack;
}

std::vector<Part> Sections::parts(double tolerance) {
  constexpr double shortest =
      0x1p-22;  // near a cusp parts are as short as the square of its distance
  std::vector<Part> found;
  std::vector<Part> left;
  for (std::size_t k = path_.series.segments; k-- > 0;) left.push_back({k, 0, 1});
  while (!left.empty()) {
    const Part part = left.back();
    left.pop_back();
    const auto error = edge_error(part);
    if (error && *error <= tolerance) {
      error_ = std::max(error_, *error);
      found.push_back(part);
      continue;
    }
    if (part.to - part.from < shortest || found.size() + left.size() > most_points)
      throw Undecided(fmt::format(
          "sweep: near t = {} the curve has a cusp, or the tolerance is too small", part.start()));
    const double middle = (part.from + part.to) / 2;
    left.push_back({part.segment, middle, part.to});
    left.push_back({part.segment, part.from, middle});
  }
  return found;
}

using Points = std::vector<Vector<double>>;

/// The corners of a section.
struct Section {
  double t;
  Points points;
  long folds;  ///< corners on the axis of curvature or beyond it
};

class Sweep {
 public:
  Sweep(const SweepPath& path, const SweepForm& form, const std::optional<LengthShare>& share)
      : path_(path), turn_(form.turn), share_(share), scale_(form.scale) {
    for (const auto& [x, y] : form.profile.corners())
      corners_.push_back({round_to_double(x), round_to_double(y)});
  }

  /// At t on the segment.
  Section section(std::size_t segment, double t) const;
  /// A bound for the triangles between two sections.
  double patch_error(const Section& a, const Section& b) const;
  /// Sections between which triangles are within `tolerance` of their patches; one for the end,
  /// too.
  std::vector<Section> sections(const std::vector<Part>& parts, double tolerance);
  double error() const { return error_; }  ///< of the triangles of sections()

 private:
  const SweepPath& path_;
  double turn_;                              ///< Φ
  const std::optional<LengthShare>& share_;  ///< where the profile turns
  Scale scale_;
  std::vector<std::array<double, 2>> corners_;
  double error_ = 0;
};

Section Sweep::section(std::size_t segment, double t) const {
  const auto series = path_.series.position(segment, RealBall(exact_rational(t), 128), 3, 128);
  const auto taylor = [&](long order) {
    return Vector<double>{approximate(series[0].coefficient(order)),
                          approximate(series[1].coefficient(order)),
                          approximate(series[2].coefficient(order))};
  };
  const Vector<double> center = taylor(0);
  const double square = dot(taylor(1), taylor(1));
  const double along = static_cast<double>(segment) + t;
  const Frame<double> frame = path_.frames(along);
  const double phi = share_ ? turn_ * (*share_)(segment, t) : 0;
  const double scale = scale_.at(along);
  const double cos = scale * std::cos(phi);
  const double sin = scale * std::sin(phi);
  Section section{along, {}, 0};
  section.points.reserve(corners_.size());
  for (const auto& [x, y] : corners_) {
    const Vector<double> out = (cos * x - sin * y) * frame.e2 + (sin * x + cos * y) * frame.e3;
    section.points.push_back(center + out);
    // Along T it moves by |r′| − v·T′, and v·T′ = v·r″/|r′|.
    if (2 * dot(out, taylor(2)) >= square) ++section.folds;
  }
  return section;
}

double size(const Vector<double>& v) { return std::hypot(v[0], v[1], v[2]); }

/// For the corners a, b of one section and c, d of the next, the diagonal being that from a to d.
double distance_to_patch(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c,
                         const Vector<double>& d) {
  const Vector<double> first = d - a;
  const Vector<double> second = c - b;
  const Vector<double> to_b = b - a;
  const double any_way = size(to_b - (d - c)) / 4;
  const Vector<double> normal = cross(first, second);
  const double length = size(normal);
  // Each diagonal has the ends of the other on both its sides, clearly.
  const auto side = [&](const Vector<double>& along, const Vector<double>& from_it) {
    return dot(cross(along, from_it), normal);
  };
  const double margin = 0x1p-30 * length * length;
  const bool is_convex = side(first, to_b) < -margin && side(first, c - a) > margin &&
                         side(second, a - b) > margin && side(second, d - b) < -margin;
  if (!is_convex) return any_way;
  return std::min(any_way, std::abs(dot(to_b, normal)) / length);
}

double Sweep::patch_error(const Section& a, const Section& b) const {
  double greatest = 0;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const std::size_t next = (k + 1) % corners_.size();
    greatest = std::max(
        greatest, distance_to_patch(a.points[k], a.points[next], b.points[k], b.points[next]));
  }
  return greatest * slack;
}

std::vector<Section> Sweep::sections(const std::vector<Part>& parts, double tolerance) {
  std::vector<Section> found{section(0, 0)};
  for (const Part& whole : parts) {
    std::vector<Part> left{whole};
    while (!left.empty()) {
      const Part part = left.back();
      Section next = section(part.segment, part.to);
      const double error = patch_error(found.back(), next);
      if (error > tolerance && part.to - part.from > 0x1p-40) {
        const double middle = (part.from + part.to) / 2;
        left.back() = {part.segment, middle, part.to};
        left.push_back({part.segment, part.from, middle});
        continue;
      }
      error_ = std::max(error_, error);
      left.pop_back();
      found.push_back(std::move(next));
      if (found.size() * corners_.size() > most_points)
        throw Undecided("sweep: more than 20000000 points are needed");
    }
  }
  return found;
}

std::vector<Section> equal_sections(const Sweep& sweep, const SweepPath& path, long count) {
  const auto segments = static_cast<long>(path.series.segments);
  const long least = path.is_closed ? 3 : 2;
  if (count < least)
    throw DomainError(fmt::format("sweep: {} sections of {} path bound no body, at least {} do",
                                  count, path.is_closed ? "a closed" : "an open", least));
  const long steps = path.is_closed ? count : count - 1;
  std::vector<Section> found;
  for (long k = 0; k <= steps; ++k) {
    const PathParameter at = locate_inside(path.series.segments, Rational(segments * k, steps));
    found.push_back(sweep.section(at.segment, round_to_double(at.t)));
  }
  return found;
}

/// 1 where the path goes along e₁, −1 where it goes against it.
int direction_of_motion(const SweepPath& path) {
  const auto series = path.series.position(0, RealBall(0, bits), 2, bits);
  const Vector<double> e1 = path.frames(0).e1;
  double product = 0;
  for (std::size_t k = 0; k < 3; ++k) product += approximate(series[k].coefficient(1)) * e1[k];
  return product < 0 ? -1 : 1;
}

/// The last section, of a closed path, is the first again.
Mesh mesh_of(const std::vector<Section>& sections, const Profile& profile, bool is_closed) {
  const auto corners = static_cast<std::uint32_t>(profile.corners().size());
  const auto rings = static_cast<std::uint32_t>(sections.size() - (is_closed ? 1 : 0));
  Mesh mesh;
  mesh.points.reserve(std::size_t{rings} * corners);
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    mesh.points.insert(mesh.points.end(), sections[ring].points.begin(),
                       sections[ring].points.end());
  for (std::uint32_t ring = 0; ring + (is_closed ? 0 : 1) < rings; ++ring) {
    const std::uint32_t here = ring * corners;
    const std::uint32_t there = (ring + 1) % rings * corners;
    for (std::uint32_t k = 0; k < corners; ++k) {
      const std::uint32_t next = (k + 1) % corners;
      mesh.triangles.push_back({here + k, here + next, there + next});
      mesh.triangles.push_back({here + k, there + next, there + k});
    }
  }
  if (is_closed) return mesh;
  const std::uint32_t last = (rings - 1) * corners;
  for (const auto& [i, j, k] : triangulated(profile)) {
    mesh.triangles.push_back({i, k, j});  // seen from behind
    mesh.triangles.push_back({last + i, last + j, last + k});
  }
  return mesh;
}

/// Of the sections of a mesh, the first ones.
long folds_of(const std::vector<Section>& sections, std::size_t count) {
  long folds = 0;
  for (std::size_t n = 0; n < count; ++n) folds += sections[n].folds;
  return folds;
}

/// Throws Error and DomainError.
void require_body(const Mesh& mesh) {
  if (!is_watertight(mesh)) throw Error("sweep: the check failed, the mesh is not watertight");
  if (const auto flat = first_flat_triangle(mesh))
    throw DomainError(fmt::format(
        "sweep: the triangle {} has no area in doubles: the profile is too small beside "
        "where it is, or the sections are too near to each other",
        *flat + 1));
}

/// The greatest coordinate.
double size_of(const Mesh& mesh) {
  double largest = 0;
  for (const Vector<double>& point : mesh.points)
    for (const double x : point) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace

double greatest_scale(const RationalFunction& scale, std::size_t segments) {
  const auto end = static_cast<long>(segments);
  const auto refuse = [] { throw DomainError("scale: it is not positive and finite all along"); };
  if (count_real_roots(scale.denominator(), closed(0, end)) > 0) refuse();
  if (scale.numerator().is_zero() || count_real_roots(scale.numerator(), closed(0, end)) > 0 ||
      scale(0) < 0)
    refuse();
  double greatest = 0;
  constexpr long parts = 256;
  for (long k = 0; k < end * parts; ++k) {
    const double bound =
        upper_double(evaluate(scale, hull(Rational(k, parts), Rational(k + 1, parts), bits), bits));
    greatest = std::max(greatest, bound);
  }
  return greatest;
}

SweptBody sweep(const SweepPath& path, const SweepForm& form) {
  const double scale = greatest_scale(form.scale, path.series.segments);
  // A turn that is only what rounding left of none is left out.
  const bool turns = std::abs(form.turn) > 0x1p-44;
  std::optional<LengthShare> share;
  if (turns) share.emplace(path.series);
  Sections sections(path, form, turns ? form.turn / share->length() * slack : 0);
  Sweep swept(path, form, share);
  SweptBody body;
  std::vector<Section> found;
  if (const auto* tolerance = std::get_if<Rational>(&form.tolerance_or_sections)) {
    const double all = round_to_double(*tolerance) / slack;
    const double of_profile = round_to_double(form.profile.error()) * scale * slack;
    if (!(of_profile <= all / 2))
      throw DomainError("sweep: the profile is not as near to its curve as the tolerance is small");
    const double left = all - of_profile;
    found = swept.sections(sections.parts(left * 0.6), left * 0.35);
    body.error = of_profile + sections.error() + swept.error();
  } else {
    sections.parts(HUGE_VAL);  // there is no cusp
    found = equal_sections(swept, path, std::get<long>(form.tolerance_or_sections));
  }
  body.mesh = mesh_of(found, form.profile, path.is_closed);
  if (direction_of_motion(path) < 0)
    for (auto& triangle : body.mesh.triangles) std::swap(triangle[1], triangle[2]);
  body.sections = found.size() - (path.is_closed ? 1 : 0);
  body.folds = folds_of(found, body.sections);
  require_body(body.mesh);
  // The frames are within 2^−53, the place within 2^−50 of the size, the turn within 2^−44.
  if (body.error) {
    const double reach = form.profile.reach() * scale;
    *body.error += 0x1p-42 * reach + 0x1p-48 * size_of(body.mesh);
    if (share) *body.error += std::abs(form.turn) * share->error() * reach;
  }
  return body;
}

}  // namespace phrame
