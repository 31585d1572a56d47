"""Reads each given file in slang, the module of its name at the top; writes what it finds to the standard error."""

import sys
from pathlib import Path

from pyslang.driver import Driver

# Words of one width may differ in their sign: sums and bits are the same. Comparisons and widths may not.
WARNINGS = "-Weverything -Wno-sign-conversion -Wno-arith-op-mismatch -Wno-bitwise-op-mismatch"

for file in sys.argv[1:]:
    driver = Driver()
    driver.addStandardArgs()
    is_read = driver.parseCommandLine(f"slang {WARNINGS} --top {Path(file).stem} {file}")
    is_read = is_read and driver.processOptions() and driver.parseAllSources()
    if not (is_read and driver.runFullCompilation(quiet=True)):
        print(f"{file}: error: refused", file=sys.stderr)
print(f"read {len(sys.argv) - 1}")
