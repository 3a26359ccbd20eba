# `cmake --install`: the program, its pages of documentation and the cases, laid out as in the sources so that the links
# between pages hold. Headers are not installed: wetfront is a program.
if(TARGET wetfront)
  include(GNUInstallDirs)
  install(TARGETS wetfront RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS wetfront_mpm LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/wetfront)
  if(TARGET wetfront_mpm_v3)  # the loader takes it on machines that can
    install(TARGETS wetfront_mpm_v3 LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/wetfront/glibc-hwcaps/x86-64-v3)
  endif()
  file(RELATIVE_PATH wetfront_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/wetfront)
  # The link path too: Debian keeps PETSc outside the loader's own folders.
  set_target_properties(wetfront PROPERTIES INSTALL_RPATH "$ORIGIN/${wetfront_libraries}"
                                            INSTALL_RPATH_USE_LINK_PATH ON)

  set(wetfront_share ${CMAKE_INSTALL_DATADIR}/wetfront)
  foreach(page ${wetfront_pages} verification/scene/scene.schema.json README.md LICENSE CITATION.cff CHANGELOG.md)
    get_filename_component(folder ${page} DIRECTORY)
    install(FILES ${page} DESTINATION ${wetfront_share}/${folder})
  endforeach()
  install(DIRECTORY docs DESTINATION ${wetfront_share})
  install(DIRECTORY verification/cases DESTINATION ${wetfront_share}/verification)
endif()
