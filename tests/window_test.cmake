# mesecina_window_test(NAME SOURCES... LINK libraries... [ENVIRONMENT VAR=VALUE...]): a GoogleTest program that opens
# windows and needs OpenGL. The sources bring their own main.
# mesecina_window_run(NAME PROGRAM [VAR=VALUE...]): ctest runs such a program as one test under a virtual X server, and
# says "Skipped" where there is none.
include_guard()

find_program(MESECINA_XVFB_RUN xvfb-run)

function(mesecina_window_run name program)
  if(MESECINA_XVFB_RUN)
    add_test(NAME ${name} COMMAND ${MESECINA_XVFB_RUN} -a -s "-screen 0 1280x1024x24 -noreset" $<TARGET_FILE:${program}>)
  else()
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: xvfb-run is not installed")
  endif()
  set_tests_properties(
    ${name} PROPERTIES LABELS gl TIMEOUT 600 RESOURCE_LOCK virtual-display SKIP_REGULAR_EXPRESSION "skipped: xvfb-run is not installed"
                       ENVIRONMENT "QT_QPA_PLATFORM=xcb;LIBGL_ALWAYS_SOFTWARE=1;WAYLAND_DISPLAY=;${ARGN}")
endfunction()

function(mesecina_window_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;ENVIRONMENT" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE mesecina_options ${ARG_LINK} Qt6::Test GTest::gtest GTest::gmock)
  mesecina_window_run(${name} ${name} ${ARG_ENVIRONMENT})
endfunction()
