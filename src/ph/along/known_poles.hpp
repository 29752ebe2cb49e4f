#pragma once
#include "phrame/algebra/recent.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/total_rates.hpp"

namespace phrame::inline v0 {

/// The poles of the PH segments of a path, for several totals of it.
class KnownPoles {
 public:
  std::shared_ptr<const TotalPoles> of(std::size_t k, const Curve& curve) {
    return poles_.get(k, [&] { return total_poles(curve); });
  }

 private:
  Recent<TotalPoles> poles_{most_kept_integrals};
};

/// @{ As those without.
PathTotal total_torsion(const Path& path, KnownPoles& poles);
std::variant<PathTotal, Infinite> bending_energy(const Path& path, KnownPoles& poles);
std::variant<PathTotal, Infinite> frenet_energy(const Path& path, KnownPoles& poles);
PathTotal erf_twist(const PhPath& path, KnownPoles& poles);
/// @}

}  // namespace phrame
