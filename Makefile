## RC², a ray-tracing cellular machine:  make TARGET [WORD=value ...]
##
## Targets
##   help      this text, also what `make` alone prints
##   setup     installs what is missing on a Debian 12; every target below but clean does it first
##   build     the program, build/rc2 (try build/rc2 --help)
##   sim       lights scenes on the machine: pictures, waveforms and report.html under out/
##   thesis    the tables and snapshots of the thesis's own simulations, beside the printed ones
##   chapter2  the lines, tunnels and Boolean networks of thesis chapter 2, as the docs show them
##   chapter4  the ways that thesis 4.1 and 4.2 compare of finding out what a light reaches, as the docs
##             show them
##   chapter5  chapter 5's choices of normal, hit and owner against the continuous scene, as the docs
##             show them
##   bench-load  loading: cycles of real scenes, leaks, rounded coefficients, speed of the host, as
##             the docs show them
##   oracle    the voxels of 1,500,000 facets against exact arithmetic, as the docs show it
##   stress    adversarial scenes and files on all models against exact oracles, as the docs show it
##   fuzz      any scenes and command lines, steered by libFuzzer, SECONDS=60 each
##   netlist   the machine of 4 x 4 cells in gates, against its RTL with four states (Icarus)
##   bus       somebody else's AXI models (cocotbext-axi, from PyPI) on these gates
##   systemc   the SystemC test benches and the example TLM-2.0 platform, waveforms under out/systemc/
##   formal    proofs of the RTL's units and of a 2 x 2 array by Yosys, z3 and ABC, as the docs show them
##   bench-diffusion  light: cycles by scene, n, source and mode, as the docs show them
##   bench-rtl  how fast the Verilated array is built and runs, as the docs show it
##   bench-light  light: what differs from the continuous scene, by rule, as the docs show it
##   bench     run time against error, also of what one would take instead of the machine; at most 15
##             minutes, FULL=1 hours; goes on where it was interrupted
##   report    report/index.html: pictures, plots, tables, a 3D view and the wave of light on one page
##   bench-render  rendering: what rays and pictures differ from the continuous scene, as the docs show it
##   bench-rays  rendering: the cycles of cells and network, as the docs show them
##   area      what a cell costs: area, clock, area times time, FPGAs, energy of a light, as the docs show it
##   test      every test; the last line is their summary
##   coverage  lines, branches, toggles and functional points that the tests go through, RTL and C++:
##             out/coverage/index.html, and as the docs show it
##   mutation  whether the tests notice a mistake in the RTL, as the docs show it; FULL=1 tries all; goes on
##             where it was interrupted
##   lint      verilator -Wall, yosys on every module alone, clang-format, clang-tidy
##   sanitize  the software's tests with address and undefined-behaviour sanitizers
##   rtl       the Verilated array of side N, build/rtl/librc2_rtl_nN.so
##   format    lays out the C++ files as lint wants them
##   clean     removes the build folders, out and report
##
## Words for sim (N and MODE also for rtl)
##   MACHINE=rtl    rtl, cycle (cycle model) or golden (no notion of time)
##   N=16           cells per side; 128 on cycle and golden
##   SCENE=         a file that Assimp reads, or empty, room, gallery, ball:R, shells:PERCENT:SEED,
##                  dust:PERCENT:SEED; default: the room sw/scene/room.dae, then a duck
##   LIGHT=         x,y,z[,r,g,b] in voxels; several between quotes; default: the scene's lights
##   WAVES=on       on or off: waves.fst, of rtl only
##   RULE=          which voxels a facet fills: armoured, naive, supercover, half, blindee
##   F=             bits of fraction of a vertex
##   L=             distance of the virtual faces that the light aims at
##   FA=            beams that a cell has room for
##   MODE=fast      how light spreads: fast, in lanes; thesis, voxel by voxel (also for rtl)
##   OUT=out        folder of the results
##
##   A word left empty means the default of build/rc2 run --help. With MACHINE=rtl the same scene
##   is also lit by the cycle model with 128 cells per side, for a picture worth looking at.
##
## Words for others
##   FULL=1, SEED=1     bench: the large one, of generated scenes; mutation: all mutants, of the sample
##   SECONDS=60         fuzz: for each of its two programs
##
## Examples
##   make sim
##   make sim N=32 SCENE=/usr/share/assimp/models/OBJ/spider.obj WAVES=off
##   make sim MACHINE=cycle N=256 SCENE=room LIGHT="100,40,200 20,20,240,1,0.5,0"
##   RC2_SKIP_SETUP=1 make build        leaves the system's packages alone

sim_words := MACHINE N SCENE LIGHT WAVES RULE F L FA MODE OUT
the_words := $(sim_words) FULL SEED SECONDS

# Plain assignments: the environment cannot change a word, the command line can.
MACHINE := rtl
N := $(if $(filter rtl,$(MACHINE)),16,128)
SCENE :=
LIGHT :=
WAVES := $(if $(filter rtl,$(MACHINE)),on,off)
RULE :=
F :=
L :=
FA :=
MODE :=
OUT := out
FULL := 0
SEED := 1
SECONDS := 60

# A misspelt word must not pass for a default.
given := $(foreach word,$(MAKEOVERRIDES),$(if $(findstring =,$(word)),$(firstword $(subst =, ,$(word)))))
unknown := $(filter-out $(the_words) RC2_SKIP_SETUP,$(given))
$(if $(unknown),$(error no word $(unknown): `make help` lists them))
$(if $(filter-out 1,$(words $(MACHINE)))$(filter-out rtl cycle golden,$(MACHINE)),\
  $(error MACHINE=$(MACHINE): say rtl, cycle or golden))
$(if $(filter-out fast thesis,$(MODE)),$(error MODE=$(MODE): say fast or thesis))
$(if $(filter-out 1,$(words $(WAVES)))$(filter-out on off,$(WAVES)),\
  $(error WAVES=$(WAVES): say on or off))
$(if $(filter on,$(WAVES)),$(if $(filter rtl,$(MACHINE)),,\
  $(error WAVES=on: only MACHINE=rtl has signals to show)))
ifeq ($(origin N),command line)
$(if $(shell seq 2 1024 | grep -Fxe '$(N)'),,$(error N=$(N): say a whole number from 2 to 1024))
endif

# The words are passed on by name: nothing that make starts should meet a stray N, F or L.
MAKEOVERRIDES :=
unexport $(the_words)

jobs := $(shell nproc)
cmake_build := cmake --build build -j $(jobs) --target
test_sizes := 4 5 8 16
known_sizes := 2 3 $(test_sizes) 32

.PHONY: help setup build coverage mutation sim thesis chapter2 chapter4 chapter5 bench-load bench-diffusion bench-rtl bench-light bench-render bench-rays bench report area oracle stress fuzz netlist bus systemc formal test lint sanitize rtl format clean
.NOTPARALLEL:

help:
	@sed -n 's/^## \{0,1\}//p' Makefile

setup:
	@scripts/setup

# Ninja configures again by itself when a CMake file changes.
build/build.ninja: | setup
	cmake --log-level=NOTICE -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release

build-sanitize/build.ninja: | setup
	cmake --log-level=NOTICE -S . -B build-sanitize -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRC2_SANITIZE=ON

build-coverage/build.ninja: | setup
	cmake --log-level=NOTICE -S . -B build-coverage -G Ninja -DCMAKE_BUILD_TYPE=Release -DRC2_COVERAGE=ON '-DRC2_TESTED_ARRAYS=n4;thesis_n4;whole_n4;n5;thesis_n5;lit_n8'

build: build/build.ninja
	$(cmake_build) rc2

# A size that CMake does not know yet is named to it once.
rtl: build/build.ninja
	$(if $(filter $(N),$(known_sizes)),,@grep -qx 'RC2_RTL_EXTRA_SIZE:[A-Z]*=$(N)' build/CMakeCache.txt \
	  || cmake --log-level=NOTICE -DRC2_RTL_EXTRA_SIZE=$(N) build)
	$(cmake_build) rtl_$(if $(filter thesis,$(MODE)),thesis_)n$(N)

sim: build $(if $(filter rtl,$(MACHINE)),rtl)
	@scripts/sim $(foreach word,$(sim_words),'$(word)=$(subst ','\'',$($(word)))')

thesis: build
	@scripts/thesis '$(OUT)/thesis'

chapter2: build
	@scripts/chapter2 '$(OUT)/chapter2'

chapter4: build
	@scripts/chapter4 '$(OUT)/chapter4'

chapter5: build
	@scripts/chapter5 '$(OUT)/chapter5'

bench-load: build
	@scripts/bench-load '$(OUT)/bench-load'

area: build
	@scripts/setup area
	@scripts/area '$(OUT)/area'
	@scripts/energy '$(OUT)/energy' build
	@scripts/area-figures docs

oracle: build/build.ninja
	$(cmake_build) oracle_run
	@build/tb/load/oracle_run --facets 1500000

stress: build/build.ninja
	$(cmake_build) rc2 stress_run $(foreach n,2 3 4 5 8,rtl_n$(n) rtl_thesis_n$(n))
	@scripts/stress '$(OUT)/stress' 200

systemc: build/build.ninja
	$(cmake_build) rc2 rc2_platform systemc_cell systemc_machine systemc_machine_n8 rtl_n16
	@scripts/systemc '$(OUT)/systemc'

netlist: build/build.ninja
	@scripts/setup netlist
	$(cmake_build) systemc_machine
	@scripts/netlist '$(OUT)/netlist' 1

bus: netlist
	@scripts/setup bus
	@scripts/bus '$(OUT)/bus' '$(OUT)/netlist'

build-fuzz/build.ninja: | setup
	@scripts/setup fuzz
	cmake --log-level=NOTICE -S . -B build-fuzz -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRC2_FUZZ=ON \
	  -DCMAKE_CXX_COMPILER=clang++-14

fuzz: build-fuzz/build.ninja
	cmake --build build-fuzz -j $(jobs) --target fuzz_scene fuzz_program
	@scripts/fuzz '$(OUT)/fuzz' '$(SECONDS)'

formal: setup
	@scripts/formal '$(OUT)/formal'
	@cp '$(OUT)/formal/table.md' docs/proofs-table.md

bench-diffusion: build
	@scripts/bench-diffusion '$(OUT)/bench-diffusion'

bench-rtl: build
	@scripts/bench-rtl '$(OUT)/bench-rtl'

bench-light: build
	@scripts/bench-light '$(OUT)/bench-light'

bench: build/build.ninja
	@scripts/setup bench
	$(cmake_build) rc2 rtl_n16
	@scripts/bench/run '$(OUT)/bench' '$(SEED)' '$(FULL)'

report: build
	@scripts/setup report
	@scripts/report/build '$(OUT)/report' '$(OUT)/bench' report/index.html
	@scripts/report/check report/index.html

bench-render: build
	@scripts/bench-render '$(OUT)/bench-render'

bench-rays: build
	@scripts/bench-rays '$(OUT)/bench-rays'

test: build/build.ninja
	$(cmake_build) all $(test_sizes:%=rtl_n%) $(test_sizes:%=rtl_thesis_n%)
	@scripts/test build

coverage: build-coverage/build.ninja
	@scripts/setup coverage
	cmake --build build-coverage -j $(jobs) --target tb/unit/all tb/load/all tb/rtl/all systemc_cell systemc_machine
	@scripts/coverage build-coverage '$(OUT)/coverage'

mutation: setup
	@scripts/mutation '$(OUT)/mutation' --seed '$(SEED)' --mutants $(if $(filter 1,$(FULL)),0,40)

# clang-tidy reads headers that the build generates.
lint: build/build.ninja
	$(cmake_build) all
	@scripts/lint

sanitize: build-sanitize/build.ninja
	cmake --build build-sanitize -j $(jobs)
	@LSAN_OPTIONS=suppressions=$(CURDIR)/scripts/lsan.supp:print_suppressions=0 \
	  scripts/test build-sanitize

format: setup
	find sw sim tb -name '*.h' -o -name '*.cpp' | xargs -r clang-format -i

clean:
	rm -rf build build-coverage build-fuzz build-mutation build-sanitize out report .snakemake
