#include "phrame/cli/exchange.hpp"

namespace phrame::inline v0::cli {
namespace {

thread_local Exchange* current_exchange = nullptr;

}  // namespace

Exchange::Exchange() { current_exchange = this; }
Exchange::~Exchange() { current_exchange = nullptr; }
Exchange* Exchange::current() { return current_exchange; }

}  // namespace phrame::cli
