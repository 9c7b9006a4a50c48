# SPDX-License-Identifier: GPL-3.0-or-later
# Shortcuts; the scripts themselves need no make.
.PHONY: demo test fuzz bench lint format clean

demo:
	tools/demo.sh

test:
	tools/test.sh

fuzz:
	tools/fuzz.sh

bench:
	tools/bench.sh

lint:
	tools/lint.sh

format:
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	rm -rf build
