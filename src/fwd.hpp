#pragma once

/// All of phrame: this file declares the types that programs use, by the rooms that they are in.
namespace phrame::inline v0 {

// algebra
class Integer;
class Rational;
class Polynomial;
class RationalFunction;
class Real;
class RealBall;
class ComplexBall;
class RealAlgebraic;
struct RealRoot;
struct Decimal;
struct Angle;
class Error;
class DomainError;
class Undecided;
class InputError;

// integrate
struct Antiderivative;
struct LogSum;
struct RealForm;
struct RadicalForm;
class Evaluator;
struct DefiniteIntegral;

// ph/curve
class Curve;
class ExpressionCurve;
class Formula;
class Path;
class PhPath;
struct NamedCurve;
struct NamedPath;
struct NamedPhPath;
struct Nearness;
struct NotPythagorean;

// ph/along
class RmfAngle;
class PathAngle;
class ArcLength;
class PathLength;
class TravelTime;
struct Feedrate;
struct FrameAngle;
struct CurveTotal;
struct PathTotal;

// ph/frame
class Frames;
class CompiledAngle;
class CompiledFrames;
struct ClosedFrame;
struct FrameVerdict;
struct GivenFrame;
struct StartNormal;

// ph/twist
class MinimalTwist;
struct TwistFrame;

// ph/construct
struct GivenPoints;
struct HermiteSpline;

// ph/proof
struct Classification;
struct PathClassification;
struct Certificate;
struct Statement;

// answer
struct AngleQuery;
struct AngleAnswer;
struct CheckQuery;
struct CheckAnswer;
struct ClassificationQuery;
struct ClassificationAnswer;
struct CompiledQuery;
struct CompiledAnswer;
struct ConstructQuery;
struct ConstructionAnswer;
struct AxisConstructionQuery;
struct AxisConstructionAnswer;
struct CoqQuery;
struct CoqAnswer;
struct IdentificationAnswer;
struct PathIdentification;
struct InfoQuery;
struct InfoAnswer;
struct IntegralQuery;
struct IntegralAnswer;
struct InterpolationQuery;
struct MinimalTwistQuery;
struct MinimalTwistAnswer;
struct PathTwistQuery;
struct PathTwistAnswer;
struct EnvelopeQuery;
struct EnvelopeAnswer;
struct OffsetQuery;
struct OffsetAnswer;
struct OffsetCheckAnswer;
struct PageQuery;
struct PageAnswer;
struct TotalsQuery;
struct TotalsAnswer;
struct TwistPieceAnswer;
struct TwistFrameAnswer;
struct WronskianQuery;
struct WronskianAnswer;

}  // namespace phrame
