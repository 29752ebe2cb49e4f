#include "phrame/io/write/failure.hpp"

#include <new>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/time_limit.hpp"

namespace phrame::inline v0 {

Failure current_failure() {
  try {
    throw;
  } catch (const InputError& error) {
    return {2, error.what()};
  } catch (const DomainError& error) {
    return {3, error.what()};
  } catch (const Undecided& error) {
    return {4, std::string("undecided: ") + error.what()};
  } catch (const Stopped&) {
    return {4, "undecided within the time limit"};
  } catch (const std::bad_alloc&) {
    return {4, "undecided: out of memory"};
  } catch (const std::exception& error) {
    return {4, std::string("internal error: ") + error.what()};
  }
}

}  // namespace phrame
