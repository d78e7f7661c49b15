#include "tests/catch_main.hpp"

int main(int argc, char** argv) { return run_catch(argc, argv); }
