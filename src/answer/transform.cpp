#include "phrame/answer/transform.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long cut_bits = 64;

/// Where a path is cut.
class Cuts {
 public:
  Cuts(const NamedPath& named, ParameterKind by) : along_(named, by) {}

  Rational t(const Rational& x) {
    const Real t = parameter(along_.point(x).at);
    if (t.exact()) return *t.exact();
    is_rounded_ = true;
    return std::min(rounded_to_places(t.enclose(cut_bits + 32).midpoint(), cut_bits),
                    along_.path().end());
  }
  bool is_rounded() const { return is_rounded_; }

 private:
  Parametrization along_;
  bool is_rounded_ = false;
};

/// From one t to the next, two of each part.
std::vector<Rational> ends_of_parts(Cuts& cuts, const Path& path, const TransformQuery& query) {
  if (query.part) return {cuts.t(query.part->first), cuts.t(query.part->second)};
  std::vector<Rational> ends{0};
  for (const Rational& x : query.split) {
    const Rational t = cuts.t(x);
    if (t <= ends.back() || t >= path.end())
      throw DomainError(
          fmt::format("split: {} is not {}", as_written(x),
                      t <= 0 || t >= path.end() ? "inside the path" : "behind the one before it"));
    ends.push_back(t);
  }
  ends.push_back(path.end());
  return ends;
}

/// Of formulas by themselves, the values of their variable at the ends of parts, if that is what
/// these are told by: then nothing is rounded.
std::vector<Formula> variables_at(const ExpressionCurve& curve, const TransformQuery& query) {
  if (query.part) return {query.part->first, query.part->second};
  std::vector<Formula> values{curve.from()};
  for (const Rational& x : query.split) values.emplace_back(x);
  values.push_back(curve.to());
  return values;
}

/// The orientations under a map that turns the path; none where it does not.
std::optional<FrameThrough> turned(const FrameThrough& frame, const AffineMap& map) {
  const auto found = similarity(map);
  if (!found || found->factor < 0) return std::nullopt;
  FrameThrough result = frame;
  for (auto& joint : result.joints) joint.f2 = AffineMap{map.columns}(joint.f2);
  return result;
}

}  // namespace

std::vector<NamedPath> answer(const NamedPath& named, const TransformQuery& query) {
  if (query.is_whole_line) {
    TransformQuery rest = query;
    rest.is_whole_line = false;
    std::vector<NamedPath> parts = answer(NamedPath(named.name, whole_line(named.path)), rest);
    if (named.frame) parts.front().notes.emplace_back("the orientations are left out");
    return parts;
  }
  Cuts cuts(named, query.by);
  const std::vector<Rational> ends = ends_of_parts(cuts, named.path, query);
  const bool is_whole = !query.part && query.split.empty();
  const auto* formulas = query.by == ParameterKind::native && named.path.segments().size() == 1
                             ? std::get_if<ExpressionCurve>(&named.path.segments().front())
                             : nullptr;
  const auto part_of = [&](std::size_t k) {
    if (is_whole) return named.path;
    if (formulas == nullptr) return segment(named.path, ends[k], ends[k + 1]);
    const std::vector<Formula> values = variables_at(*formulas, query);
    return Path(Segment(
        ExpressionCurve(formulas->position(), values[k], values[k + 1], formulas->variable())));
  };
  std::vector<NamedPath> parts;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    Path part = query.is_reversed ? reversed(part_of(k)) : part_of(k);
    if (query.map != AffineMap{}) part = transformed(part, query.map);
    const bool is_one = named.name.empty() || ends.size() == 2;
    parts.emplace_back(is_one ? named.name : fmt::format("{}-{}", named.name, k + 1),
                       std::move(part));
  }
  if (query.is_reversed) std::reverse(parts.begin(), parts.end());
  auto& notes = parts.front().notes;
  if (cuts.is_rounded() && formulas == nullptr)
    notes.emplace_back("it is cut at irrational t, rounded to multiples of 2^-64");
  if (!named.frame) return parts;
  if (is_whole && !query.is_reversed) parts.front().frame = turned(*named.frame, query.map);
  if (!parts.front().frame) notes.emplace_back("the orientations are left out");
  return parts;
}

}  // namespace phrame
