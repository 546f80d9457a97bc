# The target qglviewer: libQGLViewer for Qt 6. One of the system where there is one; else built from its source, which
# is fetched once (scripts/fetch-qglviewer) or lies in MESECINA_QGLVIEWER_SOURCE.

find_path(QGLVIEWER_INCLUDE_DIR QGLViewer/qglviewer.h)
find_library(QGLVIEWER_LIBRARY NAMES QGLViewer-qt6)
mark_as_advanced(QGLVIEWER_INCLUDE_DIR QGLVIEWER_LIBRARY)
find_package(OpenGL REQUIRED COMPONENTS OpenGL)
find_package(Qt6 6.4 REQUIRED COMPONENTS Xml)
set(qglviewer_uses Qt6::Widgets Qt6::OpenGLWidgets Qt6::OpenGL Qt6::Xml OpenGL::GLU OpenGL::GL)

if(QGLVIEWER_INCLUDE_DIR AND QGLVIEWER_LIBRARY)
  add_library(qglviewer INTERFACE)
  target_include_directories(qglviewer SYSTEM INTERFACE ${QGLVIEWER_INCLUDE_DIR})
  target_link_libraries(qglviewer INTERFACE ${QGLVIEWER_LIBRARY} ${qglviewer_uses})
  return()
endif()

set(MESECINA_QGLVIEWER_SOURCE ${PROJECT_SOURCE_DIR}/build/libqglviewer CACHE PATH "The source of libQGLViewer")
execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/fetch-qglviewer ${MESECINA_QGLVIEWER_SOURCE}
                RESULT_VARIABLE qglviewer_result)
if(qglviewer_result)
  message(FATAL_ERROR "There is no libQGLViewer, which the window of mesecina3d needs. Without windows: -DMESECINA_GUI=OFF")
endif()

file(GLOB qglviewer_sources ${MESECINA_QGLVIEWER_SOURCE}/QGLViewer/*.cpp)
add_library(qglviewer STATIC ${qglviewer_sources} ${MESECINA_QGLVIEWER_SOURCE}/QGLViewer/ImageInterface.ui)
set_target_properties(qglviewer PROPERTIES AUTOMOC ON AUTOUIC ON)
# Its own snapshots and their vector graphics are not used; and what it warns of is not ours to mend.
target_compile_definitions(qglviewer PRIVATE NO_VECTORIAL_RENDER PUBLIC QGLVIEWER_STATIC)
target_compile_options(qglviewer PRIVATE -w)
target_include_directories(qglviewer SYSTEM PUBLIC ${MESECINA_QGLVIEWER_SOURCE})
target_link_libraries(qglviewer PUBLIC ${qglviewer_uses})
