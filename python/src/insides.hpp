#pragma once
// What the package has of the insides of the library, beside its public interface.
#include "phrame/phrame.hpp"

// What reals.cpp computes with, as Python has numbers that know of themselves what they are.
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/elementary.hpp"
#include "phrame/algebra/rounded_polynomial.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/zero_bound.hpp"
#include "phrame/ph/curve/real_vector.hpp"

// What is typed as a string, and what is shown of a value without its answer.
#include "phrame/io/read/angle.hpp"
#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/endpoint_text.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/nearness.hpp"

// Curves of arrays of points.
#include "phrame/io/read/given_segment.hpp"
#include "phrame/ph/construct/cubic_interpolation.hpp"
#include "phrame/ph/curve/rational_form.hpp"
#include "phrame/ph/curve/rational_ph.hpp"

// Texts for other programs, and meshes and frames for arrays.
#include "phrame/answer/page.hpp"
#include "phrame/io/write/cas_script.hpp"
#include "phrame/io/write/page.hpp"
#include "phrame/ph/frame/compiled_frame_rotation.hpp"
#include "phrame/ph/frame/near_rotation.hpp"
#include "phrame/ph/frame/rotation_ball.hpp"
#include "phrame/ph/sweep/mesh_numbers.hpp"
