# cmake -D SOURCE_DIR=… -D BUILD_DIR=… -D OUTPUT=… -D WANTED=… -P build_page.cmake
# Writes the source of page_template(), an empty one where the page cannot be bundled, or is not wanted; a file that
# is as it should be is not touched, so that nothing is compiled anew.
cmake_minimum_required(VERSION 3.25)

set(empty "#include \"phrame/io/write/page_template.hpp\"

namespace phrame::inline v0 {

const std::vector<std::string_view>& page_template() {
  static const std::vector<std::string_view> pieces;
  return pieces;
}

}  // namespace phrame
")

# Sets ${result} to what these files are.
function(digest result)
  set(all)
  foreach(file IN LISTS ARGN)
    file(SHA256 ${file} one)
    string(APPEND all "${one}\n")
  endforeach()
  string(SHA256 all "${all}")
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# Is that digest what was kept when it was last done?
function(is_done result file digest)
  set(known)
  if(EXISTS ${file})
    file(READ ${file} known)
  endif()
  string(COMPARE EQUAL "${known}" "${digest}" same)
  set(${result} ${same} PARENT_SCOPE)
endfunction()

function(without_page why)
  set(known)
  if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} known)
  endif()
  file(REMOVE ${BUILD_DIR}/bundled)
  if(NOT known STREQUAL empty)
    file(WRITE ${OUTPUT} "${empty}")
  elseif(NOT why MATCHES "^npm:")
    return()  # that was said when it was written
  endif()
  if(why)
    message("phrame page will not be there: ${why}")
  endif()
endfunction()

# Runs it in the build directory; sets complaint where it fails.
macro(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${BUILD_DIR}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    string(STRIP "${said}" said)
    string(REGEX REPLACE "\n.*" "" complaint "npm: ${said}")
  endif()
endmacro()

if(NOT WANTED)
  without_page("")
  return()
endif()
find_program(NPM npm)
find_program(NODE node)
if(NOT NPM OR NOT NODE)
  without_page("it needs npm")
  return()
endif()

set(packages ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json)
file(GLOB sources ${SOURCE_DIR}/*.mjs ${SOURCE_DIR}/src/*)
digest(of_packages ${packages})
digest(of_all ${packages} ${sources} ${CMAKE_CURRENT_LIST_FILE})
is_done(done ${BUILD_DIR}/bundled ${of_all})
if(done AND EXISTS ${OUTPUT})
  return()
endif()

# In the build directory: the sources' stays as it is.
file(COPY ${packages} ${SOURCE_DIR}/build.mjs ${SOURCE_DIR}/src DESTINATION ${BUILD_DIR})
set(complaint)
is_done(fetched ${BUILD_DIR}/fetched ${of_packages})
if(NOT fetched)
  file(REMOVE ${BUILD_DIR}/fetched)
  run(${NPM} ci --ignore-scripts --omit=dev --no-audit --no-fund --loglevel=error
    --fetch-retries=1 --fetch-timeout=30000)
endif()
if(NOT complaint)
  file(WRITE ${BUILD_DIR}/fetched ${of_packages})
  run(${NODE} build.mjs ${OUTPUT})
endif()
if(complaint)
  without_page("${complaint}")
else()
  file(WRITE ${BUILD_DIR}/bundled ${of_all})
endif()
