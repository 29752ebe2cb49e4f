#include "arguments.hpp"

namespace phrame::inline v0::python {

std::string text(nb::handle x, const std::string& place) {
  if (PyUnicode_Check(x.ptr()) == 0) refuse_type(place, "a str", x);
  Py_ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(x.ptr(), &size);
  if (bytes == nullptr) {
    if (PyErr_ExceptionMatches(PyExc_MemoryError) != 0) throw nb::python_error();
    PyErr_Clear();
    refuse(place, "it has half of a character", x);
  }
  return {bytes, static_cast<std::size_t>(size)};
}

bool flag(nb::handle x, const std::string& place) {
  if (x.ptr() == Py_True) return true;
  if (x.ptr() == Py_False) return false;
  const nb::handle type = x.type();
  const auto name = nb::cast<std::string>(type.attr("__name__"));
  if (name != "bool" && name != "bool_") refuse_type(place, "True or False", x);  // NumPy's
  return PyObject_IsTrue(x.ptr()) != 0;
}

nb::object file_name(nb::handle x, const std::string& place) {
  if (PyUnicode_Check(x.ptr()) == 0 && PyBytes_Check(x.ptr()) == 0 && !nb::hasattr(x, "__fspath__"))
    refuse_type(place, "a str or os.PathLike", x);
  const nb::object name = nb::steal(PyOS_FSPath(x.ptr()));
  if (!name.is_valid()) throw nb::python_error();
  const nb::object decoded = imported("os", "fsdecode")(name);
  const auto characters = text(decoded, place);
  if (characters.empty()) refuse(place, "it is empty", x);
  if (characters.find('\0') != std::string::npos) refuse(place, "it has a null character", x);
  return decoded;
}

std::string bytes_of_file(nb::handle file, const std::string& place) {
  const nb::object opened = imported("builtins", "open")(file_name(file, place), "rb");
  const nb::object bytes = opened.attr("read")();
  opened.attr("close")();
  return {PyBytes_AsString(bytes.ptr()), static_cast<std::size_t>(PyBytes_Size(bytes.ptr()))};
}

void write_file(nb::handle file, const std::string& place, const std::string& bytes) {
  const nb::object opened = imported("builtins", "open")(file_name(file, place), "wb");
  opened.attr("write")(nb::bytes(bytes.data(), bytes.size()));
  opened.attr("close")();
}

}  // namespace phrame::python
