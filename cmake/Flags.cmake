# One INTERFACE target carries the flags of every library, program and test.
add_library(autocuts_flags INTERFACE)
add_library(Autocuts::Flags ALIAS autocuts_flags)

# No contraction into fused multiply-adds: the same sum gives the same bits on every machine, and the overlap
# tests rely on exact zeros for shared edges.
if(MSVC)
  target_compile_options(autocuts_flags INTERFACE /W4 /fp:precise /utf-8 /permissive- /bigobj /EHsc)
  target_compile_definitions(autocuts_flags INTERFACE NOMINMAX WIN32_LEAN_AND_MEAN _USE_MATH_DEFINES)
else()
  target_compile_options(autocuts_flags INTERFACE
    -Wall -Wextra -Wpedantic
    # A unity build compiles several sources as one file: GCC would warn of a local name that hides a name of
    # another source.
    $<IF:$<BOOL:${AUTOCUTS_UNITY}>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>
    -ffp-contract=off)
endif()
if(AUTOCUTS_WERROR)
  target_compile_options(autocuts_flags INTERFACE $<IF:$<BOOL:${MSVC}>,/WX,-Werror>)
endif()
target_compile_definitions(autocuts_flags INTERFACE
  QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING
  QT_NO_CAST_FROM_BYTEARRAY QT_NO_FOREACH QT_NO_KEYWORDS
  QT_DISABLE_DEPRECATED_BEFORE=0x060400)
if(AUTOCUTS_TUNABLE)
  target_compile_definitions(autocuts_flags INTERFACE AUTOCUTS_TUNABLE)
endif()
if(AUTOCUTS_SANITIZE)
  target_compile_definitions(autocuts_flags INTERFACE AUTOCUTS_SANITIZED)
  target_compile_options(autocuts_flags INTERFACE -fsanitize=${AUTOCUTS_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(autocuts_flags INTERFACE -fsanitize=${AUTOCUTS_SANITIZE})
endif()
