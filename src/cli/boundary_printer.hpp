#pragma once
#include "phrame/answer/offset_drawing.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/nurbs.hpp"
#include "phrame/io/write/offset_page.hpp"
#include "phrame/io/write/svg.hpp"

namespace phrame::inline v0::cli {

/// --print and -o of offsets and of envelopes: a report, or the curves themselves.
template <class Answer>
class BoundaryPrinter {
 public:
  using Writer = std::string (*)(const Answer&);

  /// That of this name; `as_curves` writes curve files. Throws InputError for another name.
  BoundaryPrinter(const std::string& name, Writer as_curves)
      : print_(choose<Writer>("--print", name,
                              {{"text", to_text},
                               {"json", to_json},
                               {"latex", to_latex},
                               {"curve", as_curves},
                               {"nurbs", as_nurbs}})),
        as_curves_(as_curves) {}

  /// The curves go to that file, if there is one, by its ending or as they are printed, and a
  /// report, or curves without a file, to standard output.
  void write(const Answer& answer, const std::string& file, const TextLength& length) const {
    const bool is_curve = print_ == as_curves_ || print_ == as_nurbs;
    if (!file.empty()) {
      const std::string end = ending(file);
      write_output(file, end == "svg"                    ? write_svg(drawing(answer))
                         : end == "dxf"                  ? write_dxf(nurbs(answer))
                         : end == "html" || end == "htm" ? to_page(answer)
                         : is_curve                      ? print_(answer)
                                                         : as_curves_(answer));
    }
    if (file.empty() || !is_curve) length.write("-", print_(answer));
  }

 private:
  static std::string as_nurbs(const Answer& answer) { return write_nurbs(nurbs(answer)); }

  Writer print_;
  Writer as_curves_;
};

}  // namespace phrame::cli
