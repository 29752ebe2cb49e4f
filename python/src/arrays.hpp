#pragma once
#include <algorithm>
#include <array>

#include "jobs.hpp"
#include "parameters.hpp"

namespace phrame::inline v0::python {

/// How many numbers an array of this shape has.
inline std::size_t product(const std::vector<std::size_t>& shape) {
  std::size_t n = 1;
  for (const std::size_t k : shape) n *= k;
  return n;
}

/// A row each of e₁, f₂, f₃.
inline void write_rows(const Frame<double>& f, double* out) {
  for (const auto* v : {&f.e1, &f.e2, &f.e3}) out = std::copy(v->begin(), v->end(), out);
}

/// A matrix with the columns e₁, f₂, f₃, r; (0, 0, 0, 1) below.
inline void write_pose(const Frame<double>& f, const Vector<double>& r, double* out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array row{f.e1[i], f.e2[i], f.e3[i], r[i]};
    out = std::copy(row.begin(), row.end(), out);
  }
  const std::array<double, 4> last{0, 0, 0, 1};
  std::copy(last.begin(), last.end(), out);
}

/// Of quaternions (x, y, z, w), known up to their sign, in their order along a path: each the one
/// that has a scalar product > 0 with that before it; of the first, the last number that is not 0
/// is > 0.
void make_continuous(DoubleArray& quaternions);

/// A roll of a path of so many segments: None, an angle, text as of the program, or a list of
/// angles at the joints.
Roll roll_of(nb::handle roll, std::size_t segments);

/// Refuses a t outside [0, end]; a double that is the end rounded is not.
void require_inside(const Parameters& at, const Rational& end);

constexpr std::size_t many = 1024;  ///< approximated frames that a thread takes at a time

using Numbers = std::shared_ptr<DoubleArray>;

/// The numbers, filled by work(from, to) once the source is prepared: at once where that is done
/// before another thread would begin.
template <class Source, class Work>
Numbers filled(const Numbers& numbers, nb::handle progress, const std::shared_ptr<Source>& source,
               const std::shared_ptr<Parameters>& at, std::size_t grain, const Work& work) {
  constexpr std::size_t few = 256;
  if (at->size() <= few && progress.is_none() && source->is_prepared(*at))
    work(0, at->size());
  else
    run({.n = at->size(),
         .grain = grain,
         .prepare = [source, at] { source->prepare(*at); },
         .work = work},
        progress);
  return numbers;
}

#define PHRAME_ARRAY "numpy.typing.NDArray[numpy.float64]"
/// The signature of a function of one t, or of many.
#define PHRAME_NUMBER_OR_ARRAY(name)                                           \
  "@typing.overload\ndef " name                                                \
  "(self, t: float | fractions.Fraction | decimal.Decimal, by: str = 't') -> " \
  "fractions.Fraction | Real: ...\n@typing.overload\ndef " name                \
  "(self, t: Numbers, by: str = 't') -> numpy.typing.NDArray[numpy.float64]"
#define PHRAME_ROLL "roll: Number | Numbers | None = None"
#define PHRAME_PROGRESS "progress: collections.abc.Callable[[int, int], object] | None = None"

}  // namespace phrame::python
