// Simbody 3.7: its headers are not C++20.
//
// Its headers do not compile as C++20: its indices compare with int, long and more, and what C++20 adds,
// the same with their sides exchanged, fits no worse. C++17 compiles it.
//   g++ -std=c++20 -fsyntax-only -I/usr/include/simbody simbody_in_cpp20.cpp

#include <Simbody.h>
