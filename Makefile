# A thin front for the README's commands; CMake does the work.
SHELL := /bin/bash
BUILD := build/release
JOBS := $(shell nproc)
SCENES := $(sort $(wildcard verification/cases/seed_column/*.toml)) verification/cases/levee/scene.toml verification/cases/column_collapse/scene.toml \
	verification/cases/deforming_column/seepage.toml verification/cases/deforming_column/two_velocities_window.toml verification/cases/small_slope/scene.toml verification/cases/moriwaki_flume/scene.toml
STUDIED := verification/cases/seed_column/scene_3e-5.toml verification/cases/deforming_column/seepage.toml
FOREIGN := verification/cases/foreign_infiltration
SUITES := reference hydraulics hard mechanics

.PHONY: report test bench build program docs deps format clean

report: program  ## the main job: both solvers judged by their suites, the scenes compared, what they need and what accuracy costs -> out/index.html
	status=0; \
	for suite in $(SUITES); do $(BUILD)/wetfront verify $$suite || status=$$?; done; \
	$(BUILD)/wetfront run $(SCENES) || status=$$?; \
	for scene in $(STUDIED); do $(BUILD)/wetfront study effects $$scene --budget 5 || status=$$?; done; \
	$(BUILD)/wetfront study accuracy $(firstword $(STUDIED)) --budget 5 || status=$$?; \
	$(BUILD)/wetfront compare $(FOREIGN)/scene.toml $(FOREIGN)/anura3d.result || [ $$? = 4 ] || status=1; : "4: see its README"; \
	$(BUILD)/wetfront report out && exit $$status

test: build  ## the everyday tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE heavy

bench: $(BUILD)/build.ninja  ## speed of the kernels -> build/release/bench.json
	cmake --build $(BUILD) --target wetfront_bench
	$(BUILD)/wetfront_bench --benchmark_out=$(BUILD)/bench.json --benchmark_out_format=json

build: $(BUILD)/build.ninja  ## the program and its tests
	cmake --build $(BUILD)

program: $(BUILD)/build.ninja  ## the program alone -> build/release/wetfront
	cmake --build $(BUILD) --target wetfront

docs: $(BUILD)/build.ninja  ## the documentation as pages -> build/release/docs/index.html
	cmake --build $(BUILD) --target docs

$(BUILD)/build.ninja: | deps
	cmake --preset release

deps:  ## install the missing Debian packages (.ci/packages.txt)
	@.ci/install-packages

format:  ## clang-format over the sources
	git ls-files '*.cpp' '*.h' | xargs clang-format -i

clean:
	rm -rf build
