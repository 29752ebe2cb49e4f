#include "phrame/io/write/names.hpp"

#include <algorithm>

#include "phrame/answer/angle.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/answer/offset.hpp"
#include "phrame/answer/wronskian.hpp"

namespace phrame::inline v0 {
namespace {

template <class T>
const std::string& name_in(const Names<T>& names, T value) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& named) { return named.second == value; })
      ->first;
}

}  // namespace

const Names<Reference>& reference_names() {
  static const Names<Reference> names{
      {"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}, {"up", Reference::up}};
  return names;
}

const Names<QuinticSelection>& quintic_selections() {
  static const Names<QuinticSelection> names{{"auto", QuinticSelection::automatic},
                                             {"minimal", QuinticSelection::minimal},
                                             {"bv", QuinticSelection::bv},
                                             {"cc", QuinticSelection::cc},
                                             {"shortest", QuinticSelection::shortest},
                                             {"longest", QuinticSelection::longest},
                                             {"energy", QuinticSelection::energy}};
  return names;
}

const Names<FrameWeight>& frame_weights() {
  static const Names<FrameWeight> names{{"one", FrameWeight::one},
                                        {"torsion-curvature", FrameWeight::torsion_curvature},
                                        {"speed", FrameWeight::speed}};
  return names;
}

const std::string& name_of(Reference reference) { return name_in(reference_names(), reference); }

const std::string& name_of(QuinticSelection selection) {
  return name_in(quintic_selections(), selection);
}

const std::string& name_of(FrameWeight weight) { return name_in(frame_weights(), weight); }

const Names<OffsetJoin>& offset_joins() {
  static const Names<OffsetJoin> names{
      {"round", OffsetJoin::round}, {"mitre", OffsetJoin::mitre}, {"open", OffsetJoin::open}};
  return names;
}

const std::string& name_of(OffsetJoin join) { return name_in(offset_joins(), join); }

const Names<ParameterKind>& parameter_kinds() {
  static const Names<ParameterKind> names{{"t", ParameterKind::t},
                                          {"native", ParameterKind::native},
                                          {"unit", ParameterKind::unit},
                                          {"arc-length", ParameterKind::arc_length},
                                          {"fraction", ParameterKind::fraction}};
  return names;
}

const std::string& name_of(ParameterKind kind) { return name_in(parameter_kinds(), kind); }

std::string column_of(ParameterKind kind) {
  return kind == ParameterKind::arc_length ? "s" : name_of(kind);
}

}  // namespace phrame
