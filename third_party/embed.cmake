# crest_embed(TARGET NAMESPACE FILES...): puts text files into TARGET as
#   std::span<const crest::EmbeddedFile> NAMESPACE::embedded_files();
# declared in the generated header "NAMESPACE_embedded.h". A file's name is its path below the current folder.
set(CREST_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)
function(crest_embed TARGET NAMESPACE)
  set(FILES ${ARGN})
  set(OUT ${CMAKE_CURRENT_BINARY_DIR}/${NAMESPACE}_embedded)
  list(TRANSFORM FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE PATHS)
  list(JOIN FILES "|" JOINED)
  add_custom_command(
    OUTPUT ${OUT}.cpp ${OUT}.h
    COMMAND ${CMAKE_COMMAND} -DOUT=${OUT} -DNAMESPACE=${NAMESPACE} -DROOT=${CMAKE_CURRENT_SOURCE_DIR}
            "-DFILES=${JOINED}" -P ${CREST_EMBED_SCRIPT}
    DEPENDS ${PATHS} ${CREST_EMBED_SCRIPT}
    VERBATIM)
  target_sources(${TARGET} PRIVATE ${OUT}.cpp ${OUT}.h)
  target_include_directories(${TARGET} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
