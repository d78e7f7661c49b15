#pragma once

int run_catch(int argc, char** argv);
