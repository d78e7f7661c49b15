# What sweeps are the better for, and can do without: HDF5 for merged maps; and MPI, which is known to a library beside
# the program that is loaded under mpirun alone.

enable_language(C)  # which both are looked for with
find_optional(ODDITY_HDF5 HDF5 COMPONENTS C)
if(HDF5_FOUND)
  message(STATUS "HDF5 ${HDF5_VERSION}: sweeps are merged into its files")
  set_property(SOURCE report/sweep/hdf5.cpp APPEND PROPERTY COMPILE_DEFINITIONS ODDITY_HDF5)
  set_property(SOURCE report/sweep/hdf5.cpp APPEND PROPERTY INCLUDE_DIRECTORIES ${HDF5_C_INCLUDE_DIRS})
  set_property(SOURCE report/sweep/hdf5.cpp PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
  target_link_libraries(oddity_report PUBLIC ${HDF5_C_LIBRARIES})
else()
  message(STATUS "HDF5 not used: sweeps are merged into CSV")
endif()

find_optional(ODDITY_MPI MPI COMPONENTS C)
if(MPI_C_FOUND)
  message(STATUS "MPI ${MPI_C_VERSION}: sweeps are dealt out under mpirun")
  add_library(oddity_mpi MODULE report/sweep/mpi/deal.cpp)
  target_link_libraries(oddity_mpi PRIVATE oddity_options MPI::MPI_C)
  target_compile_definitions(oddity_mpi PRIVATE OMPI_SKIP_MPICXX)  # its bindings for C++, which are no more
  add_dependencies(oddity oddity_mpi)
  install(TARGETS oddity_mpi LIBRARY DESTINATION ${oddity_code})
else()
  message(STATUS "MPI not used: sweeps are dealt out by --shard")
endif()
