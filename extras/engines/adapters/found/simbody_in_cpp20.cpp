// Simbody 3.7: its headers are not C++20.
//
// Its headers do not compile as C++20. Its indices compare with int, long and more, and C++20 also considers
// each comparison with its sides exchanged, which fits equally well. C++17 compiles them.
//   g++ -std=c++20 -fsyntax-only -I/usr/include/simbody simbody_in_cpp20.cpp

#include <Simbody.h>
