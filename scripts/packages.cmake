# Debian packages: talus (programs, man pages, completion by shells), libtalus-dev (the solver as a library),
# python3-talus (the module) and talus-doc (the guide). Included with TALUS_PACKAGES; scripts/packages builds and tries them.
find_program(TALUS_HELP2MAN help2man REQUIRED)

# --- Completion and man pages, from the program -------------------------------------------------
set(made ${PROJECT_BINARY_DIR}/package)
file(MAKE_DIRECTORY ${made})
set(completions ${made}/talus.bash ${made}/_talus ${made}/talus.fish)
set(shells bash zsh fish)
foreach(shell file IN ZIP_LISTS shells completions)
  add_custom_command(OUTPUT ${file} COMMAND talus completion ${shell} > ${file} DEPENDS talus VERBATIM)
endforeach()
set(manual)
foreach(name talus talus-run talus-check talus-advise talus-calibrate talus-capacity talus-cell talus-completion talus-convert talus-fit
             talus-export talus-plot talus-snapshot talus-animate talus-study talus-sweep talus-sweep-plan talus-sweep-run talus-sweep-submit
             talus-sweep-status talus-sweep-collect talus-sweep-evaluate talus-list talus-new talus_serve talus_vtkhdf)
  string(REGEX REPLACE "-.*" "" program ${name})
  add_custom_command(OUTPUT ${made}/${name}.1
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/manual_page ${made}/${name}.1 ${TALUS_HELP2MAN} $<TARGET_FILE:${program}> ${PROJECT_VERSION}
            ${name}
    DEPENDS ${program} ${PROJECT_SOURCE_DIR}/scripts/manual_page VERBATIM)
  list(APPEND manual ${made}/${name}.1)
endforeach()
add_custom_target(talus_package_files ALL DEPENDS ${completions} ${manual})
install(FILES ${made}/talus.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME talus
        COMPONENT program)
install(FILES ${made}/_talus DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${made}/talus.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
set(packages talus libtalus-dev python3-talus talus-doc)
set(components program development python documentation)
foreach(package component IN ZIP_LISTS packages components)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright COMPONENT ${component})
endforeach()
# Made by scripts/guide, which scripts/packages calls.
install(DIRECTORY ${PROJECT_BINARY_DIR}/guide/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/talus-doc COMPONENT documentation OPTIONAL)

# --- The packages -------------------------------------------------------------------------------
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_CONTACT "The Talus project <talus@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME talus)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox, pandoc")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "talus-doc")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}\nThe programs talus, talus_serve, talus_vtkhdf and talus_report.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtalus-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libboost-dev (>= 1.74), libeigen3-dev (>= 3.4), libfmt-dev, libnlopt-dev, nlohmann-json3-dev, libtomlplusplus-dev, libpugixml-dev, libsleef-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION}\nHeaders and static libraries of the solver.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-talus)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The extension is of one version of Python.
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}\nThe module talus for Python.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME talus-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOCUMENTATION_DESCRIPTION "${PROJECT_DESCRIPTION}\nThe guide, the reference and the schemas.")
include(CPack)
