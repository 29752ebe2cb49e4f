#pragma once
#include <string>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/fwd.hpp"

namespace phrame::inline v0 {

// What is printed of an answer: to_text() for reading, in Unicode and with passages
// (for_reading()), to_json() in the format that is named here, to_latex() for amsmath and amssymb.
// A check says how its table was read, so its texts are in check.hpp; tables of frames are in
// frame_table.hpp.

/// @{ The closed forms, or the integral, and the values: angle/1, of a spline spline-angle/1.
PHRAME_API std::string to_text(const AngleAnswer& answer);
PHRAME_API std::string to_json(const AngleAnswer& answer);
PHRAME_API std::string to_latex(const AngleAnswer& answer);
/// @}
/// @{ classify/1, of a spline spline-classify/1.
PHRAME_API std::string to_text(const ClassificationAnswer& answer);
PHRAME_API std::string to_json(const ClassificationAnswer& answer);
PHRAME_API std::string to_latex(const ClassificationAnswer& answer);
/// @}
/// @{ construct/1; in LaTeX rows of an align*, and the segments as a tabular.
PHRAME_API std::string to_text(const ConstructionAnswer& answer);
PHRAME_API std::string to_json(const ConstructionAnswer& answer);
PHRAME_API std::string to_latex(const ConstructionAnswer& answer);
/// @}
/// @{ construct-axis/1.
PHRAME_API std::string to_text(const AxisConstructionAnswer& answer);
PHRAME_API std::string to_json(const AxisConstructionAnswer& answer);
PHRAME_API std::string to_latex(const AxisConstructionAnswer& answer);
/// The curves as mph/1.
PHRAME_API std::string write_axis(const AxisConstructionAnswer& answer);
/// @}
/// Why the curve is no PH curve, on one line. Precondition: it is none.
PHRAME_API std::string reason_of(const IdentificationAnswer& answer);
/// @{ identify/1.
PHRAME_API std::string to_text(const IdentificationAnswer& answer);
PHRAME_API std::string to_json(const IdentificationAnswer& answer);
PHRAME_API std::string to_latex(const IdentificationAnswer& answer);
PHRAME_API std::string to_text(const PathIdentification& found);
PHRAME_API std::string to_json(const PathIdentification& found);
PHRAME_API std::string to_latex(const PathIdentification& found);
/// @}
/// @{ info/1, of a spline spline-info/1.
PHRAME_API std::string to_text(const InfoAnswer& answer);
PHRAME_API std::string to_json(const InfoAnswer& answer);
PHRAME_API std::string to_latex(const InfoAnswer& answer);
/// @}
/// @{ The closed form and the value: integral/1. That the derivative was checked can be left unsaid
/// where it was said before; it always is.
PHRAME_API std::string to_text(const IntegralAnswer& answer, bool says_checked = true);
PHRAME_API std::string to_json(const IntegralAnswer& answer);
PHRAME_API std::string to_latex(const IntegralAnswer& answer);
/// @}
/// @{ totals/1, of a spline spline-totals/1.
PHRAME_API std::string to_text(const TotalsAnswer& answer);
PHRAME_API std::string to_json(const TotalsAnswer& answer);
PHRAME_API std::string to_latex(const TotalsAnswer& answer);
/// @}
/// @{ offset/1.
PHRAME_API std::string to_text(const OffsetAnswer& answer);
PHRAME_API std::string to_json(const OffsetAnswer& answer);
PHRAME_API std::string to_latex(const OffsetAnswer& answer);
/// The offsets as a curve file, or, where they are several paths, one on each line.
PHRAME_API std::string write_offsets(const OffsetAnswer& answer);
/// @}
/// @{ envelope/1.
PHRAME_API std::string to_text(const EnvelopeAnswer& answer);
PHRAME_API std::string to_json(const EnvelopeAnswer& answer);
PHRAME_API std::string to_latex(const EnvelopeAnswer& answer);
/// All paths, as those of offsets.
PHRAME_API std::string write_envelope(const EnvelopeAnswer& answer);
/// @}
/// @{ offset-check/1.
PHRAME_API std::string to_text(const OffsetCheckAnswer& answer);
PHRAME_API std::string to_json(const OffsetCheckAnswer& answer);
/// @}
/// @{ mtf/1.
PHRAME_API std::string to_text(const MinimalTwistAnswer& answer);
PHRAME_API std::string to_json(const MinimalTwistAnswer& answer);
PHRAME_API std::string to_latex(const MinimalTwistAnswer& answer);
/// @}
/// @{ twist-through/1.
PHRAME_API std::string to_text(const PathTwistAnswer& answer);
PHRAME_API std::string to_json(const PathTwistAnswer& answer);
PHRAME_API std::string to_latex(const PathTwistAnswer& answer);
/// @}
/// @{ wronskian/1.
PHRAME_API std::string to_text(const WronskianAnswer& answer);
PHRAME_API std::string to_json(const WronskianAnswer& answer);
PHRAME_API std::string to_latex(const WronskianAnswer& answer);
/// @}
/// A line for each statement of a certificate, and how many are not proved.
PHRAME_API std::string to_text(const std::vector<Statement>& statements);
/// "all 17 statements are proved", "1 of 17 statements is not proved".
PHRAME_API std::string summary(const std::vector<Statement>& statements);

}  // namespace phrame
