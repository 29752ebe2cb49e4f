#pragma once
#include <memory>
#include <new>
#include <vector>

#include "numbers.hpp"

namespace phrame::inline v0::python {

/// Parameters: doubles where all of them are, else fractions.
struct Parameters {
  std::vector<double> doubles;
  std::vector<Rational> fractions;

  std::size_t size() const { return doubles.empty() ? fractions.size() : doubles.size(); }
  bool are_doubles() const { return !doubles.empty(); }
  Rational operator[](std::size_t k) const {
    return are_doubles() ? exact_rational(doubles[k]) : fractions[k];
  }
};

/// Of fractions: doubles where all of them are.
Parameters parameters(std::vector<Rational> fractions);
/// Of an array of doubles, of one of another kind, or of a list of numbers.
/// Refuses what is empty or not finite, named as `place`.
Parameters parameters(nb::handle ts, const std::string& place);

/// Numbers that are not set to 0 before they are written: the threads that write them touch their
/// memory first, which for large arrays takes as long as the writing.
template <class T>
struct Untouched : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = Untouched<U>;
  };
  template <class U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
};
using DoubleArray = std::vector<double, Untouched<double>>;

/// An array of these dimensions, which shares the numbers.
nb::object array(const std::shared_ptr<DoubleArray>& numbers,
                 const std::vector<std::size_t>& shape);

/// A number that no double can hold is no answer.
double finite(double x);
inline Vector<double> finite(Vector<double> r) {
  for (double& x : r) x = finite(x);
  return r;
}

/// @{ Below so many, to approximate first takes longer: of angles, of those of each segment of a
/// spline, whose coefficients are longer, and of frames of PH curves, of which one takes 10 to 100
/// µs by balls, 2 to 10 µs by pairs of doubles, and the polynomials 5 ms or more.
constexpr std::size_t least_compiled = 16;
constexpr std::size_t least_of_segment = 64;
constexpr std::size_t least_of_ball_frames = 256;
constexpr std::size_t least_of_near_frames = 4096;
/// @}

}  // namespace phrame::python
