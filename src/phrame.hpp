#pragma once
// The public interface: this and what it includes; all else is inside, and not installed. Where to
// begin:
//   read_path(), identify()                   curves of files, or by their hodograph
//   read_any_path()                           curves of any kind, of files of any format
//   answer(path, AngleQuery{…}), to_text()    what the commands of the program answer, and its text
//   RmfAngle, PathAngle, Frames               angles and frames, for many t
//   CompiledAngle, CompiledFrames             the same for millions of t
//   ExpressionCurve, closed_frame()           curves by formulas; writhe, linking of closed curves
//   integrate(), definite_integral()          of any rational function

// Questions and their answers.
#include "phrame/answer/angle.hpp"
#include "phrame/answer/axis_construction.hpp"
#include "phrame/answer/camera_path.hpp"
#include "phrame/answer/check.hpp"
#include "phrame/answer/classification.hpp"
#include "phrame/answer/compiled.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/answer/envelope.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/identification.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/integral.hpp"
#include "phrame/answer/interpolation.hpp"
#include "phrame/answer/machine_path.hpp"
#include "phrame/answer/minimal_twist.hpp"
#include "phrame/answer/offset.hpp"
#include "phrame/answer/offset_check.hpp"
#include "phrame/answer/path_twist.hpp"
#include "phrame/answer/sweep.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/answer/transform.hpp"
#include "phrame/answer/wronskian.hpp"

// What is read.
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/axis_file.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/feedrate.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/read/frame_csv.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/profile.hpp"
#include "phrame/io/read/roll.hpp"

// What is written.
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/io/write/camera.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/io/write/check.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/formula.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/gcode.hpp"
#include "phrame/io/write/mesh.hpp"
#include "phrame/io/write/passage.hpp"

// Curves and paths, their frames, lengths and times, beyond what the answers need.
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/travel_time.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/construct/near_plane_path.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/rational_ph.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/frame/closed_curve.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/frame_quaternion.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/signed_frenet.hpp"
#include "phrame/ph/proof/certify.hpp"
#include "phrame/ph/proof/certify_integral.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/verify.hpp"
#include "phrame/ph/proof/verify_integral.hpp"

// Numbers and rational functions, likewise, errors, and what to call first where memory may not do.
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/out_of_memory.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/time_limit.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/version.hpp"
