# Thin: each goal is a script, and the scripts install what is missing.
.PHONY: help verify verify-full test fuzz faults mutants interface nightly guide packages bench bench-discs bench-python format clean

help:  ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile

verify:  ## run every verification case and write build/report/verification.{pdf,html,md}
	@scripts/verify

verify-full:  ## the same with the full tier: timing charts of this machine as well
	@scripts/verify --full --reuse

test:  ## build everything and run the unit tests, layers and format
	@scripts/test

faults:  ## kill runs at 100 random times and compare what they continue to with undisturbed ones
	@scripts/faults

mutants:  ## compile small bugs into a copy of the solver and run the cases with each of them
	@scripts/mutants

interface:  ## make one option, field, column or member of the program wrong at a time and run the cases that start it
	@scripts/interface

nightly:  ## what is too long for every change: other builds, sanitizers, coverage, the next part of all mutants
	@scripts/nightly

fuzz:  ## mutated files for every reader, with the sanitizers; an hour (scripts/fuzz 1000 for less)
	@scripts/fuzz

guide:  ## build/guide/index.html and guide.pdf from README.md and docs/
	@scripts/guide

packages:  ## build/packages/*.deb: program, library, Python module and guide for Debian 12
	@scripts/packages

bench:  ## microseconds per step and work-precision tables
	@scripts/bench

bench-discs:  ## discs beside LAMMPS: nanoseconds a disc-step of both from the same start
	@scripts/bench discs

bench-python:  ## microseconds a step from Python, one step and many in a call
	@scripts/bench python

format:  ## format the C++ sources
	@scripts/format

clean:  ## remove everything built
	rm -rf build
