#include "numbers.hpp"

namespace phrame::inline v0::python {
namespace {

/// The exceptions of the library as those of phrame._errors.
void translate(const std::exception_ptr& thrown, void*) {
  const auto raise = [](const char* name, const char* message, const std::string& place,
                        const std::string& reason) {
    const nb::object& type = imported("phrame._errors", name);
    const nb::object error = type(readable(message), nb::arg("place") = readable(place),
                                  nb::arg("reason") = readable(reason));
    PyErr_SetObject(type.ptr(), error.ptr());
  };
  try {
    std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise("InputError", error.what(), error.place(), error.reason());
  } catch (const ArgumentError& error) {
    const std::string reason = error.what();
    const bool is_named = reason.starts_with(error.place + " ");  // "t = 5 is outside [0, 4]"
    raise("DomainError", (is_named ? reason : error.place + ": " + reason).c_str(), error.place,
          reason);
  } catch (const DomainError& error) {
    raise("DomainError", error.what(), "", error.what());
  } catch (const Undecided& error) {
    raise("Undecided", error.what(), "", error.what());
  } catch (const Error& error) {
    raise("Error", error.what(), "", error.what());
  } catch (const Stopped&) {
    const std::string reason = "no answer within the time of set_time_limit()";
    raise("Undecided", reason.c_str(), "", reason);
  }
}

}  // namespace
}  // namespace phrame::python

NB_MODULE(_phrame, m) {
  using namespace phrame::python;
  phrame::throw_when_out_of_memory();  // MemoryError, not the end of the session
  m.doc() = "The library phrame: exact rotation-minimizing frames of Pythagorean-hodograph curves.";
  // Other packages keep objects until the end, too: only python -X dev tells of them.
  nb::set_leak_warnings(nb::cast<bool>(nb::module_::import_("sys").attr("flags").attr("dev_mode")));
  m.attr("version") = phrame::version.data();
  nb::register_exception_translator(translate);
  m.def("_modified",
        [](nb::handle type) { PyType_Modified(reinterpret_cast<PyTypeObject*>(type.ptr())); });
  bind_numbers(m);
  bind_paths(m);
}
