#include "phrame/cli/ask.hpp"

#include "paths.hpp"

namespace phrame::inline v0::python {
namespace {

std::string ask(const std::string& line, nb::handle path) {
  std::optional<NamedPath> named;
  if (!path.is_none()) named = path_of(path).named;
  return without_gil([line, named] { return cli::ask(line, named); });
}

}  // namespace

void bind_ask(nb::module_& m) {
  m.def("_question_table", [] { return cli::question_table(); });
  m.def("_ask", ask, nb::arg("line"), nb::arg("path").none());
}

}  // namespace phrame::python
