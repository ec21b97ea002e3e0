# Makes a Debian package of the target `programs`:
#   cmake --build --preset release --target programs && (cd build && cpack -G DEB)
# The package depends on the packages of the libraries that the programs link, found by dpkg-shlibdeps.

include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # otherwise the package would build the tests

install(PROGRAMS deploy/backup.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME slicefarm-backup)
install(PROGRAMS deploy/restore.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME slicefarm-restore)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME slicefarm)
set(CPACK_PACKAGE_CONTACT "the slicefarm project <slicefarm@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "slices meshes to G-code for print farms")
set(CPACK_PACKAGE_DESCRIPTION
    "The command line slices in one process or submits to a farm; a coordinator fans the layers of a job out over workers.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "ca-certificates, sqlite3")  # for webhooks; for slicefarm-backup
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
