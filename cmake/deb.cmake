# ./dev package: one Debian package of all that is installed. The library in it is static: before 1.0
# its interface changes with every version, and packages of their own for a shared library and its
# headers would serve nobody. So only the program's libraries are dependencies.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME phrame)
set(CPACK_PACKAGE_VENDOR "the phrame authors")
set(CPACK_PACKAGE_CONTACT "the phrame authors <phrame@localhost>")  # dpkg insists on an address; SECURITY.md has the way
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact rotation-minimizing frames of Pythagorean-hodograph curves")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what the program is linked with, in the versions of this system
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS python3)  # for check_certificate.py
string(JOIN ", " CPACK_DEBIAN_PACKAGE_SUGGESTS  # for programs that use the library
  g++ "cmake | pkgconf" libflint-dev "libflint-arb-dev | libflint-dev (>= 3)" libmpfr-dev libgmp-dev
  libboost-dev libfmt-dev libnlopt-dev)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Debian's copyright file, of LICENSE: its second paragraph says whose it is, the others what may be done.
file(READ LICENSE licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" copyright "${licence}")
set(copyright ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*${copyright}\n+" "" licence "${licence}")
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(STRIP "${licence}" licence)
string(REPLACE "\n" "\n " licence " ${licence}")
configure_file(cmake/copyright.in copyright @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(CPack)
