# Arb, ball arithmetic: ARB_LIBRARIES, ARB_INCLUDE_DIR. A separate library (Debian's libflint-arb), or part of
# FLINT 3.
find_path(ARB_INCLUDE_DIR arb.h PATH_SUFFIXES flint)
find_library(ARB_LIBRARY NAMES flint-arb arb flint)
find_library(FLINT_LIBRARY flint)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb DEFAULT_MSG ARB_LIBRARY FLINT_LIBRARY ARB_INCLUDE_DIR)
set(ARB_LIBRARIES ${ARB_LIBRARY} ${FLINT_LIBRARY})
mark_as_advanced(ARB_INCLUDE_DIR ARB_LIBRARY FLINT_LIBRARY)
