#include "phrame/cli/step_file.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <mutex>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/step_body.hpp"

namespace phrame::inline v0::cli {
namespace {

/// Beside the program, as it is installed and in a build.
std::filesystem::path step_library() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return (program.parent_path() / PHRAME_BIN_TO_LIB / "phrame" / "phrame_step.so")
      .lexically_normal();
}

StepWriter step_writer() {
  const std::filesystem::path path = step_library();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw InputError("--format", "\"step\" needs Open CASCADE, and this phrame was built without");
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw InputError("--format", std::string("\"step\" needs what is not there: ") + dlerror());
  void* function = dlsym(library, step_writer_name);
  if (function == nullptr) throw InputError("--format", path.string() + " is of another phrame");
  return reinterpret_cast<StepWriter>(function);
}

}  // namespace

std::string to_step(const RationalSweepAnswer& answer) {
  static const StepWriter write = step_writer();
  static std::mutex one_at_a_time;  // Open CASCADE's writer has a state
  const std::lock_guard lock(one_at_a_time);
  std::string bytes;
  std::string complaint;
  write(step_body(answer), bytes, complaint);
  if (!complaint.empty()) throw DomainError("step: " + complaint);
  return bytes;
}

}  // namespace phrame::cli
