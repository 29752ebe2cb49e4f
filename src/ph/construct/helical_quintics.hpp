#pragma once
#include <array>
#include <vector>

#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/quintic_family.hpp"

namespace phrame::inline v0 {

// Quintics r′ = f·A i A* whose tangent has a constant angle to an axis: exactly those where A stays
// in a real plane of ℍ, for x, y, z and σ are quadratic forms of its two coordinates there, of
// which there are only three. Here they are with rational parameters, so that the law is an
// identity whatever these are; what is left are the conditions on the end.

/// How the law is kept.
enum class HelicalForm {
  middle,  ///< A₁ = x·A₀ + y·A₂: parameters A₂, x, y
  end,     ///< A₂ = x·Q + y·A₁: parameters A₁, x, y. Without y: y = 0; without x: A₂ = 0
  free,    ///< A₀ = 0: parameters A₁, A₂. Without A₂: A₂ = 0
  monotone  ///< A is linear, f = (1, f₁, g²) > 0: parameters A₁, g, f₁. It turns in one sense only
};

/// A(0) = factor·Q. Neighbours on a straight line have their Q in common.
template <class T>
struct HelicalStart {
  Quaternion<T> q;
  T factor;
};

/// The Bernstein coefficients of A, two or three, and of f; √f(1)·A(1).
template <class T>
struct HelicalMember {
  std::vector<Quaternion<T>> a;
  std::vector<T> f;
  Quaternion<T> end;
};

/// The member with these parameters.
template <class T>
HelicalMember<T> helical_member(HelicalForm form, const HelicalStart<T>& start,
                                const std::vector<T>& parameters) {
  const Quaternion<T> a0 = start.factor * start.q;
  const auto& x = parameters;
  const auto quaternion = [&](std::size_t k) -> Quaternion<T> {
    return {x[k], x[k + 1], x[k + 2], x[k + 3]};
  };
  const Quaternion<T> first = quaternion(0);
  Quaternion<T> a1 = first;
  Quaternion<T> a2{T(0), T(0), T(0), T(0)};
  switch (form) {
    case HelicalForm::middle:
      a2 = first;
      a1 = x[4] * a0 + x[5] * a2;
      break;
    case HelicalForm::end:
      if (x.size() > 4) a2 = x[4] * start.q;
      if (x.size() > 5) a2 = a2 + x[5] * a1;
      break;
    case HelicalForm::free:
      if (x.size() > 4) a2 = quaternion(4);
      break;
    case HelicalForm::monotone:
      return {{a0, a1}, {T(1), x[5], T(x[4] * x[4])}, x[4] * a1};
  }
  return {{a0, a1, a2}, {T(1)}, a2};
}

/// r(1) − r(0).
template <class T>
Vector<T> step_of(const HelicalMember<T>& member) {
  const auto& a = member.a;
  if (a.size() == 3) {
    return T(T(1) / T(120)) * integral_times_120(a[0], a[1], a[2]);
  }
  const T& f1 = member.f[1];
  const T& f2 = member.f[2];
  return T(T(1) / T(30)) * (T(T(6) + T(3) * f1 + f2) * rotated_i(a[0]) +
                            T(T(3) + T(4) * f1 + T(3) * f2) * symmetric_product(a[0], a[1]) +
                            T(T(1) + T(3) * f1 + T(6) * f2) * rotated_i(a[1]));
}

/// What it lacks: r(1) − r(0) and r′(1), without those wanted.
template <class T>
std::vector<T> helical_defect(const HelicalMember<T>& member, const Vector<T>& step,
                              const Vector<T>& d1) {
  const Vector<T> off = step_of(member) - step;
  const Vector<T> off_end = rotated_i(member.end) - d1;
  return {off[0], off[1], off[2], off_end[0], off_end[1], off_end[2]};
}

/// The derivative of the defect by parameter k.
std::vector<double> helical_derivative(HelicalForm form, const HelicalStart<double>& start,
                                       const std::vector<double>& parameters, std::size_t k);

/// A member in doubles, near one that meets its data.
struct HelicalGuess {
  HelicalForm form;
  std::vector<double> parameters;
  double energy;  ///< ∫κ² ds
};

/// How the directions of the data are to each other, known exactly.
enum class DirectionsOfEnds {
  general,
  parallel,           ///< the same; or there is one only, the other derivative being 0
  opposite_collinear  ///< opposite, and so is the step
};

/// At most so many are found: four with f = 1, and up to four of the form monotone.
inline constexpr long helical_solutions = 8;

/// All that start with A(0): first those with f = 1, by energy, then those of the form monotone
/// with f > 0, by energy. With f = 1 there are four where the ends are neither parallel nor
/// opposite and collinear; where they are, there are infinitely many, and these are the four with Δ
/// and φ of 0 or a half turn, or fewer if such are equal. (One list by energy would begin with
/// great loops.)
std::vector<HelicalGuess> helical_quintics(const HermiteData<double>& data,
                                           const HelicalStart<double>& start,
                                           DirectionsOfEnds ends);

}  // namespace phrame
