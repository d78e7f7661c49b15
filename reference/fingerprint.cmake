# cmake -P: writes OUT, a hash of all sources of the room of reference (FOLDER) as a constant: the makers, and what
# runs them, compares their routes and rounds.
file(GLOB files "${FOLDER}/*.cpp" "${FOLDER}/*.hpp" "${FOLDER}/make/*.cpp" "${FOLDER}/make/*.hpp")
list(SORT files)
set(all "")
foreach(file IN LISTS files)
  file(SHA256 "${file}" hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 hash "${all}")
file(WRITE "${OUT}" "#include \"reference/truth.hpp\"\n\nconst std::string_view oddity::truth::fingerprint_of_makers = \"${hash}\";\n")
