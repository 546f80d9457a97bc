# Helpers shared by all rooms.

add_library(mesecina_options INTERFACE)
target_compile_features(mesecina_options INTERFACE cxx_std_20)
target_include_directories(mesecina_options INTERFACE ${PROJECT_SOURCE_DIR})
# No contraction into fused multiply-adds: files are the same bytes on every machine, and error bounds of predicates hold.
target_compile_options(mesecina_options INTERFACE -Wall -Wextra -Wpedantic -ffp-contract=off)
if(MESECINA_JOIN)
  # What two sources name alike is no mistake: one may have a local name where another has one of its whole file.
  target_compile_options(mesecina_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
else()
  target_compile_options(mesecina_options INTERFACE -Wshadow)
endif()
if(MESECINA_STRICT)
  target_compile_options(mesecina_options INTERFACE -Werror)
endif()
if(MESECINA_SANITIZE)
  # Without what doubles the time to compile: checks of every pointer for null and alignment. Where such a pointer leads
  # to foreign memory, the address sanitizer tells. g++ 12 takes what they insert for uses of uninitialized variables.
  target_compile_options(
    mesecina_options INTERFACE -fsanitize=address,undefined -fno-sanitize=null,alignment,object-size
                               -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  target_link_options(mesecina_options INTERFACE -fsanitize=address,undefined)
endif()

# mesecina_library(NAME SOURCES... [LINK libraries...]): a static library of one room.
function(mesecina_library name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC mesecina_options ${ARG_LINK})
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_compile_definitions(${name} PRIVATE QT_NO_KEYWORDS QT_NO_CAST_TO_ASCII)
  endif()
endfunction()

# mesecina_alone(SOURCES...): sources that are not compiled together with others of their folder (joined_sources.cmake).
function(mesecina_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# mesecina_test(NAME LABEL label SOURCES... LINK libraries... [ENVIRONMENT VAR=VALUE] [TIMEOUT seconds]): a GoogleTest
# program, with one variable of its environment set (more do not survive the discovery of tests).
function(mesecina_test name)
  cmake_parse_arguments(ARG "QT" "LABEL;TIMEOUT" "SOURCES;LINK;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE mesecina_options ${ARG_LINK} GTest::gtest GTest::gmock)
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS "${ARG_LABEL}" ENVIRONMENT
                       "${ARG_ENVIRONMENT}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
