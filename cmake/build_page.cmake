# cmake -D SOURCE_DIR=… -D BUILD_DIR=… -D OUTPUT=… -D NPM=… -D NODE=… -P build_page.cmake
# Writes the source of page_template(), an empty one where the page cannot be bundled; that one is so old that
# the next build tries again.
function(without_page why)
  if(why)
    message("phrame page will not be there: ${why}")
  endif()
  file(WRITE ${OUTPUT} "#include \"phrame/io/write/page_template.hpp\"

namespace phrame {

const std::vector<std::string_view>& page_template() {
  static const std::vector<std::string_view> pieces;
  return pieces;
}

}  // namespace phrame
")
endfunction()

if(NOT NPM)
  without_page("")
  return()
endif()

# In the build directory: the sources' stays as it is.
file(COPY ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json ${SOURCE_DIR}/build.mjs ${SOURCE_DIR}/src
  DESTINATION ${BUILD_DIR})
execute_process(
  COMMAND ${NPM} ci --ignore-scripts --omit=dev --no-audit --no-fund --loglevel=error
    --fetch-retries=1 --fetch-timeout=30000
  WORKING_DIRECTORY ${BUILD_DIR} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE complaint)
if(status EQUAL 0)
  execute_process(COMMAND ${NODE} build.mjs ${OUTPUT}
    WORKING_DIRECTORY ${BUILD_DIR} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE complaint)
endif()
if(NOT status EQUAL 0)
  string(STRIP "${complaint}" complaint)
  string(REGEX REPLACE "\n.*" "" complaint "${complaint}")
  without_page("npm: ${complaint}")
  execute_process(COMMAND touch -d 2000-01-01 ${OUTPUT})
endif()
