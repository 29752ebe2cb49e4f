#include "parameters.hpp"

#include <nanobind/ndarray.h>

#include <cmath>

namespace phrame::inline v0::python {

Parameters parameters(std::vector<Rational> fractions) {
  Parameters found;
  found.fractions = std::move(fractions);
  for (const Rational& t : found.fractions) {
    const double near = round_to_double(t);
    if (!std::isfinite(near) || exact_rational(near) != t) {
      found.doubles.clear();
      return found;
    }
    found.doubles.push_back(near);
  }
  return found;
}

Parameters parameters(nb::handle ts, const std::string& place) {
  Parameters found;
  using Doubles = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
  Doubles array;
  const nb::object& numpy_array = imported("numpy", "ndarray");
  // What most are, as it is; what is derived from an array may have a mask.
  const bool is_plain = ts.type().is(numpy_array) && nb::try_cast(ts, array, false);
  const nb::object list = is_plain ? nb::borrow(ts) : listed(ts, place, "a list of numbers");
  if (!is_plain && list.type().is(numpy_array)) {
    if (nb::cast<long>(list.attr("ndim")) != 1)
      refuse(place,
             "an array of one dimension is wanted, its shape is " +
                 nb::cast<std::string>(nb::str(nb::object(list.attr("shape")))),
             ts);
    const std::string kind = nb::cast<std::string>(list.attr("dtype").attr("kind"));
    if (kind == "f" && nb::cast<long>(list.attr("dtype").attr("itemsize")) <= 8)
      array = nb::cast<Doubles>(
          list.attr("astype")("float64", nb::arg("order") = "C", nb::arg("copy") = false));
  }
  if (array.is_valid())
    found.doubles.assign(array.data(), array.data() + array.shape(0));
  else
    found = parameters(rationals(list, place));
  if (found.size() == 0) refuse(place, "it is empty", ts);
  for (std::size_t k = 0; k < found.doubles.size(); ++k)
    if (!std::isfinite(found.doubles[k]))
      refuse(place + "[" + std::to_string(k) + "]", "not a finite number", ts);
  return found;
}

nb::object array(const std::shared_ptr<DoubleArray>& numbers,
                 const std::vector<std::size_t>& shape) {
  using Owner = std::shared_ptr<DoubleArray>;
  const nb::capsule owner(new Owner(numbers),
                          [](void* p) noexcept { delete static_cast<Owner*>(p); });
  return nb::cast(
      nb::ndarray<nb::numpy, double>(numbers->data(), shape.size(), shape.data(), owner));
}

double finite(double x) {
  if (!std::isfinite(x)) throw InputError("the result is too large for a double");
  return x;
}

}  // namespace phrame::python
