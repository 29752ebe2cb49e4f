#pragma once

namespace phrame::inline v0::cli {

/// All that main() does, once a process: reads the arguments, answers on stdout or into a file,
/// says on stderr what is wrong. Returns the exit status, which docs/exactness.md lists.
int run_program(int argc, char** argv);

}  // namespace phrame::cli
