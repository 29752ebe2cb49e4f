#include "phrame/answer/offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <variant>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/offset/gauge_kind.hpp"
#include "phrame/ph/offset/gauge_trim.hpp"
#include "phrame/ph/offset/offset_measure.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"
#include "phrame/ph/offset/offset_trim.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"
#include "phrame/ph/offset/trim_measure.hpp"

namespace phrame::inline v0 {
namespace {

OffsetAnswer::Measure measure(const DefiniteIntegral& found, const std::string& name, long digits) {
  return {found.exact, rounded_or_zero(found.value, name, digits), found.value};
}

OffsetAnswer::Measure measure(const Real& x, const std::string& name, long digits) {
  OffsetAnswer::Measure found{std::nullopt, rounded_as_known(x, name, digits), x};
  if (x.exact()) found.exact = exact_value(*x.exact());
  return found;
}

/// What is said of one offset of a path with that end.
class OffsetReport {
 public:
  OffsetReport(Rational end, const Offset& offset, long digits, bool is_euclidean)
      : end_(std::move(end)), offset_(offset), digits_(digits), is_euclidean_(is_euclidean) {}

  OffsetAnswer::Part make() {
    OffsetAnswer::Part part{
        offset_.distance, paths(offset_), {}, {}, {}, {}, false, {}, {}, {}, {}};
    for (const OffsetCusp& cusp : cusps(offset_))
      part.cusps.push_back({parameter(cusp.piece, cusp.t), cusp.turns_back, point(cusp)});
    add_meetings(part);
    for (const std::size_t k : offset_.inner_corners) part.inner_corners.push_back(corner(k));
    if (is_euclidean_)
      add_lengths(part);
    else
      part.length = measure(length_of(part.paths), "the length of the offset", digits_);
    if (const auto area = signed_area(offset_))
      part.area = measure(*area, "the area of the offset", digits_);
    return part;
  }

 private:
  void add_lengths(OffsetAnswer::Part& part) const {
    const OffsetLength lengths = length(offset_);
    for (const OffsetStretch& stretch : lengths.stretches)
      part.stretches.push_back({parameter(stretch.first_piece, stretch.from),
                                parameter(stretch.last_piece, stretch.to),
                                measure(stretch.length, "the length of a stretch", digits_)});
    part.length = measure(lengths.total, "the length of the offset", digits_);
  }

  static Real length_of(const std::vector<Path>& paths) {
    Real sum = Rational(0);
    for (const Path& path : paths) sum = sum + PathLength(path).total();
    return sum;
  }

  /// t of the corner at the start of that segment; that where the path closes is its end.
  Rational corner(std::size_t segment) const {
    return segment == 0 ? end_ : Rational(static_cast<long>(segment));
  }

  RealAlgebraic parameter(std::size_t piece, const RealAlgebraic& t) const {
    const OffsetPiece& of = offset_.pieces[piece];
    if (of.is_join) return corner(of.segment);
    return affine(t, 1, Rational(static_cast<long>(of.segment)));
  }

  std::array<Decimal, 2> point(const OffsetCusp& cusp) const {
    const Real t = to_real(cusp.t);
    return boundary_end(offset_.pieces[cusp.piece].curve, t, t, digits_).at;
  }

  Decimal parameter(std::size_t piece, const RealBall& t) const {
    const OffsetPiece& of = offset_.pieces[piece];
    if (of.is_join) return round_to_decimal(Real(corner(of.segment)), digits_);
    return rounded_as_known(
        add(t, RealBall(Rational(static_cast<long>(of.segment)), 64), 4 * digits_ + 64), digits_);
  }

  std::array<Decimal, 2> range(const CurvePart& part) const {
    const auto end = [&](double t) { return parameter(part.segment, exact_sum(t, 0)); };
    return {end(part.lower), end(part.upper)};
  }

  void add_meetings(OffsetAnswer::Part& part) const {
    const long bits = 4 * digits_ + 640;  // next to near-cusps the weight has few of them
    const SelfIntersections found = self_intersections(offset_, bits);
    const auto add_meeting = [&](std::size_t first, const RealBall& first_t, std::size_t second,
                                 const RealBall& second_t, bool touches) {
      const OffsetPiece& piece = offset_.pieces[first];
      const auto on = [&](std::size_t of, const RealBall& t, std::size_t k) {
        const RationalCurve& curve = offset_.pieces[of].curve;
        return divide(evaluate(curve.numerator()[k], t, bits), evaluate(curve.weight(), t, bits),
                      bits);
      };
      const auto at = [&](std::size_t k) {
        const RealBall x = on(first, first_t, k);
        return rounded_as_known(x.is_accurate(bits / 2) ? x : on(second, second_t, k), digits_);
      };
      part.meetings.push_back({{parameter(first, first_t), piece.is_join},
                               {parameter(second, second_t), offset_.pieces[second].is_join},
                               {at(0), at(1)},
                               touches});
    };
    for (const Crossing& x : found.found)
      add_meeting(x.first_segment, x.first_t, x.second_segment, x.second_t, false);
    for (const KnownMeeting& x : found.touching)
      add_meeting(x.first_segment, enclose(x.first_t, bits), x.second_segment,
                  enclose(x.second_t, bits), !x.crosses);
    const auto place = [&](std::size_t piece, const RealAlgebraic& t) {
      return OffsetAnswer::Place{parameter(piece, enclose(t, bits)), offset_.pieces[piece].is_join};
    };
    for (const CoincidentParts& x : found.coincident)
      part.coincident.push_back(
          {{place(x.first_segment, x.first_from), place(x.first_segment, x.first_to)},
           {place(x.second_segment, x.second_from), place(x.second_segment, x.second_to)}});
    for (const UndecidedCrossing& x : found.undecided)
      part.undecided.push_back({range(x.first), range(x.second)});
    part.is_cut_off = found.is_cut_off;
  }

  Rational end_;
  const Offset& offset_;
  long digits_;
  bool is_euclidean_;
};

/// How the offsets of a path with that end are trimmed and measured.
struct Trimming {
  Rational end;
  std::function<TrimmedOffset(const Rational& d)> at;
  std::function<BranchMeasure(const TrimmedOffset& trimmed, const TrimmedBranch& branch)> measure;
};

/// What is said of one that is trimmed.
class TrimReport {
 public:
  TrimReport(const Trimming& trimming, const TrimmedOffset& trimmed, long digits)
      : trimming_(trimming), trimmed_(trimmed), digits_(digits) {}

  OffsetAnswer::Trimmed make() const {
    OffsetAnswer::Trimmed report{trimmed_.offset.distance, {}, undecided()};
    for (const TrimmedBranch& branch : trimmed_.branches) report.branches.push_back(make(branch));
    return report;
  }

  /// Of one branch, the first of which has what is undecided.
  OffsetAnswer::Trimmed make(std::size_t branch) const {
    OffsetAnswer::Trimmed report{trimmed_.offset.distance, {make(trimmed_.branches[branch])}, {}};
    if (branch == 0) report.undecided = undecided();
    return report;
  }

 private:
  std::vector<OffsetAnswer::UndecidedStretch> undecided() const {
    std::vector<OffsetAnswer::UndecidedStretch> found;
    for (const UndecidedStretch& x : trimmed_.undecided) {
      const auto end = [&](const Rational& t) {
        return round_to_decimal(parameter(x.piece, Real(t)), 12);
      };
      found.push_back({{end(x.t.lower()), end(x.t.upper())}, is_join(x.piece)});
    }
    return found;
  }

  bool is_join(std::size_t piece) const { return trimmed_.offset.pieces[piece].is_join; }
  static bool is_cut(const Real& t) { return t.exact() != Rational(0) && t.exact() != Rational(1); }

  OffsetAnswer::Branch make(const TrimmedBranch& branch) const {
    OffsetAnswer::Branch report{branch.is_closed, {}, paths(trimmed_, branch, digits_), {}, {}};
    const std::size_t count = branch.parts.size();
    for (std::size_t k = 0; k < count; ++k) {
      const OffsetPart& part = branch.parts[k];
      report.pieces.push_back({end(part.piece, part.from), end(part.piece, part.to),
                               is_join(part.piece), part.piece, is_cut(part.from),
                               is_cut(part.to)});
    }
    const BranchMeasure size = trimming_.measure(trimmed_, branch);
    report.length = measure(size.length, "the length of a branch", digits_);
    if (size.area) report.area = measure(*size.area, "the area of a branch", digits_);
    return report;
  }

  Real parameter(std::size_t piece, const Real& t) const {
    const OffsetPiece& of = trimmed_.offset.pieces[piece];
    if (!of.is_join) return t + Real(Rational(static_cast<long>(of.segment)));
    return of.segment == 0 ? trimming_.end : Rational(static_cast<long>(of.segment));
  }

  OffsetAnswer::End end(std::size_t piece, const Real& t) const {
    return boundary_end(trimmed_.offset.pieces[piece].curve, t, parameter(piece, t), digits_);
  }

  const Trimming& trimming_;
  const TrimmedOffset& trimmed_;
  long digits_;
};

/// Are they of the same segment, or the same part of what joins both at a corner? Where arcs are
/// left out of one offset, pieces have other numbers.
bool are_alike(const Offset& a, std::size_t of_a, const Offset& b, std::size_t of_b) {
  const auto is_same = [](const OffsetPiece& x, const OffsetPiece& y) {
    return x.segment == y.segment && x.is_join == y.is_join;
  };
  const auto is_second = [&](const std::vector<OffsetPiece>& pieces, std::size_t k) {
    return k > 0 && is_same(pieces[k - 1], pieces[k]);
  };
  return is_same(a.pieces[of_a], b.pieces[of_b]) &&
         is_second(a.pieces, of_a) == is_second(b.pieces, of_b);
}

constexpr long most_levels = 10'000;

[[noreturn]] void refuse_many_levels(const Rational& d) {
  throw InputError("pocket", fmt::format("something is left at more than {} multiples of {}",
                                         most_levels, abbreviated(to_string(d))));
}

/// The trimmed offsets at d, 2d, … until nothing is left. On the way from a point of one to the
/// nearest point of the path, along n or U, there is a point of each before it, at the same
/// parameter of the same piece: so what a branch is inside of is told by that alone.
class Pocket {
 public:
  Pocket(const Trimming& trimming, const Rational& d, long digits)
      : trimming_(trimming), digits_(digits) {
    for (Rational sum = d;; sum += d) {
      TrimmedOffset next = trimming.at(sum);
      if (next.branches.empty()) break;
      if (levels_.size() == most_levels) refuse_many_levels(d);
      levels_.push_back(std::move(next));
    }
    if (levels_.empty()) made_.push_back({d, {}, {}});
  }

  std::vector<OffsetAnswer::Trimmed> make() {
    if (!levels_.empty())
      for (std::size_t k = 0; k < levels_.front().branches.size(); ++k) add(0, k);
    return std::move(made_);
  }

 private:
  void add(std::size_t level, std::size_t branch) {
    made_.push_back(TrimReport(trimming_, levels_[level], digits_).make(branch));
    if (level + 1 == levels_.size()) return;
    for (std::size_t k = 0; k < levels_[level + 1].branches.size(); ++k)
      if (branch_around(level, k) == branch) add(level + 1, k);
  }

  /// The branch of that level that the one of the next level is inside of; the first one where none
  /// of its middles is left there, as where lines coincide of which one is left.
  std::size_t branch_around(std::size_t level, std::size_t inner) const {
    constexpr long bits = 128;
    const auto& [offset, branches, undecided] = levels_[level];
    for (const OffsetPart& at : levels_[level + 1].branches[inner].parts) {
      const Rational t = (at.from.enclose(bits).midpoint() + at.to.enclose(bits).midpoint()) / 2;
      const auto has = [&, &outer = offset](const OffsetPart& part) {
        return are_alike(outer, part.piece, levels_[level + 1].offset, at.piece) &&
               hull(part.from.enclose(bits), part.to.enclose(bits), bits).contains(t);
      };
      for (std::size_t k = 0; k < branches.size(); ++k)
        if (std::ranges::any_of(branches[k].parts, has)) return k;
    }
    return 0;
  }

  const Trimming& trimming_;
  long digits_;
  std::vector<TrimmedOffset> levels_;
  std::vector<OffsetAnswer::Trimmed> made_;
};

std::vector<OffsetAnswer::Trimmed> pocket(const Path& path, const Trimming& trimming,
                                          const OffsetQuery& query) {
  if (query.distances.size() != 1)
    throw InputError("pocket", "one distance is wanted, of which the others are multiples");
  const Rational& d = query.distances.front();
  if (!path.is_closed())
    throw InputError("pocket", !path.ends_meet() ? "the path is open"
                               : path.ends_turned_over()
                                   ? "the path turns back at an odd number of cusps"
                                   : "the tangent turns back where the ends meet");
  if (sign_of(signed_area(path)) * d.sign() >= 0)
    throw InputError("pocket", "the distance " + to_string(d) + " is to the outside of the path");
  // Mitres may be left far outside.
  if (query.join != OffsetJoin::mitre && !trimming.at((most_levels + 1) * d).branches.empty())
    refuse_many_levels(d);
  return Pocket(trimming, d, query.digits).make();
}

/// Those that are asked for.
std::vector<OffsetAnswer::Trimmed> trimmed(const Path& path, const Trimming& trimming,
                                           const OffsetQuery& query) {
  if (query.pocket) return pocket(path, trimming, query);
  std::vector<OffsetAnswer::Trimmed> made;
  for (const Rational& d : query.distances)
    made.push_back(TrimReport(trimming, trimming.at(d), query.digits).make());
  return made;
}

OffsetAnswer::Both both_of(const Rational& d, TwoSidedOffset offset) {
  OffsetAnswer::Both both{d, std::move(offset), {}};
  for (const RationalCurve& side : both.offset.sides) both.paths.emplace_back(side);
  return both;
}

/// The kind of the offset to both sides together, or why_no_offset().
std::variant<OffsetKind, std::string> kind_or_reason(const Path& path, bool is_whole) {
  const auto& segments = path.segments();
  const auto other = std::ranges::find_if_not(segments, ph_curve);
  const bool is_one = segments.size() == 1;
  const std::string no_ph = is_one
                                ? "the path is not PH"
                                : fmt::format("segment {} is not PH", other - segments.begin() + 1);
  const RationalCurve* curve = rational_curve(*other);
  if (curve == nullptr) return no_ph + ", but given by formulas";
  OffsetKind kind = offset_kind(*curve);
  using Kind = OffsetKind::Kind;
  if (kind.kind == Kind::none) return no_ph + ", so that its offset is not rational";
  if (kind.kind == Kind::undecided)
    return no_ph + ", and whether its offset is rational is undecided";
  const bool is_decided = kind.kind == Kind::each_side || kind.conic || kind.prime != 0;
  if (is_one && is_whole && is_decided) return kind;
  if (kind.radicand != 1)
    return fmt::format("{}: its offset is rational over ℚ(√{}), not over ℚ", no_ph,
                       to_string(kind.radicand));
  if (!is_decided)
    return no_ph +
           ", and runs more than once along a curve of which the offset is rational for both sides "
           "together";
  return no_ph + ": its offset is rational for both sides together, " +
         (is_one ? "which is not trimmed" : "which is given of a path of one segment");
}

/// Of a path that is not PH.
std::vector<OffsetAnswer::Both> both_sides(const Path& path, const OffsetQuery& query) {
  const auto found_kind = kind_or_reason(path, !query.trim && !query.pocket);
  if (const auto* why = std::get_if<std::string>(&found_kind)) throw InputError("path", *why);
  const RationalCurve& curve = *rational_curve(path.segments().front());
  const auto& kind = std::get<OffsetKind>(found_kind);
  if (kind.kind == OffsetKind::Kind::each_side)
    throw DomainError(fmt::format("offset: the offset is rational over ℚ(√{}), not over ℚ",
                                  to_string(kind.radicand)));
  if (kind.prime != 0)
    throw DomainError(fmt::format(
        "offset: the two-sided offset is rational over ℚ(√{}), not over ℚ, as y² = {} has no "
        "point modulo powers of {}",
        to_string(kind.radicand), to_string(kind.squarefree), to_string(kind.prime)));
  std::vector<OffsetAnswer::Both> found;
  for (const Rational& d : query.distances)
    found.push_back(both_of(d, two_sided_offset(curve, kind, d, query.digits)));
  return found;
}

/// The offsets of a path with that end at the distances asked for. Where nothing but points is left
/// at some of them, these have no paths.
std::vector<OffsetAnswer::Part> parts_of(const Rational& end, const OffsetQuery& query,
                                         const std::function<Offset(const Rational& d)>& at) {
  std::vector<OffsetAnswer::Part> parts;
  for (const Rational& d : query.distances) {
    const Offset offset = at(d);
    if (offset.pieces.empty())
      parts.push_back(
          {d, {}, {}, {}, {}, {}, false, {}, {}, measure(Rational(0), "", query.digits), {}});
    else
      parts.push_back(OffsetReport(end, offset, query.digits, !query.gauge).make());
  }
  if (std::ranges::all_of(parts, [](const auto& part) { return part.paths.empty(); }))
    throw DomainError("offset: at the distance " + to_string(query.distances.front()) +
                      " nothing but points is left");
  return parts;
}

/// Why there is none to either side.
std::string reason(const GaugeOffsets::None& none) {
  using Kind = OffsetKind::Kind;
  std::string text = fmt::format("the irreducible factors of r' x U' are of degree {} in phi",
                                 fmt::join(none.degrees, ", "));
  if (!none.kind || none.kind->kind == Kind::undecided) return text;
  const OffsetKind& kind = *none.kind;
  if (kind.kind == Kind::none)
    return text + fmt::format(
                      ", and the discriminant of one has {} simple roots, so that both sides "
                      "together are not rational, either",
                      kind.squarefree.degree());
  const std::string field = fmt::format("ℚ(√{})", to_string(kind.radicand));
  if (kind.kind == Kind::each_side) return text + "; it is rational to each side over " + field;
  return text + "; for both sides together it is rational" +
         (kind.prime == 0
              ? ""
              : fmt::format(" over {}, not over ℚ, as y² = {} has no point modulo powers of {}",
                            field, to_string(kind.squarefree), to_string(kind.prime)));
}

/// Of a path of one segment under a gauge.
std::vector<OffsetAnswer::Both> both_sides(const RationalCurve& curve, const OffsetQuery& query,
                                           const OffsetKind& kind) {
  std::vector<OffsetAnswer::Both> found;
  for (const Rational& d : query.distances)
    found.push_back(both_of(d, two_sided_offset(curve, *query.gauge, kind, d, query.digits)));
  return found;
}

OffsetAnswer under_gauge(const NamedPath& named, const OffsetQuery& query) {
  const auto is_rational = [](const Segment& segment) {
    return rational_curve(segment) != nullptr;
  };
  if (!std::ranges::all_of(named.path.segments(), is_rational))
    throw InputError("path", "it is given by formulas, and under a gauge of rational curves");
  const GaugeOffsets offsets(named.path, *query.gauge);
  const auto& none = offsets.none();
  const auto& segments = named.path.segments();
  const bool is_whole = !query.trim && !query.pocket;
  if (is_whole && segments.size() == 1 && !none.empty() && none[0].kind && none[0].kind->conic) {
    OffsetAnswer both{named, false, query.join, {}};
    both.gauge = query.gauge;
    both.both = both_sides(*rational_curve(segments.front()), query, *none[0].kind);
    return both;
  }
  if (none.size() == segments.size())
    throw DomainError(fmt::format("offset: {} no rational offset under this gauge: {}",
                                  none.size() == 1 ? "the path has" : "all segments have",
                                  reason(none.front())));
  OffsetAnswer answer{named, named.path.is_closed(), query.join, {}};
  answer.gauge = query.gauge;
  answer.without = offsets.none();
  if (query.trim || query.pocket) {
    const auto at = [&](const Rational& d) {
      return trimmed_offset(named.path, *query.gauge, d, query.join);
    };
    const auto measuring = [](const TrimmedOffset& offset, const TrimmedBranch& branch) {
      return phrame::measure(offset, branch);
    };
    answer.trimmed = trimmed(named.path, {named.path.end(), at, measuring}, query);
    return answer;
  }
  answer.offsets = parts_of(named.path.end(), query,
                            [&](const Rational& d) { return offsets.at(d, query.join); });
  return answer;
}

}  // namespace

void require_plane(const Path& path, const std::string& place) {
  const auto& segments = path.segments();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const RationalCurve* curve = rational_curve(segments[k]);
    if (curve != nullptr && !curve->direction()[2].is_zero())
      throw InputError(place, segments.size() == 1
                                  ? "the curve is in no plane z = const"
                                  : fmt::format("segment {} is in no plane z = const", k + 1));
  }
}

std::optional<std::string> why_no_offset(const Path& path, bool is_whole) {
  auto found = kind_or_reason(path, is_whole);
  if (auto* why = std::get_if<std::string>(&found)) return std::move(*why);
  return std::nullopt;
}

OffsetAnswer answer(const NamedPath& named, const OffsetQuery& query) {
  require_plane(named.path, "path");
  if (std::ranges::find(query.distances, 0) != query.distances.end())
    throw InputError("distance", "0 is no distance");
  if (query.gauge) return under_gauge(named, query);
  const auto path = named.path.with_preimages();
  if (!path) return {named, false, query.join, {}, {}, both_sides(named.path, query)};
  OffsetAnswer answer{named, path->closing_turn().has_value(), query.join, {}};
  if (query.trim || query.pocket) {
    const auto at = [&](const Rational& d) { return trimmed_offset(*path, d, query.join); };
    const auto measuring = [&](const TrimmedOffset& offset, const TrimmedBranch& branch) {
      return phrame::measure(*path, offset, branch);
    };
    answer.trimmed = trimmed(*path, {path->end(), at, measuring}, query);
    return answer;
  }
  answer.offsets =
      parts_of(path->end(), query, [&](const Rational& d) { return offset(*path, d, query.join); });
  return answer;
}

std::vector<Path> all_paths(const OffsetAnswer& answer) {
  std::vector<Path> all;
  for (const auto& part : answer.offsets)
    all.insert(all.end(), part.paths.begin(), part.paths.end());
  for (const auto& part : answer.both) all.insert(all.end(), part.paths.begin(), part.paths.end());
  for (const auto& part : answer.trimmed)
    for (const auto& branch : part.branches)
      all.insert(all.end(), branch.paths.begin(), branch.paths.end());
  return all;
}

}  // namespace phrame
