#pragma once
#include "phrame/ph/offset/boundary.hpp"
#include "phrame/ph/offset/envelope.hpp"

namespace phrame::inline v0 {

/// What is left of an envelope.
struct DomainBoundary {
  Envelope envelope;
  std::vector<TrimmedBranch> branches;      ///< loops, with the domain on their left
  std::vector<UndecidedStretch> undecided;  ///< mostly none
};
/// The boundary of the domain: all points of the envelope that are inside of no disc. It is cut as
/// trimmed_offset() cuts; between these one rational point tells for all. Throws
/// DomainError where an axis turns back at a cusp, and Undecided as trimmed_offset().
PHRAME_API DomainBoundary domain_boundary(MedialAxis axis);
/// The branch as trimmed offsets have it, moved by less than 10^−digits of the greatest radius.
PHRAME_API std::vector<Path> paths(const DomainBoundary& boundary, const TrimmedBranch& branch,
                                   long digits);

}  // namespace phrame
