#pragma once
#include "phrame/answer/error_size.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/twist/frame_weight.hpp"
#include "phrame/ph/twist/wronskian_planes.hpp"

namespace phrame::inline v0 {

/// Asks for the pair of polynomials by which the Euler–Rodrigues frame of a curve is turned nearest
/// to a rotation-minimizing one [Peng, Pang, Pan 2023].
struct WronskianQuery {
  FrameWeight weight = FrameWeight::one;  ///< ρ
  long digits = 17;                       ///< of all numbers
};

/// The best pair, how it was found, and a pair over ℚ next to it.
struct WronskianAnswer {
  /// What is shown of a plane of pairs.
  struct Plane {
    WronskianPlane basis;                 ///< in normal form
    ErrorSize value;                      ///< the least J in it
    std::optional<long> critical_points;  ///< of J, where they could be told apart
    bool is_tied;                         ///< as good as the best one, by symmetry
  };
  /// How much each of two frames turns about the tangent, where a rotation-minimizing frame does
  /// not turn at all.
  struct Rates {
    ErrorSize here;   ///< the root mean square of Ω₁ times the length, of the pair over ℚ
    ErrorSize least;  ///< the same of `mtf --degree n --free-ends` with the same twist, 0
  };
  NamedPhPath path;            ///< as asked
  FrameWeight weight;          ///< ρ
  Polynomial wronskian;        ///< 2hσ
  WronskianPlanes planes;      ///< of (24)
  std::vector<Plane> real;     ///< those that are real
  std::size_t best;            ///< the index of the best pair's plane
  Decimal multiplier;          ///< λ of the best pair
  std::vector<Decimal> form;   ///< x₁, x₂, x₃ of the best pair
  std::vector<Decimal> a;      ///< its coefficients of t⁰, t¹, …
  std::vector<Decimal> b;      ///< likewise
  RationalPair pair;           ///< over ℚ, next to it
  long frame_degree;           ///< of f₂ and f₃, without what a and b have in common
  ErrorSize greatest_angle;    ///< |θ − θ_RMF| on [0, 1], of the pair over ℚ
  Decimal angle_at_end;        ///< θ − θ_RMF there
  std::optional<Rates> rates;  ///< where a turn per unit of length makes sense
  std::string why_no_rates;    ///< else why not
  long digits;                 ///< of all numbers
};

/// Throws DomainError for splines, for preimages of degrees other than 1 and 2, where h = 0, and
/// where there is no such weight; Undecided, naming what it is, where a number cannot be rounded or
/// two pairs are equally good.
PHRAME_API WronskianAnswer answer(const NamedPhPath& path, const WronskianQuery& query);

}  // namespace phrame
