#include "phrame/algebra/piece_groups.hpp"

#include <algorithm>
#include <numeric>

namespace phrame::inline v0 {
namespace {

/// So many t are sorted together: as much as stays in a fast cache, and more where there are so
/// many pieces that groups would be of one.
std::size_t block_size(std::size_t pieces) {
  constexpr std::size_t least = 4096;
  constexpr std::size_t per_piece = 8;
  return std::max(least, per_piece * pieces);
}

/// Groups of the t of a block, which are from number `begin` on.
class Block {
 public:
  Block(const PiecewisePolynomial& polynomials, std::size_t size)
      : polynomials_(polynomials), at_(size) {}

  template <class Visit>
  void visit(std::span<const double> t, std::size_t begin, const Visit& visit) {
    if (std::is_sorted(t.begin(), t.end()))
      visit_runs(t, begin, visit);
    else
      visit_sorted(t, begin, visit);
  }

 private:
  template <class Visit>
  void visit_group(std::size_t piece, const double* t, std::size_t from, std::size_t to,
                   const Visit& visit) const {
    if (from < to)
      visit({polynomials_.pieces()[piece], {t + from, to - from}, {at_.data() + from, to - from}});
  }

  template <class Visit>
  void visit_runs(std::span<const double> t, std::size_t begin, const Visit& visit) {
    std::iota(at_.begin(), at_.begin() + static_cast<std::ptrdiff_t>(t.size()), begin);
    for (std::size_t from = 0, to = 0; from < t.size(); from = to) {
      const std::size_t piece = polynomials_.index_at(t[from]);
      const bool is_last = piece + 1 == polynomials_.pieces().size();
      const auto end = is_last ? t.end()
                               : std::lower_bound(t.begin() + static_cast<std::ptrdiff_t>(from),
                                                  t.end(), polynomials_.ends()[piece + 1]);
      to = static_cast<std::size_t>(end - t.begin());
      visit_group(piece, t.data(), from, to, visit);
    }
  }

  /// By counting how many lie in each piece.
  template <class Visit>
  void visit_sorted(std::span<const double> t, std::size_t begin, const Visit& visit) {
    piece_.resize(at_.size());
    sorted_.resize(at_.size());
    ends_.assign(polynomials_.pieces().size() + 1, 0);
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::size_t piece = polynomials_.index_at(t[k]);
      piece_[k] = static_cast<std::uint32_t>(piece);
      ++ends_[piece + 1];
    }
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::size_t place = ends_[piece_[k]]++;
      sorted_[place] = t[k];
      at_[place] = begin + k;
    }
    std::size_t from = 0;
    for (std::size_t piece = 0; from < t.size(); from = ends_[piece++])
      visit_group(piece, sorted_.data(), from, ends_[piece], visit);
  }

  const PiecewisePolynomial& polynomials_;
  std::vector<std::size_t> at_;
  std::vector<std::uint32_t> piece_;  ///< of each t
  std::vector<double> sorted_;        ///< the t
  std::vector<std::size_t> ends_;     ///< of the groups
};

}  // namespace

void for_each_group(const PiecewisePolynomial& polynomials, std::span<const double> t,
                    const std::function<void(const PieceGroup&)>& visit) {
  const std::size_t size = std::min(block_size(polynomials.pieces().size()), t.size());
  Block block(polynomials, size);
  for (std::size_t begin = 0; begin < t.size(); begin += size)
    block.visit(t.subspan(begin, std::min(size, t.size() - begin)), begin, visit);
}

}  // namespace phrame
