#include "phrame/algebra/modular_lift.hpp"

namespace phrame::inline v0 {
namespace {

/// FLINT's trees for many primes: one precomputation, then any number of reductions and lifts.
class Comb {
 public:
  explicit Comb(const std::vector<ulong>& primes) {
    fmpz_comb_init(comb_, primes.data(), static_cast<slong>(primes.size()));
    fmpz_comb_temp_init(space_, comb_);
  }
  ~Comb() {
    fmpz_comb_temp_clear(space_);
    fmpz_comb_clear(comb_);
  }
  Comb(const Comb&) = delete;
  Comb& operator=(const Comb&) = delete;

  void reduce(ulong* residues, const fmpz* a) { fmpz_multi_mod_ui(residues, a, comb_, space_); }
  void lift(fmpz* a, const ulong* residues) { fmpz_multi_CRT_ui(a, residues, comb_, space_, 1); }

 private:
  fmpz_comb_t comb_;
  fmpz_comb_temp_t space_;
};

/// One row of residues for each coefficient.
class Table {
 public:
  Table(slong rows, std::size_t columns)
      : columns_(columns), words_(static_cast<std::size_t>(rows) * columns) {}
  ulong* row(slong k) { return words_.data() + static_cast<std::size_t>(k) * columns_; }

 private:
  std::size_t columns_;
  std::vector<ulong> words_;
};

/// The residues of f for all primes; a tree pays only where coefficients are long.
class Reduced {
 public:
  Reduced(const flint::FmpzPoly& f, std::size_t primes, Comb& comb)
      : f_(f), long_(fmpz_poly_max_limbs(f.get()) > 8), table_(long_ ? size() : 0, primes) {
    for (slong k = 0; long_ && k < size(); ++k)
      comb.reduce(table_.row(k), fmpz_poly_get_coeff_ptr(f.get(), k));
  }

  ModularPolynomial modulo(ulong prime, std::size_t index) {
    if (!long_) return {prime, f_};
    ModularPolynomial result(prime);
    nmod_poly_fit_length(result.raw(), size());
    for (slong k = 0; k < size(); ++k) result.raw()->coeffs[k] = table_.row(k)[index];
    result.raw()->length = size();
    _nmod_poly_normalise(result.raw());
    return result;
  }

 private:
  slong size() const { return fmpz_poly_length(f_.get()); }

  const flint::FmpzPoly& f_;
  bool long_;
  Table table_;
};

}  // namespace

flint::FmpzPoly modular_lift(const std::vector<flint::FmpzPoly>& inputs, long length, long bits,
                             const ModularImage& image) {
  Primes source;
  std::vector<ulong> primes(static_cast<std::size_t>((bits + 1) / 61 + 1));  // ∏ p > 2·2^bits
  for (ulong& p : primes) p = source.next();
  flint::FmpzPoly result;
  // A prime that tells nothing is replaced, and all is done again: that is never seen in practice.
  for (std::size_t done = 0; done < primes.size();) {
    Comb comb(primes);
    Table residues(length, primes.size());
    std::vector<Reduced> reduced;
    reduced.reserve(inputs.size());
    for (const auto& f : inputs) reduced.emplace_back(f, primes.size(), comb);
    for (done = 0; done < primes.size(); ++done) {
      std::vector<ModularPolynomial> arguments;
      for (auto& f : reduced) arguments.push_back(f.modulo(primes[done], done));
      const auto value = image(arguments);
      if (!value) break;
      for (slong k = 0; k <= value->degree(); ++k) residues.row(k)[done] = value->coefficient(k);
    }
    if (done < primes.size()) {
      primes[done] = source.next();
      continue;
    }
    fmpz_poly_fit_length(result.get(), length);
    for (slong k = 0; k < length; ++k) comb.lift(result.get()->coeffs + k, residues.row(k));
    _fmpz_poly_set_length(result.get(), length);
    _fmpz_poly_normalise(result.get());
  }
  return result;
}

}  // namespace phrame
