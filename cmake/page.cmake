# phrame_page(): what `phrame page` writes is made from page/ by npm's esbuild, with three.js and KaTeX of the
# versions in page/package-lock.json. Where there is no npm, or no network to fetch them from, phrame is built
# without it, and says so when a page is asked for. Who has neither gives the page_template.cpp of another build, as does
# a source distribution with one in page/.
# Programs that embed the library are asked for no npm.
set(default ${PROJECT_IS_TOP_LEVEL})
if(SKBUILD)
  set(default ON)
endif()
option(PHRAME_BUILD_PAGE "Bundle what phrame page needs (by npm)" ${default})
set(made ${PROJECT_SOURCE_DIR}/page/page_template.cpp)
if(NOT EXISTS ${made})
  set(made)
endif()
set(PHRAME_PAGE_TEMPLATE "${made}" CACHE FILEPATH "The page_template.cpp of another build (else by npm)")

# A target that is looked at in each build, and that does nothing where the page is there and as its sources are: so
# the page comes as soon as there is npm or a network, whatever ninja thinks of times.
function(phrame_page target)
  if(PHRAME_BUILD_PAGE AND PHRAME_PAGE_TEMPLATE)
    target_sources(${target} PRIVATE ${PHRAME_PAGE_TEMPLATE})
    set_source_files_properties(${PHRAME_PAGE_TEMPLATE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/page/page_template.cpp)
  set(command ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}/page -D BUILD_DIR=${PROJECT_BINARY_DIR}/page
    -D OUTPUT=${source} -D WANTED=${PHRAME_BUILD_PAGE} -P ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake)
  target_sources(${target} PRIVATE ${source})
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(NOT PHRAME_BUILD_PAGE)
    execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY)
    return()
  endif()
  add_custom_target(phrame_page VERBATIM COMMAND ${command} BYPRODUCTS ${source}
    COMMENT "Looking after the page")
  add_dependencies(${target} phrame_page)
endfunction()
