#include "phrame/ph/sweep/rational_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/sweep_scale.hpp"

namespace phrame::inline v0 {
namespace {

/// A part of a path with its frame, in s ∈ [0, 1].
struct SweptPart {
  Rational from;  ///< of the path's parameter
  Rational to;
  Vector<Polynomial> position;    ///< X
  Polynomial weight;              ///< W > 0, r = X/W
  QuaternionPolynomial preimage;  ///< B
  Polynomial scale;               ///< P
  Polynomial scale_below;         ///< Q
};

/// A PH curve or another rational one.
const RationalCurve& swept_curve(const Path& path, std::size_t segment) {
  const RationalCurve* curve = rational_curve(path.segments()[segment]);
  if (curve == nullptr)
    throw DomainError(
        fmt::format("sweep: segment {} is of formulas, no rational curve", segment + 1));
  return *curve;
}

SweptPart part_of(const Path& path, const RationalFramePiece& frame,
                  const RationalFunction& scale) {
  const Rational joint(static_cast<long>(frame.segment));
  const Rational width = frame.to - frame.from;
  const RationalCurve& curve = swept_curve(path, frame.segment);
  SweptPart part{joint + frame.from,
                 joint + frame.to,
                 curve.numerator(),
                 curve.weight(),
                 frame.preimage,
                 {},
                 {}};
  for (Polynomial& x : part.position) x = compose(x, {frame.from, width});
  part.weight = compose(part.weight, {frame.from, width});
  part.scale = compose(scale.numerator(), {part.from, width});
  part.scale_below = compose(scale.denominator(), {part.from, width});
  return part;
}

/// The first or second half.
SweptPart half_of(const SweptPart& part, bool is_second) {
  const Rational middle = (part.from + part.to) / 2;
  const Polynomial s{is_second ? Rational(1, 2) : Rational(0), Rational(1, 2)};
  const auto halved = [&](const Polynomial& p) { return compose(p, s); };
  SweptPart half{is_second ? middle : part.from, is_second ? part.to : middle, {}, {}, {}, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) half.position[k] = halved(part.position[k]);
  half.weight = halved(part.weight);
  const auto& [u, v, p, q] = part.preimage;
  half.preimage = {halved(u), halved(v), halved(p), halved(q)};
  half.scale = halved(part.scale);
  half.scale_below = halved(part.scale_below);
  return half;
}

/// S = (center·V + x·X + y·Y)/(weight·V), by Bernstein coefficients in s of one degree.
struct StripForm {
  std::vector<Vector<Rational>> center;
  std::vector<Vector<Rational>> x;
  std::vector<Vector<Rational>> y;
  std::vector<Rational> weight;  ///< > 0, the first is 1
};

std::vector<Vector<Rational>> bernstein_vectors(const Vector<Polynomial>& v, long degree) {
  std::vector<Vector<Rational>> coefficients(static_cast<std::size_t>(degree) + 1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto of_axis = to_bernstein(v[axis], degree);
    for (std::size_t k = 0; k < of_axis.size(); ++k) coefficients[k][axis] = of_axis[k];
  }
  return coefficients;
}

long degree_of(const Vector<Polynomial>& v) {
  return std::max({v[0].degree(), v[1].degree(), v[2].degree()});
}

/// No value where a weight is not > 0.
std::optional<StripForm> strip_form(const SweptPart& part) {
  const Polynomial of_frame = norm(part.preimage) * part.scale_below;
  const Polynomial of_profile = part.scale * part.weight;
  Polynomial weight = of_frame * part.weight;
  Vector<Polynomial> center = of_frame * part.position;
  Vector<Polynomial> x = of_profile * rotated_j(part.preimage);
  Vector<Polynomial> y = of_profile * rotated_k(part.preimage);
  Polynomial common = weight;
  for (std::size_t k = 0; k < 3; ++k) common = gcd(common, gcd(x[k], y[k]));
  if (!part.weight.is_constant())  // else what divides the weight divides center
    for (const Polynomial& c : center) common = gcd(common, c);
  const Rational unit = 1 / weight(0);
  const auto reduce = [&](Polynomial& p) { p = unit * common(0) * exact_quotient(p, common); };
  reduce(weight);
  for (std::size_t k = 0; k < 3; ++k) {
    reduce(x[k]);
    reduce(y[k]);
    reduce(center[k]);
  }
  const long degree =
      std::max({1L, weight.degree(), degree_of(center), degree_of(x), degree_of(y)});
  StripForm form{bernstein_vectors(center, degree), bernstein_vectors(x, degree),
                 bernstein_vectors(y, degree), to_bernstein(weight, degree)};
  if (std::any_of(form.weight.begin(), form.weight.end(), [](const Rational& w) { return w <= 0; }))
    return std::nullopt;
  return form;
}

SurfacePatch patch_of(const SweptPart& part, const StripForm& strip, const PlaneBezier& profile,
                      std::size_t side) {
  SurfacePatch patch{part.from, part.to, side, {}, {}};
  for (std::size_t k = 0; k < strip.weight.size(); ++k) {
    std::vector<Vector<Rational>> points;
    std::vector<Rational> weights;
    for (std::size_t l = 0; l < profile.points.size(); ++l) {
      const auto& [x, y] = profile.points[l];
      points.push_back(Rational(1 / strip.weight[k]) *
                       (strip.center[k] + x * strip.x[k] + y * strip.y[k]));
      weights.push_back(strip.weight[k] * profile.weights[l]);
    }
    patch.points.push_back(std::move(points));
    patch.weights.push_back(std::move(weights));
  }
  return patch;
}

// ---- what is checked, of the control points alone

[[noreturn]] void fail_check(const char* what) {
  throw Error(std::string("rational_sweep: the check failed, ") + what);
}

/// A patch as a polynomial in s for each Bernstein polynomial in u.
struct PatchColumns {
  std::vector<Vector<Polynomial>> out;  ///< ω·(S − r)
  std::vector<Polynomial> weight;       ///< ω, the weight of the patch times that of the curve
};

PatchColumns columns_of(const SurfacePatch& patch, const SweptPart& part) {
  PatchColumns columns;
  for (std::size_t l = 0; l < patch.points.front().size(); ++l) {
    std::vector<Rational> weights;
    std::array<std::vector<Rational>, 3> products;
    for (std::size_t k = 0; k < patch.points.size(); ++k) {
      weights.push_back(patch.weights[k][l]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        products[axis].push_back(patch.weights[k][l] * patch.points[k][l][axis]);
    }
    const Polynomial weight = from_bernstein(weights);
    const Vector<Polynomial> points{from_bernstein(products[0]), from_bernstein(products[1]),
                                    from_bernstein(products[2])};
    columns.out.push_back(part.weight * points - weight * part.position);
    columns.weight.push_back(part.weight * weight);
  }
  return columns;
}

/// Σ over Bernstein polynomials in u, as coefficients of u⁰, u¹, …
std::vector<Vector<Polynomial>> in_powers_of_u(const std::vector<Vector<Polynomial>>& bernstein) {
  std::vector<Vector<Polynomial>> powers(bernstein.size());
  for (std::size_t l = 0; l < bernstein.size(); ++l) {
    std::vector<Rational> unit(bernstein.size());
    unit[l] = 1;
    const Polynomial basis = from_bernstein(unit);
    for (std::size_t k = 0; k < powers.size(); ++k)
      powers[k] = powers[k] + Polynomial{basis.coefficient(static_cast<long>(k))} * bernstein[l];
  }
  return powers;
}

/// |S − r|² = λ²(x² + y²): with the weight ω(s)V(u)/V₀, |ωV/V₀·(S − r)|²·V₀²Q² = ω²P²(x² + y²)V².
bool has_the_distance(const PatchColumns& columns, const SweptPart& part,
                      const PlaneBezier& profile) {
  const auto [x, y, weight] = polynomials(profile);
  const Polynomial square = x * x + y * y;
  const Polynomial below = profile.weights.front() * part.scale_below;
  const Polynomial above = columns.weight.front() * part.scale;
  const auto out = in_powers_of_u(columns.out);
  for (std::size_t m = 0; m + 1 < 2 * out.size(); ++m) {
    Polynomial sum;
    for (std::size_t k = m < out.size() ? 0 : m + 1 - out.size(); k <= m && k < out.size(); ++k)
      sum += dot(out[k], out[m - k]);
    if (!(below * below * sum == square.coefficient(static_cast<long>(m)) * (above * above)))
      return false;
  }
  return true;
}

void require_swept(const SurfacePatch& patch, const SweptPart& part, const PlaneBezier& profile,
                   bool is_rotation_minimizing) {
  const PatchColumns columns = columns_of(patch, part);
  Vector<Polynomial> rate;  // W²·r′
  for (std::size_t k = 0; k < 3; ++k)
    rate[k] = differentiate(part.position[k]) * part.weight -
              part.position[k] * differentiate(part.weight);
  for (std::size_t l = 0; l < columns.out.size(); ++l) {
    const Vector<Polynomial>& out = columns.out[l];
    const Polynomial& weight = columns.weight[l];
    if (!(profile.weights.front() * weight == profile.weights[l] * columns.weight.front()))
      fail_check("the weights are not those of the profile");
    if (!dot(out, rate).is_zero()) fail_check("the surface is not normal to the curve");
    if (!is_rotation_minimizing) continue;
    const Polynomial below = weight * part.scale;
    Vector<Polynomial> turn;
    for (std::size_t k = 0; k < 3; ++k) {
      const Polynomial above = out[k] * part.scale_below;
      turn[k] = differentiate(above) * below - above * differentiate(below);
    }
    if (!(cross(turn, rate) == Vector<Polynomial>{}))
      fail_check("the frame is not rotation-minimizing");
  }
  if (!has_the_distance(columns, part, profile))
    fail_check("the surface has not the distance of the profile from the curve");
}

/// Points at the end of the one are those at the start of the other.
void require_joint(const SurfacePatch& before, const SurfacePatch& after) {
  if (before.points.back() != after.points.front()) fail_check("patches do not meet");
}

/// The last column of each patch is the first one of the next around its ring.
void require_sides(const RationalSurface& surface) {
  std::vector<std::size_t> next(surface.sides);
  for (std::size_t k = 0; k < next.size(); ++k) next[k] = k + 1;
  for (std::size_t k = 0; k < surface.rings.size(); ++k)
    next[(k + 1 < surface.rings.size() ? surface.rings[k + 1] : surface.sides) - 1] =
        surface.rings[k];
  for (std::size_t n = 0; n < surface.patches.size(); ++n) {
    const std::size_t side = n % surface.sides;
    const SurfacePatch& after = surface.patches[n - side + next[side]];
    for (std::size_t k = 0; k < after.points.size(); ++k)
      if (surface.patches[n].points[k].back() != after.points[k].front())
        fail_check("sides do not meet");
  }
}

void require_joined(const RationalSurface& surface) {
  require_sides(surface);
  const auto& patches = surface.patches;
  for (std::size_t n = surface.sides; n < patches.size(); ++n)
    require_joint(patches[n - surface.sides], patches[n]);
  for (std::size_t n = 0; surface.is_closed && n < surface.sides; ++n)
    require_joint(patches[patches.size() - surface.sides + n], patches[n]);
}

/// Where r′ = 0 a body has no section.
void require_no_stop(const Path& path) {
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    if (count_real_roots(swept_curve(path, k).multiplier(), closed_interval(0, 1)) > 0)
      throw DomainError(
          path.segments().size() == 1
              ? "sweep: the curve has a cusp or stops on the way"
              : fmt::format("sweep: segment {} has a cusp or stops on the way", k + 1));
}

void append_part(RationalSurface& surface, const SweptPart& part,
                 const std::vector<PlaneBezier>& pieces, bool is_rotation_minimizing) {
  const auto strip = strip_form(part);
  if (!strip) {
    append_part(surface, half_of(part, false), pieces, is_rotation_minimizing);
    append_part(surface, half_of(part, true), pieces, is_rotation_minimizing);
    return;
  }
  for (std::size_t side = 0; side < pieces.size(); ++side) {
    surface.patches.push_back(patch_of(part, *strip, pieces[side], side));
    require_swept(surface.patches.back(), part, pieces[side], is_rotation_minimizing);
  }
}

}  // namespace

RationalSurface rational_sweep(const Path& path, const std::vector<RationalFramePiece>& frames,
                               const RationalSweepForm& form) {
  SweepScale(form.scale).require_along(path.segments().size());
  require_no_stop(path);
  // Where e₁ is against the motion the profile is swept the other way round.
  const bool is_against = orientation(path.segments().front()) < 0;
  const auto pieces = is_against ? reversed_pieces(form.profile) : form.profile.pieces();
  RationalSurface surface;
  surface.sides = pieces.size();
  surface.rings = form.profile.rings();
  surface.is_closed =
      path.is_closed() && is_closed(frames) && form.scale(0) == form.scale(path.end());
  for (const RationalFramePiece& frame : frames)
    append_part(surface, part_of(path, frame, form.scale), pieces, form.is_rotation_minimizing);
  require_joined(surface);
  return surface;
}

}  // namespace phrame
