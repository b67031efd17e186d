# The German texts: resources/translations/*.ts become .qm files inside the library that draws the window. The .ts
# files are never written by the build; scripts/translations does that.
find_program(AUTOCUTS_LRELEASE NAMES lrelease lrelease6 lrelease-qt6 REQUIRED
  HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS} /usr/lib/qt6/bin
  DOC "Compiler of translations, of the Debian package qt6-l10n-tools")

# autocuts_add_translations(TARGET LANGUAGE...): adds the resources :/translations/autocuts_<language>.qm and, where
# Qt's own are installed, :/translations/qtbase_<language>.qm. The program names them by Q_INIT_RESOURCE(translations).
function(autocuts_add_translations target)
  set(entries)
  set(compiled)
  foreach(language IN LISTS ARGN)
    set(ts ${PROJECT_SOURCE_DIR}/resources/translations/autocuts_${language}.ts)
    set(qm ${CMAKE_CURRENT_BINARY_DIR}/autocuts_${language}.qm)
    add_custom_command(OUTPUT ${qm} COMMAND ${AUTOCUTS_LRELEASE} -silent ${ts} -qm ${qm} DEPENDS ${ts} VERBATIM)
    list(APPEND compiled ${qm})
    string(APPEND entries "    <file alias=\"autocuts_${language}.qm\">${qm}</file>\n")
    find_file(AUTOCUTS_QTBASE_${language} qtbase_${language}.qm NO_CMAKE_FIND_ROOT_PATH
      HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_TRANSLATIONS} /usr/share/qt6/translations)
    if(AUTOCUTS_QTBASE_${language})
      string(APPEND entries
        "    <file alias=\"qtbase_${language}.qm\">${AUTOCUTS_QTBASE_${language}}</file>\n")
    endif()
  endforeach()
  set(list ${CMAKE_CURRENT_BINARY_DIR}/translations.qrc)
  file(CONFIGURE OUTPUT ${list} CONTENT "<RCC>\n<qresource prefix=\"/translations\">\n${entries}</qresource>\n</RCC>\n")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/qrc_translations.cpp)
  add_custom_command(OUTPUT ${source} COMMAND Qt6::rcc --name translations --output ${source} ${list}
    DEPENDS ${compiled} ${list} VERBATIM)
  set_source_files_properties(${source} PROPERTIES SKIP_AUTOGEN ON SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE ${source})
endfunction()
