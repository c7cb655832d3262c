# The Verilated array: one shared library per size and mode beside rc2, rtl_n<N> ->
# rtl/librc2_rtl_n<N>.so with light in lanes, rtl_thesis_n<N> in thesis mode. Not part of `all`: a test or a run that needs a size depends on it, and every one shares it.
set(RC2_RTL_SIZES 2 3 4 5 8 16 32 CACHE STRING "Sizes with a target of their own")
set(RC2_RTL_EXTRA_SIZE "" CACHE STRING "One more size")
set(RC2_RTL_F 4 CACHE STRING "Fraction bits of the Verilated machines")

find_program(VERILATOR verilator REQUIRED)

# The RTL is read from here; scripts/mutation has a copy that it breaks.
set(RC2_RTL_FOLDER ${PROJECT_SOURCE_DIR}/rtl CACHE PATH "Folder of the RTL")
# A module comes after those it uses: package, parts, units, limits, column, cell, array, machine.
set(RC2_RTL_SOURCES ${RC2_RTL_FOLDER}/rc2_pkg.sv)
foreach(level parts load light lanes rays net)
  file(GLOB modules CONFIGURE_DEPENDS ${RC2_RTL_FOLDER}/${level}/*.sv)
  list(APPEND RC2_RTL_SOURCES ${modules})
endforeach()
foreach(module limits column voxels cell cell_thesis row grid grid_thesis array machine)
  list(APPEND RC2_RTL_SOURCES ${RC2_RTL_FOLDER}/rc2_${module}.sv)
endforeach()
set(RC2_VERILATED_GLUE ${PROJECT_SOURCE_DIR}/sim/verilated_machine.cpp
                       ${PROJECT_SOURCE_DIR}/sim/wave_list.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/feeder.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/checks.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/ray_job.cpp
                       ${PROJECT_SOURCE_DIR}/sw/machine/ray_words.cpp)
set(RC2_RTL_RULES ${RC2_RTL_FOLDER}/trace.vlt ${RC2_RTL_FOLDER}/rc2.vlt)

# What tests must have seen of the units (docs/coverage.md); costs little in a small array.
file(GLOB points CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tb/points/*.sv)
set(RC2_RTL_POINTS ${PROJECT_SOURCE_DIR}/tb/points/points.vlt ${points})
# What a build counts that is there to count (make coverage).
set(RC2_RTL_COUNTED)
set(RC2_RTL_TOGGLES)
if(RC2_COVERAGE)
  set(RC2_RTL_COUNTED --coverage-line)
  set(RC2_RTL_TOGGLES --coverage-toggle)
endif()

# What every Verilated array and unit is built with that can write waves, which cost nothing until they are
# switched on. Cells share what C++ is the same for all of them, function by function: so there are no
# data-flow graphs and no tables, for what Verilator finds in them differs from cell to cell, and functions
# are short. Files are long, for each reads the headers of all cells again.
set(RC2_VERILATOR_FLAGS -Wall -O3 -fno-dfg -fno-table --trace-fst --trace-structs
                        --output-split 80000 --output-split-cfuncs 1000)
# An assertion knows its place in the hierarchy, so that its function is not shared: only the small arrays
# have them, and the points.
set(RC2_ASSERTED_UP_TO 5)
# -O1: as fast as -O2 and quicker to build; the slow path runs once.
set(RC2_VERILATED_MAKE OPT_FAST=-O1 OPT_SLOW=-O0)
if(CCACHE)
  list(APPEND RC2_VERILATED_MAKE OBJCACHE=ccache)
endif()

# Verilator has a copy of every cell while it works, of one with rays 23 MB. From this size on they are Verilated
# by rows: one row once, as a library of which the array makes n calls. That is slower to run, and waves show no cells.
set(RC2_BY_ROWS_FROM 32 CACHE STRING "Smallest size of which arrays with rays are Verilated by rows")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/rtl/rows.vlt CONTENT [[
`verilator_config
hier_block -module "rc2_row"
clocker -module "rc2_row" -var "clk_i"
]] @ONLY)

# The rules without those that keep one body for all cells, for scripts/bench-rtl to compare with.
file(READ ${RC2_RTL_FOLDER}/rc2.vlt flat)
string(REGEX REPLACE "(no_inline|public_flat_rd)[^\n]*\n" "" flat "${flat}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/rtl/flat.vlt CONTENT "${flat}" @ONLY)

# rc2_add_rtl(NAME N [MACRO=VALUE ...]). A name flat_.. has a body for each cell.
function(rc2_add_rtl name n)
  list(TRANSFORM ARGN PREPEND -DRC2_ OUTPUT_VARIABLE defines)
  set(checks --noassert ${RC2_RTL_COUNTED})
  if(n LESS_EQUAL RC2_ASSERTED_UP_TO)
    set(checks --assert ${RC2_RTL_COUNTED} --coverage-user ${RC2_RTL_POINTS})
  endif()
  # Toggles take much code for each cell: the smallest array in lanes must do.
  set(make_words ${RC2_VERILATED_MAKE})
  if(RC2_COVERAGE AND name STREQUAL n4)
    list(APPEND checks ${RC2_RTL_TOGGLES})
    list(APPEND make_words OPT_FAST=-O0)
  endif()
  set(rules ${RC2_RTL_RULES})
  if(name MATCHES "^flat_")
    list(TRANSFORM rules REPLACE ".*/rc2.vlt" ${CMAKE_BINARY_DIR}/rtl/flat.vlt)
  endif()
  set(how)
  set(makefile Vrc2_machine.mk)
  if(name MATCHES "^rays_" AND n GREATER_EQUAL RC2_BY_ROWS_FROM)
    # To the array a row is one function of all that enters it: loops everywhere.
    set(how --hierarchical -Wno-UNOPTFLAT)
    set(makefile Vrc2_machine_hier.mk)
    list(PREPEND rules ${CMAKE_BINARY_DIR}/rtl/rows.vlt)
  endif()
  set(folder ${CMAKE_BINARY_DIR}/rtl/${name})
  set(library ${CMAKE_BINARY_DIR}/rtl/librc2_rtl_${name}.so)
  add_custom_command(
    OUTPUT ${library}
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
    COMMAND
      ${VERILATOR} --cc --exe ${RC2_VERILATOR_FLAGS} ${how} --x-assign fast --x-initial fast -DRC2_N=${n} ${defines}
      --top-module rc2_machine ${rules} ${RC2_RTL_SOURCES} ${checks} --Mdir ${folder} -o ${library}
      -CFLAGS "-std=c++17 -fPIC -I${PROJECT_SOURCE_DIR}" -LDFLAGS "-shared -lfmt"
      ${RC2_VERILATED_GLUE}
    COMMAND make --silent --no-print-directory -j2 -C ${folder} -f ${makefile} ${make_words} > ${folder}.log
    DEPENDS ${RC2_RTL_SOURCES} ${RC2_RTL_RULES} ${RC2_VERILATED_GLUE}
            ${PROJECT_SOURCE_DIR}/sw/machine/host_port.h ${PROJECT_SOURCE_DIR}/sw/machine/host_word.h ${PROJECT_SOURCE_DIR}/sw/machine/plane.h ${PROJECT_SOURCE_DIR}/sw/machine/readback.h
            ${PROJECT_SOURCE_DIR}/sim/coverage.h ${PROJECT_SOURCE_DIR}/sim/rtl_machine.h ${RC2_RTL_POINTS}
            ${PROJECT_SOURCE_DIR}/sim/queue_watch.h ${PROJECT_SOURCE_DIR}/sim/wave_list.h
            ${PROJECT_SOURCE_DIR}/sw/machine/machine.h ${PROJECT_SOURCE_DIR}/sw/machine/queue_history.h ${PROJECT_SOURCE_DIR}/sw/machine/claim.h
            ${PROJECT_SOURCE_DIR}/sw/machine/checks.h ${PROJECT_SOURCE_DIR}/sw/machine/feeder.h ${PROJECT_SOURCE_DIR}/sw/machine/word.h
            ${PROJECT_SOURCE_DIR}/sw/machine/ray_job.h ${PROJECT_SOURCE_DIR}/sw/machine/ray_words.h ${PROJECT_SOURCE_DIR}/sw/rays/format.h ${PROJECT_SOURCE_DIR}/sw/rays/ray.h
            ${PROJECT_SOURCE_DIR}/sw/base/config.h
            ${PROJECT_SOURCE_DIR}/sw/facet/packet.h
    COMMENT "Verilating the array ${name}"
    VERBATIM)
  add_custom_target(rtl_${name} DEPENDS ${library})
endfunction()

# n = 5 has room for the finest vertices, so that the whole range of f meets the RTL somewhere. The
# smallest have room for the largest L that `make stress` tries.
foreach(n IN LISTS RC2_RTL_SIZES RC2_RTL_EXTRA_SIZE)
  set(macros F=${RC2_RTL_F})
  if(n EQUAL 5)
    set(macros F=8)
  elseif(n LESS 4)
    math(EXPR far "8 * ${n}")
    set(macros F=8 LMAX=${far})
  endif()
  if(NOT TARGET rtl_n${n})
    rc2_add_rtl(n${n} ${n} ${macros})
    rc2_add_rtl(thesis_n${n} ${n} ${macros} THESIS=1)
  endif()
endforeach()
foreach(n IN ITEMS 8 16)
  rc2_add_rtl(flat_n${n} ${n} F=${RC2_RTL_F})
endforeach()
# With cells for rays, and vertices as fine as rays want them.
foreach(n IN LISTS RC2_RTL_SIZES RC2_RTL_EXTRA_SIZE)
  if(NOT TARGET rtl_rays_n${n})
    rc2_add_rtl(rays_n${n} ${n} F=6 RAYS=1)
  endif()
endforeach()
# As it would be built in silicon: nothing counts targets. And one that skips nothing.
rc2_add_rtl(lit_n8 8 F=${RC2_RTL_F} COUNTS=0)
rc2_add_rtl(whole_n4 4 F=${RC2_RTL_F} SKIPS=0)
