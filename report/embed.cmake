# cmake -P: writes OUT, the texts of files as a constant, which the function NAME gives and the header of its
# declaration is HEADER: FILES (paths within one of SOURCES, both separated by commas) and, unless ALONE, what these
# include of the project.
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
