#include <cctype>

#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct TwistPieceObject {
  MinimalTwist mtf;  ///< which errors are relative to
  BestTwist best;
  nb::object recipe;
};

struct RationalTwistObject {
  MinimalTwist mtf;
  TwistFrame frame;
  nb::object recipe;
};

/// As --subdivide of the program has it, the list in Python's form.
Subdivision subdivision_of(nb::handle list, const Rational& end) {
  if (PyUnicode_Check(list.ptr()) != 0 || PySequence_Check(list.ptr()) == 0)
    refuse_type("subdivide", "a sequence of words and parameters", list);
  Subdivision wanted;
  std::size_t k = 0;
  for (const nb::handle item : nb::list(list)) {
    const std::string place = "subdivide[" + std::to_string(k++) + "]";
    const std::string word =
        PyUnicode_Check(item.ptr()) != 0 ? std::string(text(item, place)) : std::string();
    if (word == "inflections") {
      wanted.at_inflections = true;
    } else if (word == "extrema") {
      wanted.at_extrema = true;
    } else if (word == "auto") {
      wanted.until_monotone = true;
    } else if (word.starts_with("rms:")) {
      wanted.tolerance = rational(nb::str(word.substr(4).c_str()), place);
      if (*wanted.tolerance <= 0) refuse(place, "the error must be positive", item);
    } else if (!word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
      refuse(place,
             "\"" + abbreviated(word) +
                 "\" is none of inflections, extrema, auto, rms:X and a parameter",
             item);
    } else {
      wanted.at.push_back(rational(item, place));
      if (wanted.at.back() < 0 || wanted.at.back() > end)
        refuse(place, "it is outside [0, " + to_string(end) + "]", item);
    }
  }
  return wanted;
}

nb::object piece_of(const MinimalTwist& mtf, const BestTwist& best, nb::object recipe) {
  return nb::cast(TwistPieceObject{mtf, best, std::move(recipe)});
}

nb::object pieces_of(nb::handle self) {
  const auto& of = nb::cast<const RationalTwistObject&>(self);
  nb::list list;
  for (std::size_t k = 0; k < of.frame.pieces.size(); ++k)
    list.append(
        piece_of(of.mtf, of.frame.pieces[k],
                 recipe(imported("phrame._pickle", "element"), nb::borrow(self), "pieces", k)));
  return nb::tuple(list);
}

nb::object other_of(nb::handle self) {
  const auto& of = nb::cast<const TwistPieceObject&>(self);
  if (!of.best.other) return nb::none();
  return piece_of(of.mtf, {*of.best.other, {}, "it is not looked for with a proof", {}},
                  attribute_recipe(self, "other"));
}

/// As doubles next to them.
nb::object coefficients_of(const TwistPieceObject& of) {
  const auto near = [](const RealBall& x) { return x.contains_zero() ? 0 : approximate(x); };
  const auto list = without_gil([twist = of.best.twist, near] {
    std::vector<std::pair<double, double>> numbers;
    for (const auto& [re, im] : twist.coefficients())
      numbers.emplace_back(near(re.enclose(80)), near(im.enclose(80)));
    return numbers;
  });
  nb::list result;
  for (const auto& [re, im] : list) result.append(nb::steal(PyComplex_FromDoubles(re, im)));
  return nb::tuple(result);
}

/// Relative to |Ω̄₁|, as the reports have it.
Real size_of(const Real& error, const MinimalTwist& mtf, const RationalTwist& twist) {
  return relative_error(error, mtf, twist.piece().length);
}

void bind_piece(nb::module_& m) {
  auto type = nb::class_<TwistPieceObject>(
      m, "RationalTwistPiece",
      "A rational frame along a piece of a path: the Euler–Rodrigues frame turned by 2 arg w, "
      "where w is a complex polynomial.");
  using T = TwistPieceObject;
#define PHRAME_PIECE(name, value, what)                                                     \
  type.def_prop_ro(                                                                         \
      name,                                                                                 \
      [](nb::handle self) {                                                                 \
        const auto& of = nb::cast<const T&>(self);                                          \
        return to_python(                                                                   \
            without_gil([mtf = of.mtf, twist = of.best.twist]() -> Real { return value; }), \
            attribute_recipe(self, name));                                                  \
      },                                                                                    \
      nb::sig("def " name "(self) -> fractions.Fraction | Real"), what)
  PHRAME_PIECE("gamma", twist.end_factor(),
               "γ of w(1) = γ exp(iθ(1)/2), where w(0) = exp(iθ(0)/2).");
  PHRAME_PIECE("rms", size_of(twist.root_mean_square(), mtf, twist),
               "The root mean square of Ω₁ − Ω̄₁ along the piece, over |Ω̄₁|, or times the length of "
               "the path where Ω̄₁ is 0.");
  PHRAME_PIECE("greatest", size_of(twist.greatest_error(), mtf, twist),
               "The greatest |Ω₁ − Ω̄₁|, likewise.");
#undef PHRAME_PIECE
  type.def_prop_ro(
          "start", [](const T& of) { return to_python(of.best.twist.piece().from); },
          nb::sig("def start(self) -> fractions.Fraction"), "The parameter of the path there.")
      .def_prop_ro(
          "end", [](const T& of) { return to_python(of.best.twist.piece().to); },
          nb::sig("def end(self) -> fractions.Fraction"), "Likewise.")
      .def_prop_ro(
          "degree", [](const T& of) { return of.best.twist.degree(); }, "Of w.")
      .def_prop_ro("coefficients", coefficients_of,
                   nb::sig("def coefficients(self) -> tuple[complex, ...]"),
                   "The Bernstein coefficients of w, as doubles next to them.")
      .def_prop_ro(
          "extra_turns",
          [](const T& of) {
            return to_python(without_gil([twist = of.best.twist] { return twist.extra_turns(); }));
          },
          nb::sig("def extra_turns(self) -> int"),
          "How many turns it makes beyond its share of the twist.")
      .def_prop_ro(
          "is_proved", [](const T& of) { return of.best.minimum.has_value(); },
          "Is it proved that no other w of this kind has a smaller root mean square, or none with "
          "this sign of γ where `other` has a smaller one?")
      .def_prop_ro(
          "doubt", [](const T& of) { return of.best.doubt; }, "Why not; else empty.")
      .def_prop_ro("other", other_of, nb::sig("def other(self) -> RationalTwistPiece | None"),
                   "The best with the other sign of γ, not proved, where it was looked for.")
      .def("__repr__", [](const T& of) {
        const RationalTwist& twist = of.best.twist;
        const auto short_text = [](const Real& x) { return round_to_decimal(x, 6).value; };
        return "<RationalTwistPiece of " + short_text(twist.piece().from) + " to " +
               short_text(twist.piece().to) + ", γ = " + short_text(twist.end_factor()) + ">";
      });
  bind_recipe(type);
}

}  // namespace

nb::object rational_twist(nb::handle self, const MinimalTwist& mtf, nb::handle degree,
                          bool has_free_ends, nb::handle subdivide, nb::handle gamma,
                          bool is_proved) {
  RationalTwistOptions options;
  options.degree = count(degree, "degree", 1, 8);
  options.rates = has_free_ends ? EndRates::free : EndRates::matched;
  options.prove = is_proved;
  if (options.degree == 1 && !has_free_ends)
    refuse("degree", "with degree 1 the rates at the ends are free: free_ends=True", degree);
  const Subdivision subdivision = subdivision_of(subdivide, mtf.path().end());
  std::optional<Rational> factor;
  if (!gamma.is_none()) {
    factor = rational(gamma, "gamma");
    if (*factor == 0) refuse("gamma", "w may not be 0 at the end", gamma);
    if (options.degree != 2 || has_free_ends || nb::len(subdivide) > 0)
      refuse("gamma", "it is of one piece, of degree 2 with the rates at the ends", gamma);
  }
  TwistFrame frame = without_gil([mtf, options, subdivision, factor] {
    if (!factor) return twist_frame(mtf, options, subdivision);
    TwistFrame given;
    for (const TwistPiece& piece : twist_pieces(mtf, {}))
      given.pieces.push_back(
          {twist_with_end_factor(piece, *factor), {}, "its γ is the one that was given", {}});
    return given;
  });
  return nb::cast(RationalTwistObject{
      mtf, std::move(frame),
      method_recipe(self, "rational", degree, nb::bool_(has_free_ends),
                    imported("phrame._pickle", "kept")(subdivide), gamma, nb::bool_(is_proved))});
}

void bind_rational_twist(nb::module_& m) {
  bind_piece(m);
  auto type = nb::class_<RationalTwistObject>(
      m, "RationalTwist", "A rational frame near to that of minimal twist: docs/minimal-twist.md.");
  using T = RationalTwistObject;
  type.def_prop_ro("pieces", pieces_of,
                   nb::sig("def pieces(self) -> tuple[RationalTwistPiece, ...]"),
                   "From the start of the path to its end, each with a w of its own.")
      .def_prop_ro(
          "rms",
          [](nb::handle self) {
            const auto& of = nb::cast<const T&>(self);
            return to_python(without_gil([mtf = of.mtf, frame = of.frame] {
                               return relative_error(root_mean_square(frame), mtf, mtf.length());
                             }),
                             attribute_recipe(self, "rms"));
          },
          nb::sig("def rms(self) -> fractions.Fraction | Real"),
          "The root mean square of Ω₁ − Ω̄₁ along the path, relative as that of a piece.")
      .def("__repr__", [](const T& of) {
        return "<RationalTwist of " + std::to_string(of.frame.pieces.size()) + " pieces>";
      });
  bind_value(type, "The angle to the Euler–Rodrigues frame; at a joint that of the later piece.",
             [](const T& self) {
               return [frame = self.frame](const Rational& t) { return value(frame, t); };
             });
  bind_recipe(type);
}

}  // namespace phrame::python
