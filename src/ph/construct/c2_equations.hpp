#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/construct/refine.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// The equations of C² splines in doubles. A is piecewise quadratic in the parameter and C¹, so that
// r′ = A i A* is C¹ and r is C², whatever the coefficients Z of A in the B-spline basis are: the
// middle Bernstein coefficient of a segment is one of them, that of a joint between the steps h and
// h⁺ is (h⁺Z + hZ⁺)/(h + h⁺). Of an open spline of N segments there are N + 2, beyond the ends with
// the first and the last step once more; of a closed one there are N, and A comes back as A or −A.

/// What is wanted; steps and chords are to be of about the size 1.
struct C2Data {
  std::vector<double> steps;                ///< of the parameter
  std::vector<Vector<double>> chords;       ///< from each point to the next
  std::vector<Vector<double>> derivatives;  ///< at the points, about; at the ends of an open spline
                                            ///< they are wanted
  bool is_closed = false;
  bool is_plane = false;  ///< are A = u + qk and the curve in the plane z = 0 wanted?
};

/// A guess.
struct C2Coefficients {
  std::vector<Quaternion<double>> z;
  double closing_sign = 1;  ///< A(end) = ±A(start) of a closed spline
};

/// The Z that Newton's method finds from preimages of the derivatives or, where it finds none, of
/// calmer ones, and at last the best that it finds from Z scattered at random, the same each time.
/// There are 4(N + 2) unknowns and 3N + 6 equations, 4N and 3N of a closed spline: of all solutions
/// it is one with small changes of A′. In the plane there are as many equations as unknowns, and
/// 2^{N+1} solutions; the start says which. No value where the method does not converge.
std::optional<C2Coefficients> c2_coefficients(const C2Data& data);

/// The change of Z, with the least change of A″, that changes by as much as is wanted, to first
/// order, the chords and, times the first and the last step, the derivatives at the ends of an open
/// spline. All are in a list, without z in the plane; so are the parts u, v, p, q of Z, u and q in
/// the plane.
ParameterStep c2_step(const C2Data& data, const C2Coefficients& at);

}  // namespace phrame
