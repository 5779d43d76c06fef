# make demo    run a control program in a world and plot its path
# make test    run the full test suite (WORKERS=3: one more than there are cores)
# make check   check style, types and layers, and run the quick tests; under a minute
# make times   run all tests and record how long they take, to choose the quick ones
# make fuzz    compare random programs with gcc -m32 (COUNT=500 SEED=1), with csmith's if installed
# make fuzz-frontend  damage programs and nest all constructs: rejected or compiled, nothing else
# make bench   run the benchmarks
# make experiments  repeat the experiments with swarms, and renew their results for docs/swarms.md
# make docs    write the generated pages of docs/ from docs/templates and the code
# make site    write the documentation as a site with search to build/site; no broken links

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
# The workers end together: the first to be done takes tests from the others.
PYTEST := $(BIN)/python -m pytest --dist worksteal
# One more than two cores: some tests wait. In quick runs, mypy keeps the cores busy as well.
WORKERS ?= 3
COUNT ?= 500
SEED ?= 1

# Tests start Python hundreds of times: to read all modules anew each time takes much longer.
unexport PYTHONDONTWRITEBYTECODE

# Installs the package, with extras $(1), once for each content of pyproject.toml.
define install
@cmp -s pyproject.toml '$(VENV)/installed$(1)' || { \
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
		echo "crs_cc needs Python 3.11 or newer, and $(PYTHON) is not." >&2; \
		echo "Name another one: make $(or $(MAKECMDGOALS),demo) PYTHON=/path/to/python3.11" >&2; exit 1; }; \
	[ -x $(BIN)/python ] || $(PYTHON) -m venv $(VENV) || { \
		echo "$(PYTHON) cannot make a virtual environment" \
			"(on Debian and Ubuntu: apt install python3-venv)." >&2; exit 1; }; \
	echo "installing crs_cc$(1) into $(VENV) ..."; \
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.$(1)' \
		&& for extras in '' '$(1)'; do cp pyproject.toml "$(VENV)/installed$$extras"; done; }
endef

.PHONY: demo test check times fuzz fuzz-frontend bench experiments docs site install install-dev clean

demo: install
	$(BIN)/crs run samples/scout_c/wander.c worlds/room.xml --max-time 60 --plot demo.svg --summary
	@echo "The robot's path is drawn in demo.svg."

test: install-dev
	$(PYTEST) -n $(WORKERS)

# mypy and the tests share the cores; what mypy says comes after the tests.
check: install-dev
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	@log=$$(mktemp); echo "mypy"; $(BIN)/python -m tests.check_types >"$$log" 2>&1 & types=$$!; \
	echo "$(PYTEST) -n 2 --quick"; $(PYTEST) -n 2 --quick; tests=$$?; \
	wait $$types; types=$$?; cat "$$log"; rm "$$log"; [ $$types = 0 ] && [ $$tests = 0 ]

times: install-dev
	$(PYTEST) -n 2 --update-times

fuzz: install-dev
	$(BIN)/python -m tests.fuzz --count $(COUNT) --seed $(SEED)

fuzz-frontend: install-dev
	$(BIN)/python -m tests.frontend.fuzzing $(COUNT) $(SEED)

bench: install
	@set -e; for script in bench/builder.py bench/c_speed.py bench/compile.py bench/debug.py \
			bench/environment.py bench/fields.py bench/fleet.py bench/hosts.py \
			bench/messages.py bench/planted.py bench/python_env.py bench/quiet_time.py \
			bench/ranges.py bench/record.py bench/requests.py bench/start.py \
			bench/sweep.py bench/wander.py bench/workbench.py; do \
		echo "== $$script"; $(BIN)/python $$script; done

experiments:
	$(call install,[analysis])
	$(BIN)/python samples/swarm/renew.py

docs: install
	$(BIN)/python -m docs.generate

site:
	$(call install,[docs])
	$(BIN)/python -m sphinx -W --keep-going -q -b html -c docs/site -d build/doctrees . build/site
	@echo "The first page is build/site/index.html."

install:
	$(call install,)

install-dev:
	$(call install,[dev])

clean:
	rm -rf $(VENV) build *.egg-info .mypy_cache .pytest_cache .ruff_cache demo.svg
