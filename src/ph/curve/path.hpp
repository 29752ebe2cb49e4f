#pragma once
#include <memory>
#include <string>

#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/curve/segment.hpp"

namespace phrame::inline v0 {

/// A curve of any kind, or several joined to one. Segment k = 0, 1, … is the part [k, k + 1] of the
/// parameter t. At the joints the position is continuous, exactly, and the unit tangent r′/|r′|,
/// too, or there is a corner, through which frames are carried as in a PhPath; at a cusp there the
/// tangent is its limit. Segments are turned over where that makes e₁ r′/|r′| at the start and at
/// joints, but for corners, continuous from there on; after an odd number of changes of the sign of
/// p or f it is −r′/|r′|. Through neighbouring PH curves the Euler–Rodrigues frame goes on as in a
/// PhPath. Copies share the segments.
class PHRAME_API Path {
 public:
  /// One segment, to which others may be appended; there is room for so many.
  Path(Segment first, std::size_t room = 1);  // NOLINT(google-explicit-constructor)
  /// One PH curve.
  explicit Path(Curve curve) : Path(Segment(PhSegment(std::move(curve)))) {}
  /// The segments of a path of PH curves.
  Path(const PhPath& ph);  // NOLINT(google-explicit-constructor)
  /// A path of segments, at least one, of which it is known that each begins where the one before
  /// ends, with the same tangent but for the `corners`, and that the preimages of PH curves go on.
  /// They are turned over where append() does it.
  static Path of_continuous(std::vector<Segment> segments, std::vector<std::size_t> corners = {});
  Path(const Path&) = default;
  Path& operator=(const Path&) = default;  // to move one is to copy it
  ~Path() = default;

  /// Throws DomainError where the segment does not start where the path ends, and where its tangent
  /// there is the opposite one, with the same messages as PhPath::append; Undecided where that is
  /// not told of values of formulas that agree to 1024 bits. Tangents that agree so far make a
  /// corner, whose angle is 0 or next to it.
  void append(Segment next);

  const std::vector<Segment>& segments() const { return *segments_; }  ///< at least one
  /// The numbers of the segments at whose start the tangent breaks, ascending.
  const std::vector<std::size_t>& corners() const { return corners_; }
  bool has_corner(std::size_t k) const;  ///< does the tangent break at the start of segment k?
  bool is_ph() const;                    ///< are all of its segments polynomial PH curves?
  bool has_erf() const;                  ///< are they PH curves, rational ones among them?
  /// The path of polynomial PH curves, where all of its segments are.
  std::optional<PhPath> ph() const;
  /// The same of PH curves, polynomial or rational ones.
  std::optional<PhPath> with_preimages() const;
  /// The greatest parameter.
  Rational end() const { return Rational(static_cast<long>(segments().size())); }

  /// Does the path end in the point where it starts? Throws Undecided where values of formulas do
  /// not tell.
  bool ends_meet() const;
  /// Do the ends meet, with e₁ on the same side of r′/|r′| at both, and does the tangent not turn
  /// back there? Throws likewise.
  bool is_closed() const;
  /// Is e₁ on another side of r′/|r′| at the end than at the start, as after an odd number of
  /// cusps?
  bool ends_turned_over() const;
  /// Is the path closed, and are the tangents at its ends different, or not told apart from that?
  bool closes_at_corner() const;
  /// PhPath::closing_turn() of a path that has_erf(); no value for others.
  std::optional<GaussianRational> closing_turn() const;

  /// Are the segments equal, one by one?
  friend bool operator==(const Path& a, const Path& b) { return a.segments() == b.segments(); }

 private:
  void add(Segment next);

  using Segments = std::vector<Segment>;
  std::shared_ptr<Segments> segments_;  ///< not changed while it is shared
  std::vector<std::size_t> corners_;
};

/// What is known of the ends of a path.
struct Closure {
  std::optional<bool> ends_meet = std::nullopt;  ///< no value where it is undecided
  std::optional<bool> is_closed = std::nullopt;  ///< likewise
  bool at_corner = false;                        ///< does it close at one?
  std::string undecided = {};                    ///< why
};
/// Path::ends_meet(), is_closed() and closes_at_corner(), as far as they are told.
PHRAME_API Closure closure(const Path& path);

/// The segments, at least one, one after the other. Throws as Path::append.
PHRAME_API Path joined(std::vector<Segment> segments);

/// A path and what it is called.
struct NamedPath {
  std::string name;                     ///< may be empty
  Path path;                            ///< the path
  std::vector<std::string> notes = {};  ///< on how it was read, in sentences without a point
  /// How near the path is to a given one that is not PH, where it stands for that.
  std::optional<Nearness> near = {};
  /// The parameter that its file has, at t = 0, 1, …, as knots are; between them it is a linear
  /// function of t. Empty where there is none, or it is t.
  std::vector<Real> parameters = {};
  std::optional<FrameThrough> frame = {};  ///< the orientations that come with it

  /// A path under this name.
  NamedPath(std::string its_name, const Path& its_path)
      : name(std::move(its_name)), path(its_path) {}
  /// @{ The same path, as one of segments of any kind.
  NamedPath(const NamedPhPath& ph)  // NOLINT(google-explicit-constructor)
      : name(ph.name), path(ph.path), notes(ph.notes), near(ph.near), frame(ph.frame) {}
  NamedPath(const NamedCurve& curve)  // NOLINT(google-explicit-constructor)
      : NamedPath(NamedPhPath(curve)) {}
  /// @}
};

/// @{ The same path, as one of polynomial PH curves, or of PH curves, where it is one.
PHRAME_API std::optional<NamedPhPath> as_ph(const NamedPath& named);
PHRAME_API std::optional<NamedPhPath> with_preimages(const NamedPath& named);
/// @}

/// The PH curve that segment k is. Throws DomainError where it is none and so has no
/// Euler–Rodrigues frame.
PHRAME_API const PhSegment& segment_with_erf(const Path& path, std::size_t k);

/// Is the path a single polynomial PH curve, which has points for all t?
PHRAME_API bool goes_on(const Path& path);
/// The segment that t is in, the later one at a joint, and the parameter there, in [0, 1]; any
/// where the path goes_on(). Throws DomainError for t outside [0, end()] of other paths.
PHRAME_API PathParameter locate(const Path& path, const Rational& t);

}  // namespace phrame
