#include "phrame/answer/page.hpp"

#include "phrame/cli/command.hpp"
#include "phrame/io/write/page.hpp"

namespace phrame::cli {
namespace {

struct PageOptions {
  CurveOptions curve;
  StartOptions start;
  UpOption up;
  long samples = 241;
};

PageAnswer page_of(const PageOptions& options, PageQuery query, const NamedPath& named) {
  options.up.refuse("; its angle is that to the Euler-Rodrigues frame");
  options.start.check(named.path);
  return answer(named, query);
}

PageAnswer page_of(const PageOptions& options, PageQuery query, const NamedSmoothPath& named) {
  const SmoothAngle angle = options.up.angle(named.path);
  options.start.check(angle);
  query.up = angle.up();
  return answer(named, query);
}

void run(const PageOptions& options) {
  if (!has_pages())
    throw InputError("page", "this phrame was built without npm, which bundles what a page needs");
  PageQuery query;
  query.samples = options.samples;
  query.start = options.start.given().value_or(FrameStart());
  const AnyPath path = options.curve.read_any_path();
  const auto found =
      std::visit([&](const auto& named) { return page_of(options, query, named); }, path);
  write_output(options.curve.output, to_page(found));
}

}  // namespace

void add_page(Program& program) {
  Command& command = program.add("page", "a page for a browser that shows a curve and its frames");
  const auto options = std::make_shared<PageOptions>();
  options->curve.add_to(command);
  command.add_number("--samples", options->samples, {3, 100'000},
                     "at least so many places along the curve (default 241)", "N");
  options->start.add_to(command, "e2", "default 0");
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.set_notes(
      "The page is one HTML file, which needs no network: the curve with its frames as ribbons,\n"
      "plots over t, the formula of the angle, its poles, what is decided by algebra, and numbers\n"
      "to take along. They are correctly rounded doubles, as phrame frames has them.\n"
      "Examples:\n"
      "  phrame page curve.json -o curve.html\n"
      "  phrame page spline.json --start-normal 0,0,1 -o spline.html");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
