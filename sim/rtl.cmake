# The Verilated array: one shared library per size and mode beside rc2, rtl_n<N> ->
# rtl/librc2_rtl_n<N>.so with light in lanes, rtl_thesis_n<N> in thesis mode. Not part of `all`: a test or a run that needs a size depends on it, and every one shares it.
set(RC2_RTL_SIZES 4 5 8 16 32 CACHE STRING "Sizes with a target of their own")
set(RC2_RTL_EXTRA_SIZE "" CACHE STRING "One more size")
set(RC2_RTL_F 4 CACHE STRING "Fraction bits of the Verilated machines")

find_program(VERILATOR verilator REQUIRED)

# A module comes after those it uses: package, parts, units, column, cell, array, machine.
set(RC2_RTL_SOURCES ${PROJECT_SOURCE_DIR}/rtl/rc2_pkg.sv)
foreach(level parts load light lanes net)
  file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/${level}/*.sv)
  list(APPEND RC2_RTL_SOURCES ${modules})
endforeach()
foreach(module column voxels cell cell_thesis grid grid_thesis array machine)
  list(APPEND RC2_RTL_SOURCES ${PROJECT_SOURCE_DIR}/rtl/rc2_${module}.sv)
endforeach()
set(RC2_VERILATED_GLUE ${PROJECT_SOURCE_DIR}/sim/verilated_machine.cpp
                       ${PROJECT_SOURCE_DIR}/sim/wave_list.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/feeder.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/checks.cpp)
set(RC2_RTL_RULES ${PROJECT_SOURCE_DIR}/rtl/trace.vlt ${PROJECT_SOURCE_DIR}/rtl/rc2.vlt)

# -O1: as fast as -O2 and quicker to build; the slow path runs once. Waves cost nothing until they
# are switched on, so every library can write them. An assertion knows its place in the hierarchy
# and so gives each cell a body of its own: only the small arrays have them.
set(RC2_VERILATOR_FLAGS -Wall -O3 --x-assign fast --x-initial fast --trace-fst --trace-structs)
set(RC2_ASSERTED_UP_TO 5)
set(RC2_VERILATED_MAKE OPT_FAST=-O1 OPT_SLOW=-O0)
if(CCACHE)
  list(APPEND RC2_VERILATED_MAKE OBJCACHE=ccache)
endif()

# rc2_add_rtl(NAME N [MACRO=VALUE ...])
function(rc2_add_rtl name n)
  list(TRANSFORM ARGN PREPEND -DRC2_ OUTPUT_VARIABLE defines)
  set(assertions --noassert)
  if(n LESS_EQUAL RC2_ASSERTED_UP_TO)
    set(assertions --assert)
  endif()
  set(folder ${CMAKE_BINARY_DIR}/rtl/${name})
  set(library ${CMAKE_BINARY_DIR}/rtl/librc2_rtl_${name}.so)
  add_custom_command(
    OUTPUT ${library}
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
    COMMAND
      ${VERILATOR} --cc --exe ${RC2_VERILATOR_FLAGS} ${assertions} -DRC2_N=${n} ${defines}
      --top-module rc2_machine ${RC2_RTL_RULES} ${RC2_RTL_SOURCES} --Mdir ${folder} -o ${library}
      -CFLAGS "-std=c++17 -fPIC -I${PROJECT_SOURCE_DIR}" -LDFLAGS "-shared -lfmt"
      ${RC2_VERILATED_GLUE}
    COMMAND make --silent --no-print-directory -j2 -C ${folder} -f Vrc2_machine.mk ${RC2_VERILATED_MAKE} > ${folder}.log
    DEPENDS ${RC2_RTL_SOURCES} ${RC2_RTL_RULES} ${RC2_VERILATED_GLUE}
            ${PROJECT_SOURCE_DIR}/sw/machine/host_port.h ${PROJECT_SOURCE_DIR}/sw/machine/host_word.h ${PROJECT_SOURCE_DIR}/sw/machine/plane.h ${PROJECT_SOURCE_DIR}/sw/machine/readback.h
            ${PROJECT_SOURCE_DIR}/sim/rtl_machine.h
            ${PROJECT_SOURCE_DIR}/sim/wave_list.h ${PROJECT_SOURCE_DIR}/sim/queue_watch.h
            ${PROJECT_SOURCE_DIR}/sw/machine/machine.h ${PROJECT_SOURCE_DIR}/sw/machine/queue_history.h ${PROJECT_SOURCE_DIR}/sw/machine/claim.h
            ${PROJECT_SOURCE_DIR}/sw/machine/checks.h ${PROJECT_SOURCE_DIR}/sw/machine/feeder.h ${PROJECT_SOURCE_DIR}/sw/machine/word.h
            ${PROJECT_SOURCE_DIR}/sw/base/config.h
            ${PROJECT_SOURCE_DIR}/sw/facet/packet.h
    COMMENT "Verilating the array ${name}"
    VERBATIM)
  add_custom_target(rtl_${name} DEPENDS ${library})
endfunction()

# n = 5 has room for the finest vertices, so that the whole range of f meets the RTL somewhere, and
# skips nothing.
foreach(n IN LISTS RC2_RTL_SIZES RC2_RTL_EXTRA_SIZE)
  set(macros F=${RC2_RTL_F})
  if(n EQUAL 5)
    set(macros F=8 SKIPS=0)
  endif()
  if(NOT TARGET rtl_n${n})
    rc2_add_rtl(n${n} ${n} ${macros})
    rc2_add_rtl(thesis_n${n} ${n} ${macros} THESIS=1)
  endif()
endforeach()
# As it would be built in silicon: nothing counts targets.
rc2_add_rtl(lit_n8 8 F=${RC2_RTL_F} COUNTS=0)
