#include "phrame/answer/offset_picture.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"

namespace phrame::inline v0 {
namespace {

/// x and y, as samples have them.
std::array<Decimal, 2> sampled(const Vector<Real>& point) {
  return {round_to_decimal(point[0], 12), round_to_decimal(point[1], 12)};
}

/// Into how many steps a segment is divided: each is a short decimal, and all of them are not too
/// many.
long steps_of(std::size_t segments) {
  long found = 4;
  for (const long steps : {10, 20, 50, 100, 200})
    if (static_cast<std::size_t>(steps) * segments <= 400) found = steps;
  return found;
}

/// The offsets of the path of an answer with all that they have too much.
class Whole {
 public:
  explicit Whole(const OffsetAnswer& answer)
      : path_(answer.path.path), join_(answer.join), ph_(path_.with_preimages()) {
    if (answer.gauge) under_gauge_.emplace(path_, *answer.gauge);
  }

  Offset at(const Rational& d) const { return at(d, join_); }
  /// With the pieces that trimmed ones have.
  Offset before_trimming(const Rational& d) const {
    return at(d, join_ == OffsetJoin::open ? OffsetJoin::round : join_);
  }

  /// Those for which is_wanted(piece, its parameter).
  template <class Is>
  std::vector<OffsetSample> samples(const Offset& offset, const Is& is_wanted) const {
    const long steps = steps_of(path_.segments().size());
    std::vector<OffsetSample> list;
    for (std::size_t piece = 0; piece < offset.pieces.size(); ++piece)
      for (long k = 0; k <= steps; ++k)
        if (is_wanted(piece, Rational(k, steps)))
          list.push_back(sample(offset.pieces[piece], Rational(k, steps)));
    return list;
  }

 private:
  Offset at(const Rational& d, OffsetJoin join) const {
    return under_gauge_ ? under_gauge_->at(d, join) : offset(*ph_, d, join);
  }

  /// Of what joins the offsets at a corner, t and the point of the path are those of the corner.
  OffsetSample sample(const OffsetPiece& piece, const Rational& u) const {
    const Rational first(static_cast<long>(piece.segment));
    const Rational t = !piece.is_join      ? Rational(first + u)
                       : piece.segment > 0 ? first
                                           : path_.end();
    const Vector<Real> of = position(path_, Place(piece.segment, piece.is_join ? Rational(0) : u));
    return {t, piece.is_join, sampled(position(piece.curve, u)), {*of[0].exact(), *of[1].exact()}};
  }

  const Path& path_;
  OffsetJoin join_;
  std::optional<PhPath> ph_;
  std::optional<GaugeOffsets> under_gauge_;
};

/// Which points of curves are left? Only those inside of a part, so not at joints, are said to be.
class Left {
 public:
  void add(std::size_t curve, const Real& from, const Real& to) {
    constexpr long bits = 96;
    RealBall lower = from.enclose(bits);
    RealBall upper = to.enclose(bits);
    if (lower.midpoint() > upper.midpoint()) std::swap(lower, upper);
    parts_.emplace(curve, std::pair(lower.upper(), upper.lower()));
  }

  bool operator()(std::size_t curve, const Rational& t) const {
    const auto [first, last] = parts_.equal_range(curve);
    return std::any_of(first, last, [&](const auto& part) {
      return part.second.first < t && t < part.second.second;
    });
  }

 private:
  std::multimap<std::size_t, std::pair<Rational, Rational>> parts_;
};

/// By pieces.
Left left_of(const OffsetAnswer::Trimmed& trimmed) {
  Left left;
  for (const auto& branch : trimmed.branches)
    for (const auto& piece : branch.pieces) left.add(piece.piece, piece.from.share, piece.to.share);
  return left;
}

/// Of the two sides, by t of the axis, to the left backwards.
Left left_of(const EnvelopeAnswer& answer) {
  Left left;
  for (const auto& branch : answer.branches)
    for (const auto& piece : branch.pieces)
      if (piece.kind == EnvelopePiece::Kind::right || piece.kind == EnvelopePiece::Kind::left)
        left.add(piece.kind == EnvelopePiece::Kind::right ? 0 : 1, piece.from.t, piece.to.t);
  return left;
}

/// Of both sides: of a short t there is one m on each of them.
std::vector<OffsetSample> samples_of(const TwoSidedOffset& offset, const RationalCurve& curve) {
  const RationalFunction& t_of_m = offset.parameter;
  const long steps = steps_of(1);
  std::vector<OffsetSample> list;
  for (const auto& [from, to] : offset.ends)
    for (long k = 1; k < steps; ++k) {
      const Rational t(k, steps);
      const auto found = real_roots(t_of_m.numerator() - t * t_of_m.denominator(),
                                    closed_interval(std::min(from, to), std::max(from, to)));
      if (found.empty()) continue;  // m at the ends is rounded
      const Place m(0, to_real(found.front().at));
      const Vector<Rational> of = point(curve, t);
      const auto at = [&](std::size_t j) { return value({offset.numerator[j], offset.weight}, m); };
      list.push_back({t, false, sampled({at(0), at(1), Rational(0)}), {of[0], of[1]}});
    }
  return list;
}

}  // namespace

OffsetPicture picture(const OffsetAnswer& answer) {
  const Rational tolerance = drawing_tolerance(answer);
  OffsetPicture found{cubics_of({answer.path.path}, tolerance), {}};
  for (const auto& part : answer.both)
    found.layers.push_back(
        {cubics_of(part.paths, tolerance),
         {},
         samples_of(part.offset, *rational_curve(answer.path.path.segments().front()))});
  if (!answer.both.empty()) return found;
  const Whole whole(answer);
  for (const auto& part : answer.offsets)
    found.layers.push_back({cubics_of(part.paths, tolerance),
                            {},
                            whole.samples(whole.at(part.distance),
                                          [](std::size_t, const Rational&) { return true; })});
  std::map<Rational, Offset> at;
  for (const auto& part : answer.trimmed) {
    OffsetPicture::Layer layer;
    for (const auto& branch : part.branches)
      for (OffsetCubics& path : cubics_of(branch.paths, tolerance))
        layer.paths.push_back(std::move(path));
    const auto [place, is_new] =
        at.try_emplace(part.distance, whole.before_trimming(part.distance));
    if (is_new) layer.whole = cubics_of(paths(whole.at(part.distance)), tolerance);
    layer.samples = whole.samples(place->second, left_of(part));
    found.layers.push_back(std::move(layer));
  }
  return found;
}

OffsetPicture picture(const EnvelopeAnswer& answer) {
  const Rational tolerance = drawing_tolerance(answer);
  OffsetPicture found{{}, {{}}};
  OffsetPicture::Layer& layer = found.layers.front();
  layer.paths = cubics_of(all_paths(answer), tolerance);
  const long steps = steps_of(answer.segments.size());
  const Left left = left_of(answer);
  for (std::size_t k = 0; k < answer.segments.size(); ++k) {
    const auto& segment = answer.segments[k];
    const Vector<Polynomial> center = position(segment.curve);
    const RationalCurve axis({center[0], center[1], {}});
    for (OffsetCubics& path : cubics_of({Path(segment_of(axis))}, tolerance))
      found.path.push_back(std::move(path));
    for (std::size_t side = 0; side < 2; ++side) {
      const auto& curve = (side == 0 ? segment.right : segment.left).curve;
      for (long step = 0; curve && step <= steps; ++step) {
        const Rational u(step, steps);
        const Rational t = Rational(static_cast<long>(k)) + u;
        if (answer.is_trimmed && !left(side, t)) continue;
        const Vector<Rational> of = point(axis, u);
        layer.samples.push_back({t, false, sampled(position(*curve, Place(0, u))), {of[0], of[1]}});
      }
    }
  }
  return found;
}

}  // namespace phrame
