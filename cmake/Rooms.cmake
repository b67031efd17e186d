# A room of the house: a folder of sources with a library of its own, so that what does not use it is neither built
# nor linked again when it changes.
#
# autocuts_room(NAME FILES file... USES library... [PRIVATELY library...]): the library Autocuts::Name from the files of
# the folder NAME.
function(autocuts_room name)
  cmake_parse_arguments(room "" "" "FILES;USES;PRIVATELY" ${ARGN})
  list(TRANSFORM room_FILES PREPEND ${name}/)
  add_library(autocuts_${name} STATIC ${room_FILES})
  string(SUBSTRING ${name} 0 1 first)
  string(SUBSTRING ${name} 1 -1 rest)
  string(TOUPPER ${first} first)
  add_library(Autocuts::${first}${rest} ALIAS autocuts_${name})
  target_link_libraries(autocuts_${name} PUBLIC Autocuts::Flags ${room_USES} PRIVATE ${room_PRIVATELY})
endfunction()
