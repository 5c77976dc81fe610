# Makes a C++ source of files: cmake -DOUT=FILE "-DPARTS=kName=FILE;…" -P embed.cmake
# Other rooms add "-DHEADER=PATH/page_parts.hpp" and -DNAMESPACE=…, where these names are declared.
if(NOT DEFINED HEADER)
  set(HEADER experiments/logs/plot/page_parts.hpp)
  set(NAMESPACE darwinop::plot::page_parts)
endif()
set(text "// Made by embed.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\nnamespace {\n\n")
set(names "")
foreach(part IN LISTS PARTS)
  string(REGEX MATCH "^([^=]+)=(.+)$" ignored "${part}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${CMAKE_MATCH_2}" content)
  # Libraries end with the place of their source map: a page asks for no other file.
  string(FIND "${content}" "# sourceMappingURL=" end REVERSE)
  if(end GREATER 2)
    math(EXPR end "${end} - 2")  # the // or /* before it
    string(SUBSTRING "${content}" 0 ${end} content)
  endif()
  string(HEX "${content}" bytes)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND text "constexpr unsigned char ${name}Bytes[] = {\n${bytes}};\n")
  string(APPEND names
    "const std::string_view ${name}{reinterpret_cast<const char*>(${name}Bytes), sizeof ${name}Bytes};\n")
endforeach()
file(WRITE "${OUT}" "${text}\n}  // namespace\n\n${names}\n}  // namespace ${NAMESPACE}\n")
