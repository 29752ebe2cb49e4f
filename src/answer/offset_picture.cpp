#include "phrame/answer/offset_picture.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/rounding.hpp"

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

  Offset at(const Rational& d) const {
    return under_gauge_ ? under_gauge_->at(d, join_) : offset(*ph_, d, join_);
  }

  /// Those for which is_wanted(t).
  template <class Is>
  std::vector<OffsetSample> samples(const Offset& offset, const Is& is_wanted) const {
    const long steps = steps_of(path_.segments().size());
    std::vector<OffsetSample> list;
    for (const OffsetPiece& piece : offset.pieces) {
      if (piece.is_join) continue;
      for (long k = 0; k <= steps; ++k) {
        const Rational u(k, steps);
        const Rational t = Rational(static_cast<long>(piece.segment)) + u;
        if (!is_wanted(t)) continue;
        const Vector<Real> of = position(path_, Place(piece.segment, u));
        list.push_back({t, sampled(position(piece.curve, u)), {*of[0].exact(), *of[1].exact()}});
      }
    }
    return list;
  }

 private:
  const Path& path_;
  OffsetJoin join_;
  std::optional<PhPath> ph_;
  std::optional<GaugeOffsets> under_gauge_;
};

/// For which t are points left? Only those inside of a part, so not at joints, are said to be.
class Left {
 public:
  void add(const BoundaryEnd& from, const BoundaryEnd& to) {
    constexpr long bits = 96;
    parts_.emplace_back(from.t.enclose(bits).upper(), to.t.enclose(bits).lower());
  }

  bool operator()(const Rational& t) const {
    return std::ranges::any_of(parts_,
                               [&](const auto& part) { return part.first < t && t < part.second; });
  }

 private:
  std::vector<std::pair<Rational, Rational>> parts_;
};

Left left_of(const OffsetAnswer::Trimmed& trimmed) {
  Left left;
  for (const auto& branch : trimmed.branches)
    for (const auto& piece : branch.pieces)
      if (!piece.is_join) left.add(piece.from, piece.to);
  return left;
}

/// Of what goes on that side of the axis, to the left backwards.
Left left_of(const EnvelopeAnswer& answer, EnvelopePiece::Kind kind) {
  Left left;
  for (const auto& branch : answer.branches)
    for (const auto& piece : branch.pieces)
      if (piece.kind == kind && kind == EnvelopePiece::Kind::right)
        left.add(piece.from, piece.to);
      else if (piece.kind == kind)
        left.add(piece.to, piece.from);
  return left;
}

}  // namespace

OffsetPicture picture(const OffsetAnswer& answer) {
  OffsetPicture found{{}, {}, drawing_tolerance(answer)};
  found.path = cubics_of({answer.path.path}, found.tolerance);
  for (const auto& part : answer.both)
    found.layers.push_back({cubics_of(part.paths, found.tolerance), {}, {}});
  if (!answer.both.empty()) return found;
  const Whole whole(answer);
  for (const auto& part : answer.offsets)
    found.layers.push_back(
        {cubics_of(part.paths, found.tolerance),
         {},
         whole.samples(whole.at(part.distance), [](const Rational&) { return true; })});
  std::map<Rational, Offset> at;
  for (const auto& part : answer.trimmed) {
    OffsetPicture::Layer layer;
    for (const auto& branch : part.branches)
      for (OffsetCubics& path : cubics_of(branch.paths, found.tolerance))
        layer.paths.push_back(std::move(path));
    const auto [place, is_new] = at.try_emplace(part.distance, whole.at(part.distance));
    if (is_new) layer.whole = cubics_of(paths(place->second), found.tolerance);
    layer.samples = whole.samples(place->second, left_of(part));
    found.layers.push_back(std::move(layer));
  }
  return found;
}

OffsetPicture picture(const EnvelopeAnswer& answer) {
  OffsetPicture found{{}, {{}}, drawing_tolerance(answer)};
  OffsetPicture::Layer& layer = found.layers.front();
  layer.paths = cubics_of(all_paths(answer), found.tolerance);
  const long steps = steps_of(answer.segments.size());
  const std::array<Left, 2> left{left_of(answer, EnvelopePiece::Kind::right),
                                 left_of(answer, EnvelopePiece::Kind::left)};
  for (std::size_t k = 0; k < answer.segments.size(); ++k) {
    const auto& segment = answer.segments[k];
    const Vector<Polynomial> center = position(segment.curve);
    const RationalCurve axis({center[0], center[1], {}});
    for (OffsetCubics& path : cubics_of({Path(segment_of(axis))}, found.tolerance))
      found.path.push_back(std::move(path));
    for (std::size_t side = 0; side < 2; ++side) {
      const auto& curve = (side == 0 ? segment.right : segment.left).curve;
      for (long step = 0; curve && step <= steps; ++step) {
        const Rational u(step, steps);
        const Rational t = Rational(static_cast<long>(k)) + u;
        if (answer.is_trimmed && !left[side](t)) continue;
        const Vector<Rational> of = point(axis, u);
        layer.samples.push_back({t, sampled(position(*curve, Place(0, u))), {of[0], of[1]}});
      }
    }
  }
  return found;
}

}  // namespace phrame
