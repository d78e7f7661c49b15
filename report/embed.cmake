# cmake -P: writes OUT, the texts of the headers that `oddity choose --code` prints, as a constant: FILES (paths
# within SOURCE, separated by commas) and what these include of the project.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" files "${FILES}")
set(entries "")
set(seen "")
while(files)
  list(POP_FRONT files file)
  if(file IN_LIST seen)
    continue()
  endif()
  list(APPEND seen "${file}")
  file(READ "${SOURCE}/${file}" text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
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
file(WRITE "${OUT}" "#include \"report/pages/code.hpp\"

namespace oddity {

std::span<const EmbeddedHeader> embedded_headers() {
  static constexpr EmbeddedHeader headers[] = {
${entries}  };
  return headers;
}

}  // namespace oddity
")
