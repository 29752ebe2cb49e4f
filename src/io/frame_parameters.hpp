#pragma once
#include "phrame/ph/along/parametrization.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {

/// Where on a path frames are, by something else than its t.
struct FrameParameters {
  std::vector<Rational> t;
  std::string what;  ///< "the times, from start to end of the curve", for a note
};

/// Tries the joints of the path one after the other, where there are as many; the times, which are
/// the t of the positions, from 0 to the end of the path; and equal steps. Takes what has the
/// positions on the curve (are_on_curve): of several, where they are nearest. Throws InputError,
/// without a place, where none has to within 1/1000.
FrameParameters frame_parameters(const Path& path, const std::vector<GivenPosition>& positions);

/// The t of frames whose parameter is meant like that; a t that is irrational to within 2^−160.
/// Throws DomainError for what is outside of the path, and where its file has no parameter.
FrameParameters parameters_by(ParameterKind kind, const NamedPath& named,
                              const std::vector<GivenFrame>& frames);

inline constexpr std::size_t most_guessed_frames = 20'000;
/// Where the frames, at their t, are not the path's, by their tangents, f₂ × f₃ or f₂ alone, and
/// are by one of the other kinds to within 10⁻⁶; or, where they are no better than 1/5 at their t,
/// by arc lengths or shares of it with tangents within 1/5, and where the tangents of the path next
/// to there are those of the frames to within 10⁻⁶. No value where they are the path's as they are,
/// where no kind fits, and for more than most_guessed_frames.
std::optional<FrameParameters> better_parameters(const NamedPath& named,
                                                 const std::vector<GivenFrame>& frames);

}  // namespace phrame
