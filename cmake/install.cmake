# What `cmake --install` puts where, for the program in the plane.
include(GNUInstallDirs)

install(TARGETS mesecina2d RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES resources/org.mesecina.mesecina2d.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES resources/org.mesecina.mesecina2d.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES resources/icons/org.mesecina.mesecina2d.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(
  DIRECTORY resources/examples/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/mesecina/examples
  FILES_MATCHING
  PATTERN "*.wkt"
  PATTERN "*.xy"
  PATTERN "README.md")
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
