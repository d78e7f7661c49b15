// Catch2's implementation where it is a header only (version 2), and the unit tests' main function.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "tests/catch.hpp"

#include "tests/catch_main.hpp"

int run_catch(int argc, char** argv) { return Catch::Session().run(argc, argv); }
