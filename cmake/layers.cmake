# A layer is a folder, a target and a set of public headers. Its target sees its own headers and those of the layers
# it links, and no others: the include path of each layer holds a link to its own header folder only, so that an
# include against the direction of the layers does not compile.

include(GNUInstallDirs)

add_library(quadmatch_flags INTERFACE)
target_compile_features(quadmatch_flags INTERFACE cxx_std_20)
if(QUADMATCH_DEVELOPER)
  target_compile_options(quadmatch_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                   -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
endif()

# quadmatch_layer(NAME SOURCES file... [DEPENDS layer...] [PRIVATE target...])
function(quadmatch_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 layer "" "" "SOURCES;DEPENDS;PRIVATE")
  set(headers ${CMAKE_BINARY_DIR}/layers/${name}/quadmatch)
  file(MAKE_DIRECTORY ${headers})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/include/quadmatch/${name} ${headers}/${name} SYMBOLIC)

  add_library(quadmatch_${name} STATIC ${layer_SOURCES})
  add_library(quadmatch::${name} ALIAS quadmatch_${name})
  target_compile_features(quadmatch_${name} PUBLIC cxx_std_20)
  target_include_directories(quadmatch_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/layers/${name}>
                                                      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                             PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(dependency IN LISTS layer_DEPENDS)
    target_link_libraries(quadmatch_${name} PUBLIC quadmatch::${dependency})
  endforeach()
  target_link_libraries(quadmatch_${name} PRIVATE $<BUILD_INTERFACE:quadmatch_flags>)
  # Of what a layer keeps to itself, only fmt has code that a user of the installed library links; the rest is headers.
  foreach(target IN LISTS layer_PRIVATE)
    if(NOT target STREQUAL fmt::fmt)
      set(target $<BUILD_INTERFACE:${target}>)
    endif()
    target_link_libraries(quadmatch_${name} PRIVATE ${target})
  endforeach()
  set_target_properties(quadmatch_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()
