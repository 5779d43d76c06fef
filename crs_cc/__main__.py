"""`python -m crs_cc` is `crs`."""

import sys

from crs_cc.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
