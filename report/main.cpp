#include "report/commands.hpp"

int main(int argc, char** argv) { return oddity::command_line(argc, argv); }
