#include "report/cli/commands.hpp"
#include "report/verify/verify.hpp"

int main(int argc, char** argv) { return oddity::command_line(argc, argv, oddity::verify); }
