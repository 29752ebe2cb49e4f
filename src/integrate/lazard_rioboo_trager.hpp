#pragma once
#include "phrame/integrate/partial_fractions.hpp"

namespace phrame::inline v0 {

/// ∫ f = Σ_k Σ_{Q_k(α)=0} α log v_k(α, t), where ∏ Q_kᵏ is the squarefree factorization of the
/// residue polynomial and v_k(α, t) a constant times ∏ (t − z) over the k poles z with the residue
/// α: the k-th subresultant of (n − x d′, d) up to a constant [Lazard, Rioboo 1990; Trager], short
/// as short_argument() is. One sum for each k that occurs. Nothing is factored, and there is no gcd
/// over an extension. The result is proved by whoever checks its derivative, as integrate() does.
/// Throws DomainError where f is not proper or has a multiple pole.
std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f);
/// The same, with the residue polynomial known.
std::vector<LogSum> lazard_rioboo_trager(const RationalFunction& f,
                                         const Polynomial& residue_polynomial);

}  // namespace phrame
