# Run by crest_embed: writes OUT.h and OUT.cpp with the text of FILES (separated by |) below ROOT.
get_filename_component(HEADER ${OUT}.h NAME)
file(WRITE ${OUT}.h "#pragma once
#include <span>
#include <string_view>
namespace ${NAMESPACE} {
struct EmbeddedFile {
  std::string_view name, text;
};
std::span<const EmbeddedFile> embedded_files();
}
")
set(TEXT "#include \"${HEADER}\"\nnamespace ${NAMESPACE} {\nnamespace {\n")
set(TABLE "")
set(INDEX 0)
string(REPLACE "|" ";" FILES "${FILES}")
foreach(FILE IN LISTS FILES)
  file(READ ${ROOT}/${FILE} HEX HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," BYTES "${HEX}")
  string(APPEND TEXT "constexpr char file_${INDEX}[] = {${BYTES}'\\0'};\n")
  string(APPEND TABLE "    {\"${FILE}\", {file_${INDEX}, sizeof file_${INDEX} - 1}},\n")
  math(EXPR INDEX "${INDEX} + 1")
endforeach()
if(TABLE STREQUAL "")
  set(BODY "}\nstd::span<const EmbeddedFile> embedded_files() { return {}; }\n}\n")
else()
  set(BODY "constexpr EmbeddedFile files[] = {\n${TABLE}};\n}\nstd::span<const EmbeddedFile> embedded_files() { return files; }\n}\n")
endif()
file(WRITE ${OUT}.cpp "${TEXT}${BODY}")
