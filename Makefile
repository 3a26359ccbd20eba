# A thin front for the README's commands; CMake does the work.
SHELL := /bin/bash
BUILD := build/release
JOBS := $(shell nproc)
SCENES := $(sort $(wildcard verification/cases/seed_column/*.toml))

.PHONY: report test build deps format clean

report: build  ## the main job: every scene of the seed paper's column -> out/index.html
	$(BUILD)/wetfront run $(SCENES)

test: build  ## the everyday tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE heavy

build: deps  ## release build -> build/release/wetfront
	@test -f $(BUILD)/build.ninja || cmake --preset release
	cmake --build $(BUILD)

deps:  ## install the missing Debian packages (.ci/packages.txt)
	@.ci/install-packages

format:  ## clang-format over the sources
	git ls-files '*.cpp' '*.h' | xargs clang-format -i

clean:
	rm -rf build
