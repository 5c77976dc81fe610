# Makes a C++ source of text files: cmake -DOUT=FILE "-DTEXTS=FILE;…" -P embed.cmake
string(CONCAT source "// Made by embed.cmake of managers/motion/pages/*.txt.\n#include \"managers/motion/pages/own_pages.hpp\"\n\n"
  "namespace darwinop::motion {\nnamespace {\n\nconstexpr OwnText kTexts[] = {\n")
foreach(path IN LISTS TEXTS)
  get_filename_component(name "${path}" NAME)
  file(READ "${path}" content)
  string(FIND "${content}" ")own\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${path}: )own\" must not stand in it")
  endif()
  string(APPEND source "    {\"${name}\", R\"own(${content})own\"},\n")
endforeach()
string(APPEND source "};\n\n}  // namespace\n\n"
  "std::span<const OwnText> ownTexts() {\n  return kTexts;\n}\n\n}  // namespace darwinop::motion\n")
file(WRITE "${OUT}" "${source}")
