# cmake -P: writes OUT, a C++ file with the texts of files as a constant. The function NAME, declared in HEADER,
# returns them. The files are FILES, paths within one of SOURCES, both separated by commas. Unless ALONE, they are
# followed by the project's files that they include.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" files "${FILES}")
string(REPLACE "," ";" sources "${SOURCES}")
set(entries "")
set(seen "")
while(files)
  list(POP_FRONT files file)
  if(file IN_LIST seen)
    continue()
  endif()
  list(APPEND seen "${file}")
  foreach(source IN LISTS sources)
    if(EXISTS "${source}/${file}")
      file(READ "${source}/${file}" text)
      break()
    endif()
  endforeach()
  set(includes "")
  if(NOT ALONE)
    string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  endif()
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" include "${include}")
    list(APPEND files "${include}")
  endforeach()
  # In pieces, as compilers have limits.
  set(literal "")
  while(NOT text STREQUAL "")
    string(SUBSTRING "${text}" 0 4000 piece)
    string(LENGTH "${piece}" length)
    string(SUBSTRING "${text}" ${length} -1 text)
    string(APPEND literal "\n    R\"oddity(${piece})oddity\"")
  endwhile()
  string(APPEND entries "   {\"${file}\",${literal}},\n")
endwhile()
file(WRITE "${OUT}" "#include \"${HEADER}\"

namespace oddity {

std::span<const EmbeddedFile> ${NAME}() {
  static constexpr EmbeddedFile files[] = {
${entries}  };
  return files;
}

}  // namespace oddity
")
